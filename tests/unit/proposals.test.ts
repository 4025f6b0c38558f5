/** When the page looks for options to propose, with a fake clock and a sheet of one fold. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { createProposals } from '../../web/app/analysis/proposals.ts';
import type { ProposalParts } from '../../web/app/analysis/proposals.ts';
// The fake clock does not wait for a file.
import '../../web/app/analysis/proposal.ts';
import { setMotion } from '../../web/model/edits.ts';
import type { Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

/** Two triangles; `size` scales them. */
const folded = (size: number): Float32Array => Float32Array.of(0, 0, 0, size, 0, 0, 0, size, 0, size, size, 0);

/** `own`: size of the motion with own paths, beside an animation of size 1; null without an animation. */
function setUp(half = 0.9, found = true, own: number | null = null) {
  let doc: Doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
  let evaluated = 0;
  const made = {
    warnings: found ? [] : [{ code: 'lengths-not-fitted' }],
    evaluateMany: async () => [{ positions: folded(own!), release: () => undefined }],
    dispose: () => undefined,
  };
  const motion = {
    keyTimes: [0, 1],
    options: {},
    shape: { motion: async () => made },
    shapePlane: async () => ({ weights: [0.5, 0.5] }),
    evaluateMany: async (times: number[]) => {
      evaluated += 1;
      return times.map(() => ({ positions: folded(half), release: () => undefined }));
    },
  };
  let pool = { keys: { positions: () => folded(1) } };
  const shown: (string | null)[] = [];
  let message = '';
  let decline = (): void => undefined;
  const proposals = createProposals({
    session: {
      store: { get: () => ({ doc, play: { playing: true } }) },
      workspace: {
        info: { faces: Uint32Array.of(0, 1, 2, 2, 1, 3) },
        get pool() {
          return pool;
        },
      },
      sequence: () => motion,
    } as unknown as ProposalParts['session'],
    animation: () => (own === null ? null : { times: [0, 0.5, 1], at: () => folded(1) }),
    ms: () => 1,
    isQuiet: () => false,
    onProposal(proposal) {
      shown.push(proposal?.action ?? null);
      if (!proposal) return;
      decline = proposal.onDecline;
      message = proposal.message;
    },
  });
  return {
    proposals,
    shown,
    decline: () => decline(),
    message: () => message,
    evaluated: () => evaluated,
    rest: async () => {
      // The condition pauses between keys.
      for (let i = 0; i < 20; i += 1) await vi.advanceTimersByTimeAsync(500);
    },
    edit: (change: Parameters<typeof setMotion>[1]) => {
      doc = setMotion(doc, change);
    },
    other: () => {
      pool = { ...pool };
    },
  };
}

it('proposes to keep lengths while the motion plays', async () => {
  const { proposals, shown, rest } = setUp();
  proposals.follow();
  await rest();
  expect(shown.at(-1)).toBe('Keep lengths');
});

it('proposes nothing if lengths are kept, by the motion or by the option, or cannot be', async () => {
  const good = setUp(0.99);
  good.proposals.follow();
  await good.rest();
  expect([good.shown.at(-1), good.evaluated()]).toEqual([null, 1]);
  const none = setUp(0.9, false);
  none.proposals.follow();
  await none.rest();
  expect([none.shown.at(-1), none.evaluated()]).toEqual([null, 1]);
  const kept = setUp();
  kept.edit({ keepLengths: 1 });
  kept.proposals.follow();
  await kept.rest();
  expect([kept.shown.at(-1), kept.evaluated()]).toEqual([null, 0]);
});

it('stops when the motion changes, and asks once per shape', async () => {
  const { proposals, shown, rest, decline, evaluated, edit, other } = setUp();
  proposals.follow();
  edit({ boundary: 'periodic' });
  proposals.follow();
  await rest();
  expect(evaluated()).toBe(0);
  edit({ boundary: 'natural', hold: 'on' });
  proposals.follow();
  await rest();
  expect(shown.at(-1)).toBe('Keep lengths instead of holding');
  edit({ hold: 'off' });
  proposals.follow();
  await rest();
  expect(shown.at(-1)).toBe('Keep lengths');
  decline();
  proposals.follow();
  await rest();
  expect(shown.at(-1)).toBeNull();
  other();
  proposals.follow();
  await rest();
  expect(shown.at(-1)).toBe('Keep lengths');
});

it('proposes own paths where they are closer to the animation, with both errors', async () => {
  const closer = setUp(0.9, true, 0.95);
  closer.proposals.follow();
  await closer.rest();
  expect(closer.shown.at(-1)).toBe('Use own paths');
  const [, off, own] = /from ([\d.]+) % to ([\d.]+) %/.exec(closer.message())!;
  expect(Number(own) / Number(off)).toBeCloseTo(0.5, 2);
  closer.edit({ ownPaths: 'root' });
  closer.proposals.follow();
  await closer.rest();
  expect(closer.shown.at(-1)).toBeNull();
  const hardly = setUp(0.9, false, 0.901);
  hardly.proposals.follow();
  await hardly.rest();
  expect(hardly.shown.at(-1)).toBeNull();
});
