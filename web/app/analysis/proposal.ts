/** The option of the shape spline that suits the open keys, if one does. */
import type { Motion as EngineMotion } from '../../engine/api/api.ts';
import { OWN_METHOD } from '../../engine/api/methods.ts';
import { motionOf } from '../../engine/api/options.ts';
import { setMotion } from '../../model/edits.ts';
import { departs, whyNoLengths, whyNoPaths } from '../../model/spline-options.ts';
import type { Motion } from '../../model/state.ts';
import { missedLengths } from './missed-lengths.ts';
import { ownPathsGain } from './own-paths-gain.ts';
import type { TimedShapes } from '../../study/reference-motion.ts';
import type { Session } from '../session/session.ts';

export interface ProposalInput {
  session: Session;
  /** The animation of the keys, if it has been read. */
  animation(): TimedShapes | null;
  /** Milliseconds per frame. */
  ms(): number;
}

export interface Proposal {
  message: string;
  action: string;
  change: Partial<Motion>;
}

/** Own paths are proposed from this relative decrease of the error on. */
const LEAST_GAIN = 0.02;
/** Proposed number of shapes between two keys. */
const KEPT_BETWEEN = 1;

export async function proposalFor(
  { session: { store, workspace, sequence }, animation, ms }: ProposalInput,
  signal: AbortSignal,
): Promise<Proposal | null> {
  const { doc } = store.get();
  const { info, pool } = workspace;
  const motion = sequence();
  if (!motion || !info || !pool || doc.motion.method !== OWN_METHOD || doc.motion.keepLengths > 0) return null;
  const reference = animation();
  if (reference && doc.motion.ownPaths === 'off' && !whyNoPaths(doc)) {
    const { off, own } = await ownPathsGain({ motion, reference, ms: ms(), signal });
    if (own < (1 - LEAST_GAIN) * off) return ownPathsProposal(off, own);
  }
  // Holding is on by default for keys from an animation, which can be cloth.
  const loose = setMotion(doc, { hold: 'off' });
  if (departs(loose) || whyNoLengths(loose)) return null;
  const key = (index: number): Float32Array => pool.keys.positions(doc.keys[index]!.pose);
  const missed = await missedLengths({ motion, faces: info.faces, keys: doc.keys.length, key, signal });
  if (missed === null || !(await canKeep(motion, signal))) return null;
  return lengthsProposal(missed, departs(doc));
}

/** Whether shapes that keep lengths are found between all keys. On folded sheets, they are not. */
async function canKeep({ shape, options, keyTimes }: EngineMotion, signal: AbortSignal): Promise<boolean> {
  const wanted = { ...motionOf(options), hold: 'off' as const, keepLengths: KEPT_BETWEEN, keyTimes: [...keyTimes] };
  const kept = await shape.motion(wanted, { signal });
  const found = !kept.warnings.some(({ code }) => code === 'lengths-not-fitted');
  kept.dispose();
  return found;
}

function ownPathsProposal(off: number, own: number): Proposal {
  const percent = (value: number): string => `${value.toFixed(2)} %`;
  return {
    message: `If each face rotates on its own path, the error against the animation falls from ${percent(off)} to ${percent(own)}.`,
    action: 'Use own paths',
    change: { ownPaths: 'absolute' },
  };
}

function lengthsProposal(missed: number, holds: boolean): Proposal {
  return {
    message: `Between the keys, lengths of edges are off by up to ${(100 * missed).toFixed(1)} %.`,
    action: holds ? 'Keep lengths instead of holding' : 'Keep lengths',
    change: { keepLengths: KEPT_BETWEEN, ...(holds && { hold: 'off' as const }) },
  };
}
