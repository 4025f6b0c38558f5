/** Targets for users, and whether they were met. Other numbers are in the tables only. */
import { short, table } from './format.ts';
import type { KeysRun } from './key-counts.ts';
import type { Run } from './measure.ts';
import { PEERS, PEER_NAMES } from './native-round.ts';
import { ofRounds, over, untilFrameMs } from './ratios.ts';
import type { Resolutions } from './resolutions.ts';

export interface Target {
  mesh: string;
  what: string;
  value: number;
  /** Upper limit or, for `atLeast`, lower limit. */
  limit: number;
  atLeast: boolean;
  met: boolean;
}

const GB = 2 ** 30;
/** Largest sizes for 60 and for 30 frames per second; larger shapes have 10. */
const SIXTY_A_SECOND = 100_000,
  THIRTY_A_SECOND = 400_000;
/** The heap of a smaller mesh is too small to matter. */
const MIN_FACES_FOR_HEAP = 80_000;
/** Heaps grow in steps. Up to rounding, another sequence must not need another step. */
const SAME_MEMORY = 1.02;

function target(mesh: string, what: string, value: number, limit: number, atLeast = false): Target {
  return { mesh, what, value, limit, atLeast, met: atLeast ? value >= limit : value <= limit };
}

/** `mesh`: its name in the tables. */
export function targetsOf(mesh: string, run: Run): Target[] {
  const targets: Target[] = [];
  const add = (what: string, value: number, limit: number, atLeast = false): void => {
    targets.push(target(mesh, what, value, limit, atLeast));
  };
  const { faces, builds, exact, errors } = run;
  const small = faces <= SIXTY_A_SECOND,
    large = faces > THIRTY_A_SECOND;
  add('bytes to first frame, s', ofRounds(run, untilFrameMs) / 1000, small ? 1 : large ? 10 : 2);
  add('frame, ms', exact.frame.median, 1000 / (small ? 60 : large ? 10 : 30));
  if (!small)
    for (const peer of PEERS) {
      if (!exact.rounds[0]?.native[peer]) continue;
      add(`${PEER_NAMES[peer]}'s factorisation / ours`, ofRounds(run, over(peer, 'factorMs')), 1, true);
      add(`${PEER_NAMES[peer]}'s solve / ours`, ofRounds(run, over(peer, 'solveMs')), 1, true);
    }
  add(
    'off native double, 1e-6 of the diagonal',
    1e6 * Math.max(errors.double.inside.worst, errors.double.margins.worst),
    1,
  );
  add('silence while importing, ms', run.importSilence.ms, 250);
  add('silence while building, ms', builds.silence.ms, 250);
  if (large) add('wasm memory, GB', run.heapBytes / GB, 1.5);
  if (faces >= MIN_FACES_FOR_HEAP) add('heap / what is kept of it', builds.peakOverKept, 1.3);
  add('heap, fifth sequence / second', builds.heapGrowth, SAME_MEMORY);
  add('heap after ten refits / one', run.refitGrowth, SAME_MEMORY);
  // A heap that is leaked each time would make the ratio three.
  if (Number.isFinite(builds.processGrowth))
    add('process, second sequence to fifth, heaps', builds.processGrowth / builds.heapBytes, 1);
  return targets;
}

export function resolutionTarget({ fineFaces, distance }: Resolutions): Target {
  return target(`${fineFaces} faces`, 'two resolutions at worst, % of the diagonal', 100 * distance.worst, 0.5);
}

/** Less than linear: the frame time must grow by a smaller factor than the number of keys. */
export function keysTarget({ faces, few, many, ratio }: KeysRun): Target {
  return target(`${faces} faces`, `frame with ${many.keys} keys / with ${few.keys}`, ratio, many.keys / few.keys);
}

const limitText = ({ atLeast, limit }: Target): string => `${atLeast ? 'at least' : 'at most'} ${short(limit)}`;

export function targetTable(targets: Target[]): string {
  return table(
    ['mesh', 'target', 'limit', 'reached', ''],
    targets.map((one) => [one.mesh, one.what, limitText(one), short(one.value), one.met ? 'met' : 'MISSED']),
  );
}

/** One sentence that names the missed targets. */
export function verdict(targets: Target[]): string {
  const missed = targets.filter(({ met }) => !met);
  if (missed.length === 0) return `All ${targets.length} targets were met.`;
  const list = missed.map((one) => `${one.what} at ${one.mesh} (${short(one.value)}, ${limitText(one)})`);
  return `${missed.length} of ${targets.length} targets MISSED: ${list.join('; ')}.`;
}
