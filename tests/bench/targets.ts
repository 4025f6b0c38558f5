/** What is to be reached, as ratios within one run where machines differ. */
import { short, table } from './format.ts';
import type { RoundMedians } from './frames.ts';
import type { Run } from './measure.ts';
import { quantile } from './quantile.ts';
import type { Resolutions } from './resolutions.ts';

export interface Target {
  faces: number;
  what: string;
  value: number;
  /** The value must not be above or, for `atLeast`, below it. */
  limit: number;
  atLeast: boolean;
  met: boolean;
}

const GB = 2 ** 30;
/** Heaps grow in steps; rounding aside, a further sequence must not need one. */
const SAME_MEMORY = 1.02;

/** Milliseconds that reading the factor twice takes at that many bytes a second: no solve can be faster. */
export const boundMs = (run: Run, bandwidth: number): number => (2000 * run.factorBytes) / bandwidth;

/** Median over the rounds of frames. */
export const ofRounds = (run: Run, value: (round: RoundMedians) => number): number => quantile(run.exact.rounds.map(value));

function target(faces: number, what: string, value: number, limit: number, atLeast = false): Target {
  return { faces, what, value, limit, atLeast, met: atLeast ? value >= limit : value <= limit };
}

export function targetsOf(run: Run): Target[] {
  const targets: Target[] = [];
  const add = (what: string, value: number, limit: number, atLeast = false): void => {
    targets.push(target(run.faces, what, value, limit, atLeast));
  };
  const { builds, exact, cheap } = run;
  const medium = run.vertices > 160_000 && run.vertices < 600_000, large = run.vertices >= 600_000;
  if (medium || large) {
    add('solve / read bound', ofRounds(run, ({ solveMs, bandwidth }) => solveMs / boundMs(run, bandwidth)), 1.8);
    add('frame / solve', ofRounds(run, ({ frameMs, solveMs }) => frameMs / solveMs), 2.5);
    add("Eigen's solve / ours", ofRounds(run, ({ eigen, solveMs }) => eigen.solveMs / solveMs), large ? 7.5 : 6, true);
    add("Eigen's factorisation / ours", ofRounds(run, ({ eigen, factorMs }) => eigen.factorMs / factorMs), large ? 15 : 8, true);
  }
  if (run.faces <= 12_000) add('frame, ms', exact.frame.median, 1);
  else if (run.faces <= 36_000) add('frame, ms', exact.frame.median, 3);
  if (large) add('preview, ms', cheap.preview.median, 33);
  add('preview in the mean, % of the diagonal', 100 * cheap.agreement.mean, 0.1);
  add('preview at worst, % of the diagonal', 100 * cheap.agreement.worst, 0.5);
  add('error, 1e-5 of the diagonal', run.error / 1e-5, 1);
  add('silence while importing, ms', run.importSilence.ms, 250);
  add('silence while building, ms', builds.silence.ms, 250);
  if (large) add('wasm memory, GB', run.heapBytes / GB, 1.5);
  add('heap, fifth sequence / second', builds.heapGrowth, SAME_MEMORY);
  add('heap after ten refits / one', run.refitGrowth, SAME_MEMORY);
  // One heap that is not given back each time would make it three.
  if (Number.isFinite(builds.processGrowth)) add('process, second sequence to fifth, heaps', builds.processGrowth / builds.heapBytes, 1);
  return targets;
}

export function resolutionTarget({ fineFaces, distance }: Resolutions): Target {
  return target(fineFaces, 'two resolutions at worst, % of the diagonal', 100 * distance.worst, 0.5);
}

const limitText = ({ atLeast, limit }: Target): string => `${atLeast ? 'at least' : 'at most'} ${short(limit)}`;

export function targetTable(targets: Target[]): string {
  return table(['faces', 'target', 'limit', 'reached', ''], targets.map((one) =>
    [String(one.faces), one.what, limitText(one), short(one.value), one.met ? 'met' : 'MISSED']));
}

/** One sentence, which names what was missed. */
export function verdict(targets: Target[]): string {
  const missed = targets.filter(({ met }) => !met);
  if (missed.length === 0) return `All ${targets.length} targets were met.`;
  const list = missed.map((one) => `${one.what} at ${one.faces} faces (${short(one.value)}, ${limitText(one)})`);
  return `${missed.length} of ${targets.length} targets MISSED: ${list.join('; ')}.`;
}
