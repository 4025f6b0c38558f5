/** Measurements of each size as tables. */
import { both, msText, short, table } from './format.ts';
import type { KeysCost, KeysRun } from './key-counts.ts';
import type { Run } from './measure.ts';
import { PEER_NAMES, type NativeRound } from './native-round.ts';
import {
  boundMs,
  factorMs,
  frameOverSolve,
  ofNative,
  ofRounds,
  over,
  solveMs,
  solveOverBound,
  steady,
  untilFrameMs,
} from './ratios.ts';
import type { Swept, SweptParts } from './sweep.ts';

/** One closed smooth body, with three or eight keys, or several parts with open boundaries. */
export type Family = 'smooth' | 'eight keys' | 'parts';

const FAMILY_WORDS: Record<Family, string> = { smooth: '', 'eight keys': ' with eight keys', parts: ' in parts' };

export interface Result {
  family: Family;
  run: Run;
  /** Size of the system. */
  unknowns: number;
}

const MB = 2 ** 20;
const percent = (share: number): string => short(100 * share);

export const meshName = ({ family, run }: Result): string => `${run.faces} faces${FAMILY_WORDS[family]}`;

export function buildTable(results: Result[]): string {
  const titles = [
    'mesh',
    'vertices',
    'import',
    'weld',
    'join',
    'encode',
    'order',
    'factor',
    'arrange',
    'finish',
    'rest',
    'whole',
    'first frame',
    'bytes to first frame',
    'silent',
  ];
  return table(
    titles,
    results.map((result) => {
      const {
        run,
        run: { builds },
      } = result;
      return [
        meshName(result),
        String(run.vertices),
        ...[
          run.importMs,
          builds.weldMs,
          builds.joinMs,
          builds.encodeMs,
          builds.orderMs,
          builds.factorMs,
          builds.arrangeMs,
          builds.finishMs,
          builds.restMs,
          builds.buildMs,
          run.exact.firstMs,
          ofRounds(run, untilFrameMs),
        ].map(msText),
        [builds.silence, run.importSilence].map(({ ms, stage }) => `${msText(ms)} (${stage})`).join(', import '),
      ];
    }),
  );
}

export function memoryTable(results: Result[]): string {
  const titles = [
    'mesh',
    'heap MB',
    'heap / kept',
    'fifth build / second',
    'after ten refits / one',
    'process grew by MB',
    'factor MB',
  ];
  return table(
    titles,
    results.map((result) => {
      const {
        run,
        run: { builds },
      } = result;
      return [
        meshName(result),
        (run.heapBytes / MB).toFixed(0),
        short(builds.peakOverKept),
        short(builds.heapGrowth),
        short(run.refitGrowth),
        Number.isFinite(builds.processGrowth) ? String(Math.round(builds.processGrowth / MB) + 0) : '-',
        (run.factorBytes / 1e6).toFixed(1),
      ];
    }),
  );
}

export function frameTable(results: Result[]): string {
  const titles = [
    'mesh',
    'first frame',
    'patches',
    'faces',
    'solve',
    'place',
    'normals',
    'frame',
    'frame / solve',
    'read GB/s',
    'read bound',
    'solve / read bound',
  ];
  return table(
    titles,
    results.map((result) => {
      const {
        run,
        run: { exact },
      } = result;
      const bandwidth = ofRounds(run, (_, round) => round.bandwidth);
      return [
        meshName(result),
        msText(exact.firstMs),
        ...[exact.frames, exact.faces, exact.solve, exact.place, exact.normals, exact.frame].map(both),
        steady(run, frameOverSolve),
        short(bandwidth / 1e9),
        msText(boundMs(run, bandwidth)),
        steady(run, solveOverBound),
      ];
    }),
  );
}

const sweptCells = ({ mean, largestMean, worst, at }: Swept): string[] => [
  ...[mean, largestMean, worst].map(percent),
  at.toFixed(2),
];

/** A table of errors in % of the diagonal. */
export function errorTable(results: Result[]): string {
  const four = ['of one shape', 'worst', 'at t'];
  const titles = ['mesh', 'the exact frame and', 'between the keys: mean', ...four, 'in the margins: mean', ...four];
  return table(
    titles,
    results.flatMap((result) => {
      const { double, ghost } = result.run.errors;
      const row = (what: string, { inside, margins }: SweptParts): string[] => [
        meshName(result),
        what,
        ...sweptCells(inside),
        ...sweptCells(margins),
      ];
      return [row('double', double), ...(ghost ? [row('with a ghost', ghost)] : [])];
    }),
  );
}

const NATIVE: Record<keyof NativeRound, string> = {
  single: 'ours, single',
  double: 'ours, double',
  eigen: PEER_NAMES.eigen,
  cholmod: PEER_NAMES.cholmod,
};

/** One row for our solver in wasm and one for each native solver. */
export function solverTable(results: Result[]): string {
  const titles = [
    'mesh',
    'unknowns',
    'solver',
    'order',
    'factor',
    'solve',
    'entries, millions',
    'MB',
    'error',
    'factor / ours in wasm',
    'solve / ours in wasm',
  ];
  return table(
    titles,
    results.flatMap((result) => {
      const { run, unknowns } = result;
      const mesh = [meshName(result), String(unknowns)];
      const row = (solver: keyof NativeRound, name: string): string[] => {
        const of = (value: Parameters<typeof ofNative>[1]): number => ofRounds(run, ofNative(solver, value));
        return [
          ...mesh,
          name,
          ...[of('orderMs'), of('factorMs'), of('solveMs')].map(msText),
          short(of('entries') / 1e6),
          short(of('bytes') / 1e6),
          of('error').toExponential(1),
          steady(run, over(solver, 'factorMs')),
          steady(run, over(solver, 'solveMs')),
        ];
      };
      const inWasm = [run.builds.orderMs, ofRounds(run, factorMs), ofRounds(run, solveMs)].map(msText);
      const solvers = Object.entries(NATIVE) as [keyof NativeRound, string][];
      return [
        [...mesh, 'ours, single, in wasm', ...inWasm, '', short(run.factorBytes / 1e6), '', '', ''],
        ...solvers.filter(([solver]) => run.exact.rounds[0]?.native[solver]).map(([solver, name]) => row(solver, name)),
      ];
    }),
  );
}

/** Each mesh with few keys, then with increasing numbers of keys. */
export function keysTable(runs: KeysRun[]): string {
  const titles = ['mesh', 'keys', 'build', 'patches', 'faces', 'frame', 'frame / with few', 'keys / few', 'heap MB'];
  const row = (faces: number, cost: KeysCost, ratio: number, keys: number): string[] => [
    `${faces} faces`,
    String(cost.keys),
    msText(cost.buildMs),
    ...[cost.frames, cost.faces, cost.frame].map(both),
    short(ratio),
    short(keys),
    (cost.heapBytes / MB).toFixed(0),
  ];
  return table(
    titles,
    runs.flatMap(({ faces, few, many, ratio }, k) => [
      ...(faces === runs[k - 1]?.faces ? [] : [row(faces, few, 1, 1)]),
      row(faces, many, ratio, many.keys / few.keys),
    ]),
  );
}
