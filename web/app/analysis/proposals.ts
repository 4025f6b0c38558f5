/**
 * Proposes options of the shape spline that suit the open keys. Looks for them once the motion has been unchanged for a
 * while, also during playback, and stops when the motion changes.
 */
import type { Proposal, ProposalInput } from './proposal.ts';

export interface ProposalParts extends ProposalInput {
  /** Nothing is proposed now, because the page shows something else. */
  isQuiet(): boolean;
  /** null withdraws the proposal. */
  onProposal(proposal: (Proposal & { onDecline(): void }) | null): void;
}

export interface Proposals {
  /** The motion or the animation has changed. */
  follow(): void;
}

const UNCHANGED_MS = 1500;

export function createProposals(parts: ProposalParts): Proposals {
  const { session, isQuiet, onProposal } = parts;
  const declined = new WeakMap<object, Set<string>>();
  let stop = new AbortController();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let of: object | null = null;

  const look = async (signal: AbortSignal): Promise<void> => {
    const { pool } = session.workspace;
    if (!pool) return;
    const found = isQuiet() ? null : await (await import('./proposal.ts')).proposalFor(parts, signal);
    const no = declined.get(pool) ?? new Set();
    declined.set(pool, no);
    if (signal.aborted) return;
    onProposal(found && !no.has(found.action) ? { ...found, onDecline: () => no.add(found.action) } : null);
  };
  return {
    follow() {
      stop.abort();
      stop = new AbortController();
      clearTimeout(timer);
      // A proposal for the same keys stays until its condition has been looked at again.
      if (of !== session.workspace.pool) onProposal(null);
      of = session.workspace.pool;
      const { signal } = stop;
      // The shown motion reports failures. A motion that replaces this one calls again.
      timer = setTimeout(() => void look(signal).catch(() => undefined), UNCHANGED_MS);
    },
  };
}
