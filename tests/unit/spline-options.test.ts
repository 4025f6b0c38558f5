/** Options of the shape spline in the page: what rules them out, and what the motions get. */
import { expect, it } from 'vitest';
import { buildKey, sequencePlan } from '../../web/app/session/sequence-plan.ts';
import { motionFor } from '../../web/engine/api/method-options.ts';
import { setMotion, setTurns } from '../../web/model/edits.ts';
import { departsFromPaper, keepLengthsConflict } from '../../web/model/spline-options.ts';
import { DEFAULT_VIEW } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const plain = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
const kept = setMotion(plain, { keepLengths: 2 });

const lengthsOf = (doc: Doc): number => {
  const plan = sequencePlan(doc);
  return motionFor(plan.motion, plan.variants[0]!).keepLengths;
};

it('lengths can be kept with natural ends, without holding and added turns', () => {
  expect(lengthsOf(kept)).toBe(2);
  for (const [doc, why] of [
    [setMotion(kept, { boundary: 'periodic' }), 'boundary'],
    [setMotion(kept, { hold: 'on' }), 'hold'],
    [setMotion(kept, { pins: [{ vertex: 0, radius: 0.1 }] }), 'pins'],
    [setTurns(kept, 1, { turns: 1 }), 'turns'],
  ] as const) {
    expect(keepLengthsConflict(doc)).toBe(why);
    expect(lengthsOf(doc)).toBe(0);
    // The choice stays in the document.
    expect(doc.motion.keepLengths).toBe(2);
  }
});

it('a motion with kept lengths is compared with the published one', () => {
  expect(departsFromPaper(plain)).toBe(false);
  expect(departsFromPaper(kept)).toBe(true);
  const plan = sequencePlan(kept, { ...DEFAULT_VIEW, compare: ['lri', 'geodesic'] });
  expect(plan.variants.map(({ plain: published }) => published)).toEqual([undefined, true, undefined]);
  for (const variant of plan.variants.slice(1))
    expect(motionFor(plan.motion, variant)).toMatchObject({ keepLengths: 0 });
});

it('shapes are fitted again on another mesh or at other times, and other motions stay', () => {
  for (const [doc, again] of [
    [setMotion(plain, { method: 'lengths' }), true],
    [setMotion(plain, { method: 'shell' }), true],
    [kept, true],
    [plain, false],
  ] as const)
    for (const change of [{ spaceFaces: 500 }, { spaceSamples: 12 }]) {
      const plan = sequencePlan(setMotion(doc, change));
      expect(motionFor(plan.motion, plan.variants[0]!)).toMatchObject(change);
      expect(buildKey(plan) !== buildKey(sequencePlan(doc))).toBe(again);
    }
});
