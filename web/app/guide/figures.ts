/** The paper's figures as states of the app: what each figure shows in the paper and here, and the differences. */
import { MotionError } from '../../study/motion-error.ts';
import type { GuidePage } from './guide-page.ts';

interface Figure extends Omit<GuidePage, 'link' | 'title'> {
  number: string;
  name: string;
}

/** The playground with as many values as Fig. 2a of the paper, and its three curves. */
const NINE_POINTS = `keys=${[0.3, 0.55, 0.35, 0.8, 0.6, 0.9, 0.45, 0.5, 0.2]
  .map((value, i) => `${i / 8},${value},0`)
  .join('+')}&show=linear+natural+samples&samples=60&key=5`;

/** The pose of the cactus that is not a key of Fig. 3. */
const MIDDLE = 1;
const middleOf: GuidePage['ask'] = async (sequence, { keyTimes }, poses) => {
  const error = new MotionError(poses.info.report.diagonal);
  const [frame] = await sequence.evaluateMany([(keyTimes[0]! + keyTimes.at(-1)!) / 2]);
  error.add(poses.positions(MIDDLE), frame!.positions);
  frame!.release();
  return `Halfway, vertices are on average ${error.mean.toFixed(1)} % of the model’s size from the middle pose.`;
};

const LIST: readonly Figure[] = [
  {
    number: '1',
    name: 'Geodesics and a spline',
    state: 'sample=cactus&compare=geodesic,shell&colour=phase&film=1&between=-0.2,1.2&t=0.5&loop=bounce',
    panel: 'analysis',
    part: 'plot-plane',
    plot: 'plane',
    text: 'The paper completes three poses of a cactus by geodesics, by a spline in shell space and by its own spline, which also goes beyond the keys. Beside them it draws curves in shape space.',
    task: 'Compare the rows, then the curves in Analysis: the geodesic turns sharply at the middle key, the spline does not. To see the shapes move, clear Film strip in Display.',
    sentence:
      'As in the paper, there are three rows with the keys in blue, on a different cactus. The two splines hardly differ, and their curves in the plane coincide.',
  },
  {
    number: '2a',
    name: 'Curves through points',
    state: 'sample=cactus&between=0,1&t=0&loop=bounce&play=1',
    panel: 'analysis',
    text: 'The paper draws three curves through nine values: the curve that bends least (found by direct minimisation), the cubic spline, and straight lines.',
    task: 'Drag a point in the playground. It has nine points and these three curves.',
    sentence: 'As in the paper, the two curves coincide. Drag the points to try other values.',
    beside: { label: 'Open the playground', href: `./play.html#${NINE_POINTS}`, framed: 'Playground' },
    wide: true,
  },
  {
    number: '2b',
    name: 'Curves through shapes',
    state: 'sample=octopus&compare=geodesic,linear&between=0,1.5&t=0&loop=bounce&play=1',
    panel: 'analysis',
    text: 'The paper draws three motions through four shapes in the plane of their two leading components: global minimisation, the spline and linear interpolation in shape space.',
    part: 'plot-plane',
    plot: 'plane',
    wide: true,
    press: 'minimised',
    task: 'Enlarge the shape plane in Analysis, and change the number of samples of the minimiser.',
    sentence:
      'As in the paper, the minimiser coincides with the spline. Motions of other spaces are drawn as well, with their distance from the plane.',
  },
  {
    number: '3',
    name: 'Natural and Hermite ends',
    state:
      'sample=cactus&keys=0@0,2@1&boundary=hermite&startTangentPose=1&endTangentPose=1&startSpeed=3&endSpeed=3&between=-0.2,1.2&t=0&loop=bounce&play=1',
    panel: 'motion',
    text: 'The paper interpolates two poses with natural ends, and with Hermite ends whose tangents are taken from the sequence of Fig. 1.',
    task: 'Switch between Free and Ease, and watch the path between the two keys.',
    ask: middleOf,
    sentence:
      'With two keys, the natural spline is the geodesic. Tangents towards the middle pose bend it; at speed 3 it nearly reproduces Fig. 1.',
  },
  {
    number: '4',
    name: 'Two poses only',
    state: 'sample=cactus&keys=0@0,1@1&compare=geodesic&colour=phase&between=-0.5,1.5&t=-0.5&loop=bounce&play=1',
    text: 'The paper compares its spline with the geodesic on two poses of an elephant, including extrapolation.',
    task: 'Drag the time slider: both methods give the same shape at every time.',
    sentence: 'With two keys, the spline is the geodesic. This page shows both on a cactus.',
  },
  {
    number: '5',
    name: 'Large rotations',
    state: 'sample=gymnast&between=0,1&t=0&loop=bounce&play=1',
    text: 'The paper completes five poses of a person, the first and last of which are rotated by almost 180 degrees.',
    task: 'Watch the arms. Each rotates by more than 180 degrees from the first pose to the last, and neither takes the shorter way back.',
    sentence:
      'Rotations accumulate from key to key, so an arm can rotate by more than 180 degrees. No single rotation can express this.',
  },
  {
    number: '6',
    name: 'Ghost meshes',
    state: 'sample=cactus&ghostFaces=500&ghostWire=1&ghostBeside=1&between=0,1&t=0&loop=bounce&play=1',
    panel: 'shape',
    part: 'panel-ghost',
    text: 'The paper shows coarse ghost meshes of its shapes, and lines from each ghost vertex to its corresponding vertex.',
    task: 'Change the number of faces in Shape, Ghost mesh.',
    sentence:
      'As in the paper, the ghost and its correspondences are found automatically. Here the ghost is shown beside the shape.',
    live: ({ stats }) => `The ghost mesh has ${stats.ghostFaces.toLocaleString('en')} faces.`,
  },
  {
    number: '7',
    name: 'What a ghost costs',
    state: 'sample=cactus&ghostFaces=250&ghostSizes=1&between=0,1&t=0.25&loop=bounce&play=1',
    panel: 'shape',
    part: 'panel-ghost',
    text: 'The paper colours a centaur by its distance from the motion without a ghost, for ghost meshes of ten sizes.',
    task: 'Drag the time slider, and compare the colours. Then choose another size in Shape, Ghost mesh.',
    sentence:
      'As in the paper, the error falls as the ghost gets finer. Three sizes are shown beside the motion without a ghost.',
  },
  {
    number: '8',
    name: 'Error and time by size',
    state: 'sample=cactus&ghostFaces=500&between=0,1&t=0&loop=bounce&play=1',
    panel: 'shape',
    text: 'The paper plots the KG error of four shapes, and the frame time of one of them, against ghost size.',
    part: 'study-charts',
    plot: 'ghost-error',
    press: 'study-shapes',
    task: 'Wait for the two charts in Shape, Ghost mesh. “Compare sizes” shows both transfers on the open shape.',
    sentence:
      'As in the paper, the error of every shape falls as its ghost gets finer. Your browser measures four samples. A line ends where the ghost would have as many faces as the shape.',
  },
  {
    number: '9',
    name: 'Smoothness',
    state: 'sample=dachshund&boundary=natural&compare=geodesic,shell&between=0,0.875&t=0&loop=bounce&play=1',
    panel: 'analysis',
    text: 'The paper plots the second derivative of motions through ten poses of a person: geodesics peak at every key, splines stay low.',
    part: 'plot-bending',
    plot: 'bending',
    wide: true,
    press: 'bending-shell',
    task: 'Enlarge the Bending energy plot in Analysis, and look at the geodesic at the keys.',
    sentence:
      'As in the paper, the geodesic peaks at the keys, and both splines stay low. All three are measured by edge lengths and angles, so their heights compare.',
  },
  {
    number: '10',
    name: 'Many faces',
    state: 'sample=serpent&between=0,1&t=0&loop=bounce&play=1',
    text: 'The paper completes two armadillos, of 332,000 and of 1.3 million faces.',
    task: 'Drag the time slider, and read the frame time at the bottom right.',
    sentence:
      'Each frame solves two systems that are factored once: rotations, then positions. The serpent has about as many faces as the paper’s smaller armadillo.',
    live: ({ faces, ms }) =>
      `${faces.toLocaleString('en')} faces${ms === null ? '' : `, a frame in ${ms.toFixed(0)} ms`}.`,
  },
];

export const FIGURES: readonly GuidePage[] = LIST.map(({ number, name, ...page }) => ({
  ...page,
  title: `Fig. ${number}: ${name}`,
  link: `figure=${number}`,
}));
