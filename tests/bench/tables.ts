/** What was measured of each size, as tables. */
import type { EigenRound } from './eigen.ts';
import { both, short, table } from './format.ts';
import type { RoundMedians } from './frames.ts';
import type { Run } from './measure.ts';
import type { NativeRun } from './native.ts';
import { quantile } from './quantile.ts';
import { boundMs, ofRounds } from './targets.ts';

export interface Result {
  run: Run;
  native: NativeRun;
}

const MB = 2 ** 20;
const percent = (share: number): string => short(100 * share);

export function buildTable(results: Result[]): string {
  const titles = ['faces', 'vertices', 'import', 'weld', 'encode', 'order', 'factor', 'arrange', 'whole', 'silent'];
  return table(titles, results.map(({ run: { builds, ...run } }) => [
    String(run.faces), String(run.vertices), ...[run.importMs, builds.weldMs, builds.encodeMs, builds.orderMs, builds.factorMs, builds.arrangeMs, builds.buildMs].map(short),
    [builds.silence, run.importSilence].map(({ ms, stage }) => `${short(ms)} (${stage})`).join(', import '),
  ]));
}

export function memoryTable(results: Result[]): string {
  const titles = ['faces', 'heap MB', 'fifth build / second', 'after ten refits / one', 'process grew by MB', 'factor MB'];
  return table(titles, results.map(({ run: { builds, ...run } }) => [
    String(run.faces), (run.heapBytes / MB).toFixed(0), short(builds.heapGrowth), short(run.refitGrowth),
    Number.isFinite(builds.processGrowth) ? String(Math.round(builds.processGrowth / MB) + 0) : '-', (run.factorBytes / 1e6).toFixed(1),
  ]));
}

export function frameTable(results: Result[]): string {
  const titles = ['faces', 'first frame', 'spline + faces', 'solve', 'place', 'normals', 'frame', 'read GB/s', 'read bound', 'error'];
  const bandwidth = (run: Run): number => ofRounds(run, (round) => round.bandwidth);
  return table(titles, results.map(({ run, run: { exact } }) => [
    String(run.faces), short(exact.firstMs), both(exact.spline), both(exact.solve), both(exact.place), both(exact.normals), both(exact.frame),
    short(bandwidth(run) / 1e9), short(boundMs(run, bandwidth(run))), run.error.toExponential(1),
  ]));
}

export function cheapTable(results: Result[]): string {
  const titles = ['faces', 'first', 'preview', 'exact', 'off in the mean %', 'at worst %'];
  return table(titles, results.map(({ run: { cheap, exact, ...run } }) => [
    String(run.faces), short(cheap.firstMs), both(cheap.preview), both(exact.frame), percent(cheap.agreement.mean), percent(cheap.agreement.worst),
  ]));
}

const ofEigen = (run: Run, value: keyof EigenRound): number => ofRounds(run, ({ eigen }) => eigen[value]);

/** Median of the rounds, and the lowest and highest of them: how steady the machine was. */
function steady({ exact: { rounds } }: Run, value: (round: RoundMedians) => number): string {
  const values = rounds.map(value);
  return `${short(quantile(values))} (${short(Math.min(...values))} to ${short(Math.max(...values))})`;
}

export function solverTable(results: Result[]): string {
  const titles = [
    'unknowns', 'Eigen order', 'factor', 'solve', 'error', 'ours, native: order', 'factor', 'solve', 'error', 'in wasm: factor', 'solve',
    'Eigen / in wasm: factor', 'solve',
  ];
  return table(titles, results.map(({ run, native: { unknowns, eigenOrderMs, single } }) => [
    String(unknowns), short(eigenOrderMs), short(ofEigen(run, 'factorMs')), short(ofEigen(run, 'solveMs')), ofEigen(run, 'error').toExponential(1),
    short(single.orderMs), short(single.factorMs), short(single.solveMs), single.error.toExponential(1),
    short(run.builds.factorMs), short(run.exact.solve.median),
    steady(run, ({ eigen, factorMs }) => eigen.factorMs / factorMs), steady(run, ({ eigen, solveMs }) => eigen.solveMs / solveMs),
  ]));
}
