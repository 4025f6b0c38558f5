/** The results as text. */
import type { Run } from './measure.ts';
import type { NativeRun } from './native.ts';
import type { Spread } from './quantile.ts';
import { boundMs, targetsOf } from './targets.ts';

export interface Result {
  run: Run;
  native: NativeRun;
}

/** Table 1 of the paper: seconds for one shape without a ghost, with the model's faces. */
const PAPER_TABLE_1: readonly { model: string; faces: number; seconds: number }[] = [
  { model: 'Cactus (10K)', faces: 10_000, seconds: 0.25 },
  { model: 'Centaur (32K)', faces: 32_000, seconds: 0.75 },
  { model: 'Elephant (80K)', faces: 80_000, seconds: 1.29 },
  { model: 'Armadillo (332K)', faces: 332_000, seconds: 6.5 },
  { model: 'Armadillo (1.3M)', faces: 1_300_000, seconds: 37.2 },
];

/** A number with about three digits. */
export function short(value: number): string {
  if (!Number.isFinite(value)) return '-';
  if (value !== 0 && Math.abs(value) < 0.01) return value.toExponential(1);
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}

/** A Markdown table, its columns as wide as their longest cell. */
export function table(titles: string[], rows: string[][]): string {
  const widths = titles.map((title, i) => Math.max(title.length, ...rows.map((row) => row[i]!.length)));
  const line = (cells: string[]): string => `| ${cells.map((cell, i) => cell.padStart(widths[i]!)).join(' | ')} |`;
  return [line(titles), `|${widths.map((width) => `${'-'.repeat(width + 1)}:`).join('|')}|`, ...rows.map(line)].join('\n');
}

const both = ({ median, slow }: Spread): string => `${short(median)} / ${short(slow)}`;

function buildTable(results: Result[]): string {
  const titles = ['faces', 'vertices', 'import', 'weld', 'encode', 'order', 'factor', 'whole', 'builds', 'silent', 'memory MB'];
  return table(titles, results.map(({ run }) => [
    String(run.faces), String(run.vertices), ...[run.importMs, run.weldMs, run.encodeMs, run.orderMs, run.factorMs, run.buildMs].map(short),
    String(run.builds), `${short(run.silentMs)} (${run.silentStage})`, (run.heapBytes / 2 ** 20).toFixed(0),
  ]));
}

function frameTable(results: Result[]): string {
  const titles = ['faces', 'first frame', 'spline + faces', 'solve', 'place', 'normals', 'frame', 'preview', 'factor MB', 'read GB/s', 'read bound', 'error'];
  return table(titles, results.map(({ run }) => [
    String(run.faces), short(run.firstMs), both(run.spline), both(run.solve), both(run.place), both(run.normals), both(run.frame), both(run.preview),
    (run.factorBytes / 1e6).toFixed(1), short(run.bandwidth / 1e9), short(boundMs(run)), run.error.toExponential(1),
  ]));
}

function solverTable(results: Result[]): string {
  const titles = ['unknowns', 'Eigen order', 'factor', 'solve', 'error', 'ours, native: order', 'factor', 'solve', 'error', 'in wasm: factor', 'solve'];
  return table(titles, results.map(({ run, native: { unknowns, eigen, single } }) => [
    String(unknowns), short(eigen.orderMs), short(eigen.factorMs), short(eigen.solveMs), eigen.error.toExponential(1),
    short(single.orderMs), short(single.factorMs), short(single.solveMs), single.error.toExponential(1),
    short(run.factorMs), short(run.solve.median),
  ]));
}

function paperTable(results: Result[]): string {
  const columns = PAPER_TABLE_1.flatMap((paper) => {
    const result = results.find(({ run }) => Math.abs(run.faces - paper.faces) < 0.03 * paper.faces);
    return result ? [{ paper, seconds: result.run.frame.median / 1000 }] : [];
  });
  if (columns.length === 0) return '';
  return `\nOne shape without a ghost (t_o of the paper's Table 1), seconds:\n\n${table(
    ['', ...columns.map(({ paper }) => paper.model)],
    [
      ['paper', ...columns.map(({ paper }) => short(paper.seconds))],
      ['here', ...columns.map(({ seconds }) => short(seconds))],
      ['times faster', ...columns.map(({ paper, seconds }) => short(paper.seconds / seconds))],
    ],
  )}\n`;
}

function targetTable(results: Result[]): string {
  const targets = results.flatMap(({ run, native }) => targetsOf(run, native));
  return table(['faces', 'target', 'limit', 'reached', ''], targets.map((target) => [
    String(target.faces), target.what, `${target.atLeast ? 'at least' : 'at most'} ${short(target.limit)}`, short(target.value),
    target.met ? 'met' : 'MISSED',
  ]));
}

export function report(title: string, results: Result[]): string {
  return `${title}

Three keys of a generated mesh; milliseconds; median / 95th percentile of single frames. "silent": the longest time without a
sign of progress, and what was reported after it. "error": largest distance to the shape computed in double, over the bounding box's diagonal.

Building a sequence:

${buildTable(results)}

A frame:

${frameTable(results)}

The second system, native Eigen LLT (one solve with three columns) beside our own solver:

${solverTable(results)}
${paperTable(results)}
Targets:

${targetTable(results)}
`;
}
