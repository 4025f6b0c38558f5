/**
 * Proposes options of the shape spline that suit the open keys. Looks for them when the motion has rested for a while,
 * and stops when it changes.
 */
import type { Motion as EngineMotion } from '../../engine/api/api.ts';
import { OWN_METHOD } from '../../engine/api/methods.ts';
import { motionOf } from '../../engine/api/options.ts';
import { departs, whyNoLengths, whyNoPaths } from '../../model/spline-options.ts';
import { setMotion } from '../../model/edits.ts';
import type { Motion } from '../../model/state.ts';
import type { TimedShapes } from '../../study/reference-motion.ts';
import type { Session } from '../session/session.ts';

export interface Proposal {
  message: string;
  action: string;
  change: Partial<Motion>;
}

export interface ProposalParts {
  session: Session;
  /** The animation of the keys, if it has been read. */
  animation(): TimedShapes | null;
  /** Milliseconds per frame. */
  ms(): number;
  /** Nothing is proposed now, because the page shows something else. */
  isQuiet(): boolean;
  /** null withdraws the proposal. */
  onProposal(proposal: (Proposal & { onDecline(): void }) | null): void;
}

export interface Proposals {
  /** The motion or the animation has changed. */
  follow(): void;
}

const REST_MS = 1500;
/** Own paths are proposed from this relative decrease of the error on. */
const LEAST_GAIN = 0.02;
/** Proposed number of shapes between two keys. */
const KEPT_BETWEEN = 1;

export function createProposals(parts: ProposalParts): Proposals {
  const { session, isQuiet, onProposal } = parts;
  const declined = new WeakMap<object, Set<string>>();
  let stop = new AbortController();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let of: object | null = null;

  const look = async (signal: AbortSignal): Promise<void> => {
    const { pool } = session.workspace;
    if (!pool) return;
    if (session.store.get().play.playing) return wait();
    const found = isQuiet() ? null : await proposalFor(parts, signal);
    const no = declined.get(pool) ?? new Set();
    declined.set(pool, no);
    if (signal.aborted) return;
    onProposal(found && !no.has(found.action) ? { ...found, onDecline: () => no.add(found.action) } : null);
  };
  const wait = (): void => {
    const { signal } = stop;
    // The shown motion reports failures. A motion that replaces this one calls again.
    timer = setTimeout(() => void look(signal).catch(() => undefined), REST_MS);
  };

  return {
    follow() {
      stop.abort();
      stop = new AbortController();
      clearTimeout(timer);
      // A proposal for the same keys stays until its condition has been looked at again.
      if (of !== session.workspace.pool) onProposal(null);
      of = session.workspace.pool;
      wait();
    },
  };
}

async function proposalFor(
  { session: { store, workspace, sequence }, animation, ms }: ProposalParts,
  signal: AbortSignal,
): Promise<Proposal | null> {
  const { doc } = store.get();
  const { info, pool } = workspace;
  const motion = sequence();
  if (!motion || !info || !pool || doc.motion.method !== OWN_METHOD || doc.motion.keepLengths > 0) return null;
  const reference = animation();
  if (reference && doc.motion.ownPaths === 'off' && !whyNoPaths(doc)) {
    const { ownPathsGain } = await import('./own-paths-gain.ts');
    const { off, own } = await ownPathsGain({ motion, reference, ms: ms(), signal });
    if (own < (1 - LEAST_GAIN) * off) return ownPathsProposal(off, own);
  }
  // Holding is on by default for keys from an animation, which can be cloth.
  const loose = setMotion(doc, { hold: 'off' });
  if (departs(loose) || whyNoLengths(loose)) return null;
  const { missedLengths } = await import('./missed-lengths.ts');
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
    message: `Own paths of faces are closer to the animation. Error against it: ${percent(off)} → ${percent(own)}.`,
    action: 'Use own paths',
    change: { ownPaths: 'absolute' },
  };
}

function lengthsProposal(missed: number, holds: boolean): Proposal {
  return {
    message: `The keys keep the lengths of edges. The shapes between them are off by up to ${(100 * missed).toFixed(1)} %.`,
    action: holds ? 'Keep lengths instead of holding' : 'Keep lengths',
    change: { keepLengths: KEPT_BETWEEN, ...(holds && { hold: 'off' as const }) },
  };
}
