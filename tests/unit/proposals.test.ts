/** When the page looks for options to propose, with a fake clock and a sheet of one fold. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { createProposals } from '../../web/app/analysis/proposals.ts';
import type { ProposalParts } from '../../web/app/analysis/proposals.ts';
// The fake clock does not wait for a file.
import '../../web/app/analysis/missed-lengths.ts';
import { setMotion } from '../../web/model/edits.ts';
import type { Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

/** Two triangles; `size` scales them. */
const folded = (size: number): Float32Array => Float32Array.of(0, 0, 0, size, 0, 0, 0, size, 0, size, size, 0);

function setUp(half = 0.9, found = true) {
  let doc: Doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
  let playing = false;
  let evaluated = 0;
  const motion = {
    keyTimes: [0, 1],
    options: {},
    shape: {
      motion: async () => ({ warnings: found ? [] : [{ code: 'lengths-not-fitted' }], dispose: () => undefined }),
    },
    shapePlane: async () => ({ weights: [0.5, 0.5] }),
    evaluateMany: async (times: number[]) => {
      evaluated += 1;
      return times.map(() => ({ positions: folded(half), release: () => undefined }));
    },
  };
  let pool = { keys: { positions: () => folded(1) } };
  const shown: (string | null)[] = [];
  let decline = (): void => undefined;
  const proposals = createProposals({
    session: {
      store: { get: () => ({ doc, play: { playing } }) },
      workspace: {
        info: { faces: Uint32Array.of(0, 1, 2, 2, 1, 3) },
        get pool() {
          return pool;
        },
      },
      sequence: () => motion,
    } as unknown as ProposalParts['session'],
    animation: () => null,
    ms: () => 1,
    isQuiet: () => false,
    onProposal(proposal) {
      shown.push(proposal?.action ?? null);
      if (proposal) decline = proposal.onDecline;
    },
  });
  return {
    proposals,
    shown,
    decline: () => decline(),
    evaluated: () => evaluated,
    rest: async () => {
      // The condition pauses between keys.
      for (let i = 0; i < 20; i += 1) await vi.advanceTimersByTimeAsync(500);
    },
    play: (on: boolean) => {
      playing = on;
    },
    edit: (change: Parameters<typeof setMotion>[1]) => {
      doc = setMotion(doc, change);
    },
    other: () => {
      pool = { ...pool };
    },
  };
}

it('proposes to keep lengths once the motion rests', async () => {
  const { proposals, shown, rest, play, evaluated } = setUp();
  play(true);
  proposals.follow();
  await rest();
  expect(evaluated()).toBe(0);
  play(false);
  await rest();
  expect(shown.at(-1)).toBe('Keep lengths');
});

it('proposes nothing where lengths are kept, by the motion or by the option, or cannot be', async () => {
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
