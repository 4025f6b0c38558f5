/** The tour: ten steps from poses to the plane of shapes. */
import { turnAlong } from '../../study/turn-along.ts';
import type { GuidePage } from './guide-page.ts';

const milliseconds = (ms: number): string => `${ms < 10 ? ms.toFixed(1) : ms.toFixed(0)} ms`;
const listed = (numbers: readonly number[]): string =>
  numbers.length < 2 ? numbers.join('') : `${numbers.slice(0, -1).join(', ')} and ${numbers.at(-1)!}`;
const grouped = (count: number): string => count.toLocaleString('en');

/** The same from the engine: from the first patch to the last, and from one to the next. */
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

/** A face in the upper part of the turret, which shrinks; described as far out as the plots go. */
const [SHRINKING, FAR] = [116, 1.4];
const narrownessOf: GuidePage['ask'] = async (sequence, { stretch }) => {
  const { numbers } = await sequence.faceCurve(SHRINKING, [FAR]);
  const [xx, xy, yy] = numbers.slice(3) as [number, number, number];
  const least = (xx + yy) / 2 - Math.hypot((xx - yy) / 2, xy);
  const share = stretch === 'log' ? Math.exp(least) : least;
  const words = share > 0 ? 'it only grows narrower' : 'it would be inside out';
  return `By its line a face above has ${(100 * share).toFixed(0)} % of its width at ${FAR}: ${words}.`;
};

const STEPS: readonly Omit<GuidePage, 'link'>[] = [
  {
    title: 'Three poses, one motion',
    state: 'sample=cactus&colour=phase&between=-0.35,1.35&t=-0.35&loop=bounce&play=1',
    text: 'Somebody made three poses of a cactus, the keys. Everything else that you see was found: the shapes between them, and those before the first and after the last.',
    panel: 'motion',
    task: 'Drag the time, also past both ends.',
    sentence: 'Blue shapes were given, green ones are computed between them, yellow ones beyond.',
    live: ({ keyTimes, faces }) => `${keyTimes.length} keys of ${grouped(faces)} faces, at ${listed(keyTimes)}.`,
    formula: {
      math: '<mrow><mi>s</mi><mo>(</mo><msub><mi>t</mi><mi>j</mi></msub><mo>)</mo><mo>=</mo><msub><mi>s</mi><mi>j</mi></msub></mrow>',
      words: 'At the time of each key the motion s is that key, exactly.',
    },
  },
  {
    title: 'Why not simply blend?',
    state: 'sample=twisted-bar&compare=linear&between=0,0.5&t=0.25&loop=bounce&play=1',
    text: 'Two poses of a bar differ by half a turn. The plainest thing is to move every vertex on a straight line from one to the other. How much of the bar is left halfway? Guess first.',
    panel: 'analysis',
    part: 'plot-volume',
    plot: 'volume',
    task: 'Drag the time to the middle between the first two keys, and compare the two volumes.',
    sentence:
      'Blending positions moves every point along a straight line, so a shape that bends or twists loses volume.',
    live: ({ volumes: [ours, blended] }) =>
      ours && blended ? `Volume now: ${blended} blended, ${ours} in shape space.` : '',
    formula: {
      math: '<mrow><mi>p</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>=</mo><mo>(</mo><mn>1</mn><mo>−</mo><mi>t</mi><mo>)</mo><msub><mi>p</mi><mn>0</mn></msub><mo>+</mo><mi>t</mi><msub><mi>p</mi><mn>1</mn></msub></mrow>',
      words:
        'So much of the one place, so much of the other. The line between two places of a circle runs inside of it: on the way every point is nearer to the axis about which it turns, and the bar is thin.',
    },
    more: 'Where the bar turns by a half, the line runs through the axis itself: there all points meet, and nothing is left.',
  },
  {
    title: 'What a shape is made of',
    state: 'sample=cactus&colour=patches&between=0,1&t=0&loop=bounce&play=1',
    text: 'The surface is cut into patches. Of each pair of neighbours only the rotation from one to the other is kept, and of each face how it turns and stretches in its patch. Nothing says where the shape stands.',
    panel: 'analysis',
    part: 'faces',
    fill: { field: 'face-number', value: '12000' },
    plot: 'face-rotation',
    task: 'Click the shape: under Analysis, see how that face turns and stretches in its patch; then choose Patch.',
    sentence: 'Describe a shape by how neighbouring parts turn and stretch, and it no longer matters where it stands.',
    live: ({ faces, patches }) => `${grouped(faces)} faces in ${grouped(patches)} patches.`,
    formula: {
      math: '<mrow><msub><mi>R</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><msubsup><mi>R</mi><mi>i</mi><mi>T</mi></msubsup><msub><mi>R</mi><mi>j</mi></msub></mrow>',
      words: 'The rotation from patch i to patch j: turn the whole shape, and it stays the same.',
    },
  },
  {
    title: 'Adding up along the body',
    state: 'sample=column&keys=0@0,2@1&between=0,1&t=0&loop=bounce&play=1',
    text: 'Two keys: a straight column, and one twisted by almost a full turn. Judged by its ends alone, it might have turned slightly the other way. But neighbouring patches turn by much less than half a turn, and these rotations add up. Whether the whole column also spun around once, no key can tell.',
    panel: 'motion',
    ask: twistOf,
    task: 'Open key 2 in the row of keys and add a full turn. Then look halfway: the stripes have changed places.',
    sentence: 'Small rotations add up along the body, but two keys cannot tell how many full turns lie between them.',
    formula: {
      math: '<mrow><msub><mi>R</mi><mrow><mn>1</mn><mi>n</mi></mrow></msub><mo>=</mo><msub><mi>R</mi><mn>12</mn></msub><msub><mi>R</mi><mn>23</mn></msub><mo>⋯</mo><msub><mi>R</mi><mrow><mi>n</mi><mo>−</mo><mn>1</mn><mo>,</mo><mi>n</mi></mrow></msub></mrow>',
      words: 'From the first patch to the last: the rotations between neighbours, one after the other.',
    },
  },
  {
    title: 'The corner at a key',
    panel: 'analysis',
    state: 'sample=cactus&compare=geodesic&between=0,1&t=0&loop=bounce&play=1',
    text: 'The second cactus goes from key to key on the shortest way, a geodesic. It is straight between two keys, and has a corner at the middle one: there it changes direction at once.',
    part: 'plot-bending',
    plot: 'bending',
    task: 'Look at the middle key, and at the bending under Analysis.',
    sentence: 'Straight from key to key is shortest, and turns sharply at each key.',
    formula: {
      math: '<mrow><mi>E</mi><mo>(</mo><mi>s</mi><mo>)</mo><mo>=</mo><munderover><mo>∫</mo><mn>0</mn><mn>1</mn></munderover><msup><mrow><mo>‖</mo><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><mi>t</mi><mo>)</mo><mo>‖</mo></mrow><mn>2</mn></msup><mi>d</mi><mi>t</mi></mrow>',
      words: 'The bending energy of a motion: how much its speed changes, squared and added up over time.',
    },
  },
  {
    title: 'The bent ruler',
    state: 'sample=cactus&between=0,1&t=0&loop=bounce&play=1',
    text: 'Hold a thin ruler at a few nails and let it bend as it likes: it takes the shape that bends least in total, and is straight past its last nail. That is the natural cubic spline. Every coordinate of the shape runs on one.',
    task: 'Drag a value of the playground up and down.',
    sentence: 'The smoothest curve through the keys bends least in total, and one tiny system finds it.',
    formula: {
      math: '<mrow><munder><mi>min</mi><mi>f</mi></munder><munderover><mo>∫</mo><mn>0</mn><mn>1</mn></munderover><msup><mrow><mo>|</mo><msup><mi>f</mi><mo>″</mo></msup><mo>(</mo><mi>t</mi><mo>)</mo><mo>|</mo></mrow><mn>2</mn></msup><mi>d</mi><mi>t</mi></mrow>',
      words: 'Of all curves through the values, the one whose second derivative is least in total.',
    },
    beside: { label: 'Open the playground', href: './play.html#take', framed: 'Playground' },
    wide: true,
  },
  {
    title: 'The ends',
    panel: 'motion',
    state:
      'sample=cactus&boundary=hermite&startSpeed=2&endSpeed=2&between=-0.2,1.2&t=0&loop=bounce&colour=phase&play=1',
    text: 'Inside, the keys say it all. At the ends somebody has to choose: “Free” (natural) leaves the ends alone, as the ruler, with no bending there; “Ease” (Hermite) gives them a speed; “Loop” (periodic) joins the last key to the first.',
    task: 'Drag a handle at an end of the timeline; then choose Free and Loop under Motion.',
    sentence: 'What happens at the ends is a choice: free, a given speed, or a closed loop.',
    formula: {
      math: '<mrow><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><msub><mi>t</mi><mn>1</mn></msub><mo>)</mo><mo>=</mo><msup><mi>s</mi><mo>″</mo></msup><mo>(</mo><msub><mi>t</mi><mi>J</mi></msub><mo>)</mo><mo>=</mo><mn>0</mn></mrow>',
      words: 'Natural: at the first and the last key the motion does not bend, so that it goes on straight.',
    },
  },
  {
    title: 'Beyond the keys',
    panel: 'analysis',
    part: 'faces',
    fill: { field: 'face-number', value: `${SHRINKING}` },
    plot: 'face-stretch',
    state: 'sample=turret&colour=phase&between=0,1.4&t=0&loop=bounce&play=1',
    text: 'Past its last key the motion goes on as fast as it was. Turns may go on like that. A stretch may not: what shrinks by the same amount again and again is nothing one day, and then inside out. The surface here stops short of it; its numbers go on.',
    task: 'Look under Analysis where the stretch of a face crosses nothing; then choose logarithmic stretch under Shape.',
    ask: narrownessOf,
    sentence: 'Past the last key the curve goes on straight; stretch must be counted in ratios there.',
    formula: {
      math: '<mrow><mi>f</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>=</mo><mi>f</mi><mo>(</mo><mn>1</mn><mo>)</mo><mo>+</mo><mo>(</mo><mi>t</mi><mo>−</mo><mn>1</mn><mo>)</mo><msup><mi>f</mi><mo>′</mo></msup><mo>(</mo><mn>1</mn><mo>)</mo></mrow>',
      words: 'After the last key: from there on straight, with the speed that it had.',
    },
    more: 'In the shape plane a mixture of keys is drawn as it is. Drag the point past key 3, as far as it goes: with linear stretch the upper part is all but gone, with logarithmic stretch it stays a small tower.',
  },
  {
    title: 'The plane of shapes',
    panel: 'analysis',
    part: 'plot-plane',
    plot: 'plane',
    wide: true,
    state: 'sample=cactus&compare=geodesic,linear&between=-0.2,1.2&t=0&loop=bounce&play=1',
    text: 'Three shapes span a plane, as three points do. In it the spline is a curve and the geodesic a polygon; a blend of vertices leaves the plane. A point of it that lies on no curve is a shape, too: so much of each key.',
    task: 'Under Analysis, drag the point off the curve, or draw a path.',
    sentence: 'Every mixture of the keys is a shape; a motion is a path among them.',
    formula: {
      math: '<mrow><mi>s</mi><mo>=</mo><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>w</mi><mi>k</mi></msub><msub><mi>s</mi><mi>k</mi></msub><mo>,</mo><mspace width="0.6em"/><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>w</mi><mi>k</mi></msub><mo>=</mo><mn>1</mn></mrow>',
      words: 'A shape is so much of each key; the shares add up to one, and may be negative.',
    },
  },
  {
    title: 'Two systems, factored once',
    state: 'sample=octopus&between=0,1.5&t=0&loop=bounce&play=1',
    panel: 'motion',
    text: 'From coordinates back to a shape is two steps: the rotations of all patches, then all vertices. Each is one large linear system that never changes while the time does, so that it is prepared once.',
    task: 'Open poses of your own, and export the motion.',
    sentence: 'Rotations first, points second, both prepared once: that is why the slider is live.',
    formula: {
      math: '<mrow><mi>A</mi><mi>G</mi><mo>=</mo><mi>b</mi><mo>(</mo><mi>t</mi><mo>)</mo><mo>,</mo><mspace width="0.6em"/><mi>L</mi><mi>v</mi><mo>=</mo><mi>c</mi><mo>(</mo><mi>t</mi><mo>)</mo></mrow>',
      words: 'A for the rotations G of the patches, L for the vertices v: only the right sides change with time.',
    },
    live: ({ stats, ms, faces }) =>
      `${grouped(faces)} faces: prepared in ${milliseconds(stats.encodeMs + stats.orderMs + stats.factorMs)}` +
      (ms === null ? '.' : `, each frame in ${milliseconds(ms)}.`),
  },
];

export const TOUR: readonly GuidePage[] = STEPS.map((step, index) => ({ ...step, link: `tour=${index + 1}` }));
