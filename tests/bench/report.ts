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
    `Milliseconds. "here": ${where}, one thread of WebAssembly; "paper": ${PAPER_MACHINE}. Machine and program\n` +
    'both differ.';
  const parts = [
    `# ${where}`,
    `**${verdict(targets)}**`,
    'Three keys of a generated mesh. Times are in milliseconds unless stated otherwise: for builds the median of five, for frames median / 95th\n' +
      `percentile. Clocks cannot resolve less than ${CLOCK_MS}. "in parts": several components, open boundaries, slivers; no option or limit was\n` +
      'tuned to these meshes.',
    '## Targets',
    targetTable(targets),
    '## Building a sequence',
    '"silent": the longest time without a progress report, and the report after it.',
    buildTable(sizes),
    memoryTable(sizes),
    '## A frame',
    '"patches": patch rotations; "faces": splined faces and right-hand side; "frame" includes the copy out of the wasm heap. Ratios are medians\n' +
      'of five rounds, with minimum and maximum; targets apply to these medians.',
    frameTable(sizes),
    '## Errors of shapes',
    '"double": the same keys in double precision, native. Distances from the exact frame of the default precision at times between the keys (0 to 1)\n' +
      'and in the margins (0.4 on either side), in % of the diagonal of the bounding box: mean over all shapes, largest mean of one shape, and\n' +
      'worst vertex with its time.',
    errorTable(sizes),
    ...(keys.length > 0
      ? [
          '## More keys',
          'The same mesh with more keys and with three, measured alternately. "frame / with few" is the median ratio over the rounds. Below\n' +
            '"keys / few", the cost grows less than linearly.',
          keysTable(keys),
        ]
      : []),
    '## The second system',
    'Solvers on one thread, native except our own in wasm, one after the other in each of five rounds: medians, and ratios of times from the\n' +
      'same round, with minimum and maximum. A solve has three columns. Eigen: `SimplicialLLT` with its minimum degree order. CHOLMOD, if\n' +
      'installed: supernodal, METIS order. "entries": entries of the triangular factor; "MB": size of the stored factor with its indices; "error":\n' +
      'distance from the known solution of a system, relative to the diagonal.',
    solverTable(sizes),
    ...(inPaper
      ? [
          "## One shape, as in the paper's Table 1",
          `${machines}\nt_ir: interpolation and reconstruction on a ghost mesh of 2,000 faces with its vertices, which a frame here does not need;\n` +
            't_ts: from there to the shape; t_o: without a ghost mesh. Times are from the core and exclude the copy out of the wasm heap.',
          inPaper,
        ]
      : []),
    ...(motions.length > 0
      ? [
          "## K shapes, as in the paper's Table 2",
          `${machines}\nTimes are for all K shapes. γ is the share of vertices that the ghost mesh keeps; [2] is the method that the paper compares with.`,
          table2(motions),
        ]
      : []),
    ...(resolutions.length > 0
      ? [
          "## The same motion at two resolutions, as in the paper's Fig. 10",
          'A mesh, and the same mesh with every face split into four. Distance of the common vertices, in % of the diagonal.',
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
