import { describe, expect, it } from 'vitest';
import {
  addKey,
  moveKey,
  removeKey,
  renameKey,
  retimeKey,
  reverseMotion,
  setEncoding,
  setMotion,
  setShaping,
  setTightness,
  spaceKeys,
  tightness,
  setTurns,
} from '../../web/model/edits.ts';
import { DEFAULT_SHAPING, listsOf, shapingOf } from '../../web/model/shaping.ts';
import { referenceKey } from '../../web/model/state.ts';
import type { Doc } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const ofB = { tension: 0.5, earlier: 0.1, swing: 0.5, turns: [{ turns: 1 }, { component: 4, turns: 2 }] };
const doc = docOfKeys(
  keyRef(0, 'a', 0, { earlier: 0.3, swing: 1 }),
  keyRef(1, 'b', 0.4, ofB),
  keyRef(2, 'c', 1, { bias: -1, earlier: 0.2 }),
);
/** Every key with its options. */
const shapings = {
  0: { ...DEFAULT_SHAPING, earlier: 0.3, swing: 1 },
  1: { ...DEFAULT_SHAPING, ...ofB },
  2: { ...DEFAULT_SHAPING, bias: -1, earlier: 0.2 },
  3: DEFAULT_SHAPING,
};
const expectShapings = (d: Doc): void =>
  expect(Object.fromEntries(d.keys.map(({ pose, shaping }) => [pose, shaping]))).toMatchObject(
    Object.fromEntries(d.keys.map(({ pose }) => [pose, shapings[pose as 0 | 1 | 2 | 3]])),
  );
const poses = (d: Doc): number[] => d.keys.map((key) => key.pose);
const times = (d: Doc): number[] => d.keys.map((key) => key.time);

/** A region whose numbers are those of the keys. */
const withRegion = (d: Doc): Doc => {
  const [earlier, swing] = (['earlier', 'swing'] as const).map((name) => d.keys.map(({ shaping }) => shaping[name]));
  return setMotion(d, { regions: [{ faces: [0, 4], earlier: earlier!, swing: swing!, soft: true }] });
};

describe('edits of keys', () => {
  it('move the numbers of regions with their keys, as the numbers of the whole', () => {
    const start = withRegion(doc);
    const key = { pose: 3, name: 'new' };
    for (const next of [
      moveKey(start, 0, 2),
      removeKey(start, 1),
      retimeKey(start, 0, 0.5),
      addKey(start, { ...key, time: 0.2 }),
      addKey(start, { ...key, time: 2 }),
      addKey(start, { ...key, time: -1 }),
      reverseMotion(start),
      setMotion(start, { endSpeed: 0 }),
    ])
      expect(next.motion.regions).toEqual(withRegion(next).motion.regions);
  });

  it('move a shape to another place without changing the times', () => {
    const next = moveKey(doc, 0, 2);
    expect(poses(next)).toEqual([1, 2, 0]);
    expect(times(next)).toEqual([0, 0.4, 1]);
    expectShapings(next);
  });

  it('give a key another time, in order of time', () => {
    expect(times(retimeKey(doc, 1, 0.7))).toEqual([0, 0.7, 1]);
    const past = retimeKey(doc, 0, 0.5);
    expect(poses(past)).toEqual([1, 0, 2]);
    expectShapings(past);
  });

  it('reverse the motion with all options of its keys; reversing twice changes nothing', () => {
    const pins = [{ vertex: 7, radius: 0.1, stay: 2, path: [0.25, 0.5].map((time) => ({ time, move: [time, 0, 0] })) }];
    const start = setMotion(setEncoding(doc, { startTangentPose: 1, referencePose: 0 }), {
      startSpeed: 0,
      endSpeed: 2,
      pins: pins as Doc['motion']['pins'],
    });
    const next = reverseMotion(start);
    expect(poses(next)).toEqual([2, 1, 0]);
    expect(times(next)).toEqual([0, 0.6, 1]);
    expect(next.keys.map(({ shaping }) => shaping.bias)).toEqual([1, 0, 0]);
    // Turns between the first and second key change sign when reversed.
    expect(next.keys.map(({ shaping }) => shaping.turns)).toEqual([
      [],
      [],
      [{ turns: -1 }, { component: 4, turns: -2 }],
    ]);
    // So does the timing of each interval. The last one closes a loop.
    expect(next.keys.map(({ shaping: { earlier, swing } }) => [earlier, swing])).toEqual([
      [-0.1, 0.5],
      [-0.3, 1],
      [-0.2, 0],
    ]);
    expect(next.motion).toMatchObject({ startSpeed: 2, endSpeed: 0 });
    expect(next.motion.pins[0]!.path).toEqual([
      { time: 0.5, move: [0.5, 0, 0] },
      { time: 0.75, move: [0.25, 0, 0] },
    ]);
    expect(next.encoding).toMatchObject({ startTangentPose: null, endTangentPose: 1, referencePose: 0 });
    expect(poses(next)[referenceKey(next)]).toBe(0);
    expect(reverseMotion(next)).toEqual(start);
  });

  it('refuse a time that another key has', () => {
    expect(retimeKey(doc, 1, 1)).toBe(doc);
    for (const time of [1e300, -1e10, NaN]) expect(retimeKey(doc, 1, time)).toBe(doc);
    expect(addKey(doc, { pose: 3, name: 'd', time: 0.4 })).toBe(doc);
  });

  it('add a key at the place of its time, with default timing before and after it', () => {
    const next = addKey(doc, { pose: 3, name: 'd', time: 0.6 });
    expect(poses(next)).toEqual([0, 1, 3, 2]);
    expect(next.keys.map(({ shaping }) => shaping)).toEqual([
      shapings[0],
      { ...shapings[1], earlier: 0, swing: 0 },
      DEFAULT_SHAPING,
      shapings[2],
    ]);
    const first = addKey(doc, { pose: 3, name: 'd', time: -1 });
    expect(first.keys.map(({ shaping }) => shaping.earlier)).toEqual([0, 0.3, 0.1, 0]);
  });

  it('add full turns to the shape and its parts, and remove them', () => {
    const turns = (d: Doc): object[] => d.keys.map(({ shaping }) => shaping.turns);
    const next = setTurns(setTurns(doc, 1, { component: 0, turns: -1 }), 2, { component: 7, turns: 1 });
    expect(turns(next)).toEqual([
      [],
      [{ turns: 1 }, { component: 0, turns: -1 }, { component: 4, turns: 2 }],
      [{ component: 7, turns: 1 }],
    ]);
    expect(turns(setTurns(next, 1, { component: 4, turns: 0 }))[1]).toEqual([
      { turns: 1 },
      { component: 0, turns: -1 },
    ]);
    expect(turns(setTurns(next, 1, { turns: 0 }))[1]).toEqual([
      { component: 0, turns: -1 },
      { component: 4, turns: 2 },
    ]);
    expect(setTurns(next, 1, { component: 4, turns: 2 })).toBe(next);
    expect(setTurns(doc, 0, { component: 3, turns: 0 })).toBe(doc);
  });

  it('never leave fewer than two keys', () => {
    const two = removeKey(doc, 1);
    expect(poses(two)).toEqual([0, 2]);
    expectShapings(two);
    expect(removeKey(two, 0)).toBe(two);
  });

  it('give an end at rest the usual speed if a tangent pose is chosen', () => {
    const eased = setMotion(doc, { boundary: 'hermite', startSpeed: 0, endSpeed: 0 });
    const led = setEncoding(eased, { startTangentPose: 1 });
    expect(led.motion).toMatchObject({ startSpeed: 1, endSpeed: 0 });
    expect(setEncoding(setMotion(led, { startSpeed: 0 }), { startTangentPose: null }).motion.startSpeed).toBe(0);
    expect(setEncoding(setMotion(doc, { startSpeed: 2 }), { startTangentPose: 1 }).motion.startSpeed).toBe(2);
  });

  it('keep the reference with its pose, and fall back to the first key', () => {
    const chosen = setEncoding(doc, { referencePose: 2 });
    expect(referenceKey(chosen)).toBe(2);
    expect(referenceKey(moveKey(chosen, 2, 0))).toBe(0);
    expect(referenceKey(removeKey(chosen, 2))).toBe(0);
  });

  it('return the same document if nothing changes', () => {
    expect(renameKey(doc, 0, 'a')).toBe(doc);
    expect(renameKey(doc, 0, '').keys[0]!.name).toBe('');
    expect(moveKey(doc, 1, 1)).toBe(doc);
    expect(setMotion(doc, { boundary: 'natural' })).toBe(doc);
    expect(setShaping(doc, 'tension', 1, 0.5)).toBe(doc);
    expect(setShaping(doc, 'bias', 0, 0)).toBe(doc);
    expect(setShaping(doc, 'bias', 0, 0.25).keys.map(({ shaping }) => shaping.bias)).toEqual([0.25, 0, -1]);
  });
});

describe('options of each key', () => {
  it('become the lists of the engine, and are read back from them', () => {
    const all = doc.keys.map(({ shaping }) => shaping);
    const lists = listsOf(all);
    expect(lists).toMatchObject({
      tension: [0, 0.5, 0],
      bias: [0, 0, -1],
      turns: [
        { key: 1, turns: 1 },
        { key: 1, component: 4, turns: 2 },
      ],
    });
    expect(all.map((_, key) => shapingOf(lists, key))).toEqual(all);
    expect(new Set(Object.values(listsOf([DEFAULT_SHAPING, DEFAULT_SHAPING])).flat())).toEqual(new Set());
  });
});

describe('all keys at once', () => {
  it('have one tension, or one each', () => {
    const tight = setTightness(doc, 0.5);
    expect(tight.keys.map(({ shaping }) => shaping.tension)).toEqual(doc.keys.map(() => 0.5));
    expect(tightness(tight)).toBe(0.5);
    expect(setTightness(tight, 0.5)).toBe(tight);
    const each = setTightness(doc, [0, 0.25, 1]);
    expect(each.keys.map(({ shaping }) => shaping.tension)).toEqual([0, 0.25, 1].slice(0, doc.keys.length));
  });

  it('are spaced evenly or by their distances, between the first time and the last', () => {
    const [first, last] = [doc.keys[0]!.time, doc.keys.at(-1)!.time];
    const share = (power: number, distance: number[]): number =>
      (spaceKeys(doc, distance, power).keys[1]!.time - first) / (last - first);
    expect(share(0, [1, 3])).toBeCloseTo(1 / 2, 12);
    expect(share(0.5, [1, 9])).toBeCloseTo(1 / 4, 12);
    expect(share(1, [1, 3])).toBeCloseTo(1 / 4, 12);
    expect(spaceKeys(doc, [1, 3], 1).keys.at(-1)!.time).toBe(last);
  });

  it('have different times if two or all shapes are equal', () => {
    const times = spaceKeys(doc, [0, 5], 1).keys.map(({ time }) => time);
    expect(times[1]!).toBeGreaterThan(times[0]!);
    const even = spaceKeys(doc, [0, 0], 1).keys.map(({ time }) => time);
    expect(even[1]! - even[0]!).toBeCloseTo(even[2]! - even[1]!, 12);
  });
});
