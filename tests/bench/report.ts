/** The page of results. */
import { CLOCK_MS, short, table } from './format.ts';
import type { KeysRun } from './key-counts.ts';
import { PAPER_MACHINE, table1, table2, type Table2Row } from './paper.ts';
import type { Resolutions } from './resolutions.ts';
import {
  buildTable,
  errorTable,
  frameTable,
  keysTable,
  meshName,
  memoryTable,
  solverTable,
  type Result,
} from './tables.ts';
import { keysTarget, resolutionTarget, targetsOf, targetTable, verdict } from './targets.ts';
import type { MotionRun } from './whole-sequences.ts';

export interface Results {
  /** Program, version and processor. */
  where: string;
  sizes: Result[];
  motions: { row: Table2Row; run: MotionRun }[];
  resolutions: Resolutions[];
  keys: KeysRun[];
}

export function report({ where, sizes, motions, resolutions, keys }: Results): { text: string; verdict: string } {
  const targets = [
    ...sizes.flatMap((result) => targetsOf(meshName(result), result.run)),
    ...resolutions.map(resolutionTarget),
    ...keys.map(keysTarget),
  ];
  const inPaper = table1(sizes.flatMap(({ family, run }) => (family === 'smooth' ? [run] : [])));
  const machines =
    `Milliseconds. "here": ${where}, one thread of WebAssembly; "paper": ${PAPER_MACHINE}. The machine differs as\n` +
    'the program does.';
  const parts = [
    `# ${where}`,
    `**${verdict(targets)}**`,
    'Three keys of a generated mesh; milliseconds unless said otherwise. Builds are medians of five; frames median / 95th percentile.\n' +
      `Less than ${CLOCK_MS} is below what clocks can tell. "in parts": several components, open boundaries, slivers; held back:\n` +
      'no option or limit was chosen by it.',
    '## Targets',
    targetTable(targets),
    '## Building a sequence',
    '"silent": the longest time without a sign of progress, and what was reported after it.',
    buildTable(sizes),
    memoryTable(sizes),
    '## A frame',
    '"patches": their rotations; "faces": splined faces and right-hand side; "frame" has the copy out of the wasm heap, too. Ratios are\n' +
      'medians of five rounds, with the lowest and highest; the targets are the same medians.',
    frameTable(sizes),
    '## How far shapes are off',
    '"double": the same keys in double, native. Distances to the exact frame of the default precision over a sweep of times between the keys (0 to 1) and in the margins (0.4 on\n' +
      'either side), in % of the diagonal of the bounding box: mean of all, largest mean of one shape, worst vertex with its time.',
    errorTable(sizes),
    ...(keys.length > 0
      ? [
          '## More keys',
          'The same mesh with more keys, in turn with three: "frame / with few" is the median of the rounds\' ratios, and grows less than\n' +
            'linearly as long as it is below "keys / few".',
          keysTable(keys),
        ]
      : []),
    '## The second system',
    'Native but for our own in wasm, in one thread, one after the other in each of five rounds: medians, and ratios of what was measured\n' +
      'in the same round, with the lowest and highest. A solve has three columns. Eigen: `SimplicialLLT` with its minimum degree order;\n' +
      'CHOLMOD, where it is installed: supernodal, METIS order. "entries" are those of the triangular factor, "MB" what is stored of it,\n' +
      'indices included; "error": how far the solution of a known system is off, as a share of the diagonal.',
    solverTable(sizes),
    ...(inPaper
      ? [
          "## One shape, as in the paper's Table 1",
          `${machines}\nt_ir: interpolation and reconstruction on a ghost mesh of 2,000 faces, its vertices included, which a frame here does\n` +
            'without; t_ts: from there to the shape; t_o: without a ghost. All by the clock of the core, the copy out of the wasm heap left out.',
          inPaper,
        ]
      : []),
    ...(motions.length > 0
      ? [
          "## K shapes, as in the paper's Table 2",
          `${machines}\nFor all shapes; γ is the share of vertices that the ghost mesh keeps, [2] the method that the paper compares with.`,
          table2(motions),
        ]
      : []),
    ...(resolutions.length > 0
      ? [
          "## The same motion at two resolutions, as in the paper's Fig. 10",
          'A mesh, and the same with every face split into four: how far the vertices that both have are apart, in % of the diagonal.',
          table(
            ['faces', 'split', 'in the mean %', 'at worst %'],
            resolutions.map(({ coarseFaces, fineFaces, distance }) => [
              String(coarseFaces),
              String(fineFaces),
              short(100 * distance.mean),
              short(100 * distance.worst),
            ]),
          ),
        ]
      : []),
  ];
  return { text: `${parts.join('\n\n')}\n`, verdict: verdict(targets) };
}
