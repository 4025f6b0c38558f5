/** The page of results. */
import { table1, table2, type Table2Row } from './paper.ts';
import type { Resolutions } from './resolutions.ts';
import { buildTable, cheapTable, frameTable, memoryTable, solverTable, type Result } from './tables.ts';
import { short, table } from './format.ts';
import { resolutionTarget, targetsOf, targetTable, verdict } from './targets.ts';
import type { MotionRun } from './whole-sequences.ts';

export interface Results {
  /** Program, version and processor. */
  where: string;
  sizes: Result[];
  motions: { row: Table2Row; run: MotionRun }[];
  resolutions: Resolutions[];
}

export function report({ where, sizes, motions, resolutions }: Results): { text: string; verdict: string } {
  const targets = [...sizes.flatMap(({ run }) => targetsOf(run)), ...resolutions.map(resolutionTarget)];
  const inPaper = table1(sizes.map(({ run }) => run));
  const parts = [
    `# ${where}`,
    `**${verdict(targets)}**`,
    `Three keys of a generated mesh; milliseconds unless said otherwise. Builds are medians of five; frames median / 95th percentile.`,
    '## Targets', targetTable(targets),
    '## Building a sequence',
    '"silent": the longest time without a sign of progress, and what was reported after it.', buildTable(sizes), memoryTable(sizes),
    '## A frame',
    '"error": largest distance to the shape computed in double, over the diagonal of the bounding box.', frameTable(sizes),
    '## The cheap shape while a slider moves',
    `Beside the exact frame; "first" makes what the others need. How far it is off: over frames of the range and beyond, in % of the diagonal.`, cheapTable(sizes),
    '## The second system',
    'Native Eigen LLT (one solve with three columns) and our own in wasm, measured in turn: medians of five rounds, their ratio with the lowest and\n'
      + 'highest. Between them our own, native.', solverTable(sizes),
    ...(inPaper ? [
      "## One shape, as in the paper's Table 1",
      'Seconds. t_ir: interpolation and reconstruction on a ghost mesh of 2,000 faces; t_ts: from there to the shape; t_o: without a ghost.', inPaper,
    ] : []),
    ...(motions.length > 0 ? [
      "## K shapes, as in the paper's Table 2",
      'Seconds for all of them; γ is the share of vertices that the ghost mesh keeps, [2] the method that the paper compares with.', table2(motions),
    ] : []),
    ...(resolutions.length > 0 ? [
      "## The same motion at two resolutions, as in the paper's Fig. 10",
      'A mesh, and the same with every face split into four: how far the vertices that both have are apart, in % of the diagonal.',
      table(['faces', 'split', 'in the mean %', 'at worst %'], resolutions.map(({ coarseFaces, fineFaces, distance }) =>
        [String(coarseFaces), String(fineFaces), short(100 * distance.mean), short(100 * distance.worst)])),
    ] : []),
  ];
  return { text: `${parts.join('\n\n')}\n`, verdict: verdict(targets) };
}
