import { describe, expect, it } from 'vitest';
import { addKey, moveKey, removeKey, renameKey, retimeKey, setEncoding, setMotion, setPartTurns, setShaping } from '../../web/model/edits.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, referenceKey } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';

const doc: Doc = {
  keys: [{ pose: 0, name: 'a', time: 0 }, { pose: 1, name: 'b', time: 0.4 }, { pose: 2, name: 'c', time: 1 }],
  motion: { ...DEFAULT_MOTION }, encoding: { ...DEFAULT_ENCODING }, tension: [0, 0.5, 0], bias: [0, 0, -1], turns: [0, 1, 0],
  partTurns: [[], [{ component: 4, turns: 2 }], []],
};
const poses = (d: Doc): number[] => d.keys.map((key) => key.pose);
const times = (d: Doc): number[] => d.keys.map((key) => key.time);

describe('edits of keys', () => {
  it('move a shape to another place and leave the times where they are', () => {
    const next = moveKey(doc, 0, 2);
    expect(poses(next)).toEqual([1, 2, 0]);
    expect(times(next)).toEqual([0, 0.4, 1]);
    expect([next.tension, next.bias, next.turns]).toEqual([[0.5, 0, 0], [0, -1, 0], [1, 0, 0]]);
    expect(next.partTurns).toEqual([[{ component: 4, turns: 2 }], [], []]);
  });

  it('give a key another time, in order of time', () => {
    expect(times(retimeKey(doc, 1, 0.7))).toEqual([0, 0.7, 1]);
    const past = retimeKey(doc, 0, 0.5);
    expect(poses(past)).toEqual([1, 0, 2]);
    expect([past.tension, past.bias]).toEqual([[0.5, 0, 0], [0, 0, -1]]);
  });

  it('refuse a time that another key has', () => {
    expect(retimeKey(doc, 1, 1)).toBe(doc);
    expect(addKey(doc, { pose: 3, name: 'd', time: 0.4 })).toBe(doc);
  });

  it('add a key where its time belongs', () => {
    const next = addKey(doc, { pose: 3, name: 'd', time: 0.6 });
    expect(poses(next)).toEqual([0, 1, 3, 2]);
    expect([next.tension, next.bias]).toEqual([[0, 0.5, 0, 0], [0, 0, 0, -1]]);
    expect(next.partTurns).toEqual([[], [{ component: 4, turns: 2 }], [], []]);
  });

  it('give parts whole turns of their own, and take them away', () => {
    const next = setPartTurns(setPartTurns(doc, 1, 0, -1), 2, 7, 1);
    expect(next.partTurns).toEqual([[], [{ component: 0, turns: -1 }, { component: 4, turns: 2 }], [{ component: 7, turns: 1 }]]);
    expect(setPartTurns(next, 1, 4, 0).partTurns[1]).toEqual([{ component: 0, turns: -1 }]);
    expect(setPartTurns(next, 1, 4, 2)).toBe(next);
    expect(setPartTurns({ ...doc, partTurns: [] }, 1, 3, 0).partTurns).toEqual([]);
  });

  it('never leave fewer than two keys', () => {
    const two = removeKey(doc, 1);
    expect(poses(two)).toEqual([0, 2]);
    expect([two.tension, two.bias]).toEqual([[0, 0], [0, -1]]);
    expect(removeKey(two, 0)).toBe(two);
  });

  it('keep the reference with its pose, and fall back to the first key', () => {
    const chosen = setEncoding(doc, { referencePose: 2 });
    expect(referenceKey(chosen)).toBe(2);
    expect(referenceKey(moveKey(chosen, 2, 0))).toBe(0);
    expect(referenceKey(removeKey(chosen, 2))).toBe(0);
  });

  it('are the same document where nothing changes', () => {
    expect(renameKey(doc, 0, 'a')).toBe(doc);
    expect(renameKey(doc, 0, '')).toBe(doc);
    expect(moveKey(doc, 1, 1)).toBe(doc);
    expect(setMotion(doc, { boundary: 'natural' })).toBe(doc);
    expect(setShaping(doc, 'tension', 1, 0.5)).toBe(doc);
    expect(setShaping(doc, 'bias', 0, 0)).toBe(doc);
    expect(setShaping(doc, 'bias', 0, 0.25).bias).toEqual([0.25, 0, -1]);
  });
});
