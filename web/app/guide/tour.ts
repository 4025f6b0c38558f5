/** The tour: ten steps from poses to the plane of shapes. */
import { turnAlong } from '../../study/turn-along.ts';
import type { GuidePage } from './guide-page.ts';

const milliseconds = (ms: number): string => `${ms < 10 ? ms.toFixed(1) : ms.toFixed(0)} ms`;
const listed = (numbers: readonly number[]): string =>
  numbers.length < 2 ? numbers.join('') : `${numbers.slice(0, -1).join(', ')} and ${numbers.at(-1)!}`;
const grouped = (count: number): string => count.toLocaleString('en');

/** The rotations from the engine: from the first patch to the last, and between neighbours. */
const twistOf: GuidePage['ask'] = async (sequence, { keyTimes }) => {
  const { patches } = await sequence.shape.stats();
  const [first, last] = [keyTimes[0]!, keyTimes.at(-1)!];
  const times = [(first + last) / 2, last];
  const turn = await turnAlong(patches, times.length, (patch) => sequence.patchCurve(patch, times));
  if (!turn) return '';
  const [half, whole] = turn.total.map((angle) => angle.toFixed(0));
  return (
    `From the first to the last of ${turn.patches} patches: ${whole} degrees at the last key, ${half} halfway, ` +
    `at most ${turn.largest.toFixed(0)} degrees between neighbours.`
  );
};

/** A face in the turret's shrinking upper part, and the farthest extrapolated time of the plots. */
const [SHRINKING, FAR] = [116, 1.4];
const narrownessOf: GuidePage['ask'] = async (sequence, { stretch }) => {
  const { numbers } = await sequence.faceCurve(SHRINKING, [FAR]);
  const [xx, xy, yy] = numbers.slice(3) as [number, number, number];
  const least = (xx + yy) / 2 - Math.hypot((xx - yy) / 2, xy);
  const share = stretch === 'log' ? Math.exp(least) : least;
  const words = share > 0 ? 'it only becomes narrower' : 'it would be inside out';
  const of = stretch === 'log' ? 'logarithmic' : 'linear';
  return `At ${FAR} s, with ${of} stretch, the marked face has ${(100 * share).toFixed(0)} % of its width in the reference pose: ${words}.`;
};

const STEPS: readonly Omit<GuidePage, 'link'>[] = [
  {
    title: 'Three poses, one motion',
    state: 'sample=cactus&colour=phase&between=-0.35,1.35&t=-0.35&loop=bounce&play=1',
    text: 'An artist made three poses of a cactus: the keys. Every other shape that you see is computed, both between the keys and beyond them.',
    panel: 'motion',
    task: 'Drag the time slider, even past both ends.',
    sentence: 'Blue shapes are given. Green ones are interpolated, yellow ones extrapolated.',
    live: ({ keyTimes, faces }) => `${keyTimes.length} keys of ${grouped(faces)} faces, at ${listed(keyTimes)} s.`,
    formula: {
      math: '<mrow><mi>s</mi><mo>(</mo><msub><mi>t</mi><mi>j</mi></msub><mo>)</mo><mo>=</mo><msub><mi>s</mi><mi>j</mi></msub></mrow>',
      words: 'At each key’s time, the motion s passes exactly through that key.',
    },
  },
  {
    title: 'Why not simply blend?',
    state: 'sample=twisted-bar&compare=linear&between=0,0.5&t=0.25&loop=bounce&play=1',
    text: 'Two poses of a bar differ by half a turn. The simplest idea is to move every vertex along a straight line between its two positions. How much of the bar’s volume is left halfway? Guess first.',
    panel: 'analysis',
    part: 'plot-volume',
    plot: 'volume',
    task: 'Drag the time slider halfway between the first two keys, and compare the two volumes.',
    sentence:
      'Blending positions moves every point along a straight line, so a shape that bends or twists loses volume.',
    live: ({ volumes: [ours, blended] }) =>
      ours && blended ? `Volume now: ${blended} blended, ${ours} in shape space.` : '',
    formula: {
      math: '<mrow><mi>p</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>=</mo><mo>(</mo><mn>1</mn><mo>−</mo><mi>t</mi><mo>)</mo><msub><mi>p</mi><mn>0</mn></msub><mo>+</mo><mi>t</mi><msub><mi>p</mi><mn>1</mn></msub></mrow>',
      words:
        'A weighted average of two positions. A chord lies inside its circle, so halfway every point is closer to the rotation axis, and the bar is thinner.',
    },
    more: 'Where the bar rotates by 180 degrees, the chord passes through the axis: all points of that cross-section meet there.',
  },
  {
    title: 'What a shape is made of',
    state: 'sample=cactus&colour=patches&between=0,1&t=0&loop=bounce&play=1',
    text: 'The surface is cut into patches. For each pair of neighbouring patches, only the relative rotation is kept. For each face, the rotation and stretch within its patch are kept. The position of the shape is not part of the description.',
    panel: 'analysis',
    part: 'faces',
    fill: { field: 'face-number', value: '12000' },
    plot: 'face-rotation',
    task: 'Click the shape. The Analysis panel plots how that face rotates and stretches within its patch. Then switch to Patch.',
    sentence:
      'Described by the relative rotations and stretches of its parts, a shape no longer depends on where it stands or which way it faces.',
    live: ({ faces, patches }) => `${grouped(faces)} faces in ${grouped(patches)} patches.`,
    formula: {
      math: '<mrow><msub><mi>R</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><msubsup><mi>R</mi><mi>i</mi><mi>T</mi></msubsup><msub><mi>R</mi><mi>j</mi></msub></mrow>',
      words: 'The rotation from patch i to patch j. It does not change when the whole shape is rotated.',
    },
  },
  {
    title: 'Adding up along the body',
    state: 'sample=column&keys=0@0,2@1&between=0,1&t=0&loop=bounce&play=1',
    text: 'Two keys: a straight column, and a column twisted by almost a full turn. Judged by its ends alone, it might have turned slightly the other way. But neighbouring patches rotate by much less than half a turn, and these rotations add up. No key can tell whether the whole column also spun around once.',
    panel: 'motion',
    ask: twistOf,
    task: 'Open key 2 in the row of keys and add a full turn. Then look halfway: the stripes have changed places.',
    sentence: 'Small rotations add up along the body, but two keys cannot tell how many full turns lie between them.',
    formula: {
      math: '<mrow><msub><mi>R</mi><mrow><mn>1</mn><mi>n</mi></mrow></msub><mo>=</mo><msub><mi>R</mi><mn>12</mn></msub><msub><mi>R</mi><mn>23</mn></msub><mo>⋯</mo><msub><mi>R</mi><mrow><mi>n</mi><mo>−</mo><mn>1</mn><mo>,</mo><mi>n</mi></mrow></msub></mrow>',
      words: 'The rotation from the first patch to the last: the product of the rotations between neighbours.',
    },
  },
  {
    title: 'The corner at a key',
    panel: 'analysis',
    state: 'sample=cactus&compare=geodesic&between=0,1&t=0&loop=bounce&play=1',
    text: 'The cactus on the right takes the shortest path from key to key, a geodesic. In shape space it is straight between keys and has a corner at the middle key, where it changes direction abruptly.',
    part: 'plot-bending',
    plot: 'bending',
    task: 'Watch the middle key, then look at the Bending energy plot.',
    sentence: 'The shortest path is straight from key to key, and turns sharply at each key.',
    formula: {
      math: '<mrow><mi>E</mi><mo>(</mo><mi>s</mi><mo>)</mo><mo>=</mo><munderover><mo>∫</mo><mn>0</mn><mn>1</mn></munderover><msup><mrow><mo>‖</mo><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><mi>t</mi><mo>)</mo><mo>‖</mo></mrow><mn>2</mn></msup><mi>d</mi><mi>t</mi></mrow>',
      words: 'The bending energy of a motion: its squared acceleration, added up over time.',
    },
  },
  {
    title: 'The bent ruler',
    state: 'sample=cactus&between=0,1&t=0&loop=bounce&play=1',
    text: 'Pass a thin ruler between a few nails. It settles into the shape with the least total bending and runs straight past the last nail. That is the natural cubic spline. Every coordinate of the shape follows such a spline.',
    task: 'In the playground, drag a point up and down.',
    sentence: 'The smoothest curve through the keys has the least total bending. One tiny linear system finds it.',
    formula: {
      math: '<mrow><munder><mi>min</mi><mi>f</mi></munder><munderover><mo>∫</mo><mn>0</mn><mn>1</mn></munderover><msup><mrow><mo>|</mo><msup><mi>f</mi><mo>″</mo></msup><mo>(</mo><mi>t</mi><mo>)</mo><mo>|</mo></mrow><mn>2</mn></msup><mi>d</mi><mi>t</mi></mrow>',
      words: 'Of all curves through the values, the spline has the smallest integral of the squared second derivative.',
    },
    beside: { label: 'Open the playground', href: './play.html#take', framed: 'Playground' },
    wide: true,
  },
  {
    title: 'The ends',
    panel: 'motion',
    state:
      'sample=cactus&boundary=hermite&startSpeed=2&endSpeed=2&between=-0.2,1.2&t=0&loop=bounce&colour=phase&play=1',
    text: 'Between the keys, nothing is left to choose. At the ends, you decide: “Free” (natural) leaves the ends free, like the ruler, with no bending. “Ease” (Hermite) sets the speed at each end. “Loop” (periodic) joins the last key to the first.',
    task: 'Drag a handle at an end of the timeline. Then choose Free and Loop in the Motion panel.',
    sentence: 'What happens at the ends is a choice: free, a given speed, or a closed loop.',
    formula: {
      math: '<mrow><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><msub><mi>t</mi><mn>1</mn></msub><mo>)</mo><mo>=</mo><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><msub><mi>t</mi><mi>J</mi></msub><mo>)</mo><mo>=</mo><mn>0</mn></mrow>',
      words: 'Natural: no bending at the first and last key, so the motion continues in a straight line.',
    },
  },
  {
    title: 'Beyond the keys',
    panel: 'analysis',
    part: 'faces',
    fill: { field: 'face-number', value: `${SHRINKING}` },
    plot: 'face-stretch',
    state: 'sample=turret&colour=phase&between=0,1.4&t=0&loop=bounce&play=1',
    text: 'Past the last key, the motion keeps its speed. A rotation can continue forever, but a stretch cannot. A face that keeps shrinking by the same amount reaches zero size and then turns inside out. The displayed surface is clamped before that, but its coordinates are not.',
    task: 'In Analysis, find where the face’s stretch crosses zero. Then choose Logarithmic under Shape, Stretch.',
    ask: narrownessOf,
    sentence:
      'Past the last key the curve continues straight. Stretch must then be measured as a ratio, on a logarithmic scale.',
    formula: {
      math: '<mrow><mi>f</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>=</mo><mi>f</mi><mo>(</mo><mn>1</mn><mo>)</mo><mo>+</mo><mo>(</mo><mi>t</mi><mo>−</mo><mn>1</mn><mo>)</mo><msup><mi>f</mi><mo>′</mo></msup><mo>(</mo><mn>1</mn><mo>)</mo></mrow>',
      words: 'After the last key: a straight line with the final velocity.',
    },
    more: 'The shape plane draws a mixture of keys without the clamp. Drag the point past key 3, as far as it goes: with linear stretch the upper part almost vanishes; with logarithmic stretch it remains a small tower.',
  },
  {
    title: 'The plane of shapes',
    panel: 'analysis',
    part: 'plot-plane',
    plot: 'plane',
    wide: true,
    state: 'sample=cactus&compare=geodesic,linear&between=-0.2,1.2&t=0&loop=bounce&play=1',
    text: 'Like three points, three shapes span a plane. In this plane, the spline is a smooth curve, and the geodesic is a line with a corner at each inner key. A vertex blend leaves the plane. Points off the curves are shapes too: weighted mixtures of the keys.',
    task: 'In Analysis, drag the point off the curve, or draw a path.',
    sentence: 'Every mixture of the keys is a shape; a motion is a path among them.',
    formula: {
      math: '<mrow><mi>s</mi><mo>=</mo><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>w</mi><mi>k</mi></msub><msub><mi>s</mi><mi>k</mi></msub><mo>,</mo><mspace width="0.6em"/><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>w</mi><mi>k</mi></msub><mo>=</mo><mn>1</mn></mrow>',
      words: 'A shape is a weighted sum of the keys. The weights add up to 1 and may be negative.',
    },
  },
  {
    title: 'Two systems, factored once',
    state: 'sample=octopus&between=0,1.5&t=0&loop=bounce&play=1',
    panel: 'motion',
    text: 'Computing a shape from its coordinates takes two steps: the rotations of all patches, then all vertices. Each step solves a large linear system. Its matrix does not depend on time, so it is factored once.',
    task: 'Open your own poses and export the motion.',
    sentence:
      'Both systems, for rotations and for positions, are factored once. That is why the slider responds instantly.',
    formula: {
      math: '<mrow><mi>A</mi><mi>G</mi><mo>=</mo><mi>b</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>,</mo><mspace width="0.6em"/><mi>L</mi><mi>v</mi><mo>=</mo><mi>c</mi><mo>(</mo><mi>t</mi><mo>)</mo></mrow>',
      words: 'A determines the patch rotations G, and L the vertices v. Only the right-hand sides change with time.',
    },
    live: ({ stats, ms, faces }) =>
      `${grouped(faces)} faces: factored in ${milliseconds(stats.encodeMs + stats.orderMs + stats.factorMs)}` +
      (ms === null ? '.' : `, each frame in ${milliseconds(ms)}.`),
  },
];

export const TOUR: readonly GuidePage[] = STEPS.map((step, index) => ({ ...step, link: `tour=${index + 1}` }));
