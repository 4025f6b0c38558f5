/** Edits of the document: each takes a document and returns the next, or the same one if nothing changes. */
import { MAX_TIME } from '../engine/api/option-table.ts';
import { spacedTimes } from './key-spacing.ts';
import type { KeyTurns, Shaping, ShapingNumber } from './shaping.ts';
import { DEFAULT_SHAPING, turnsOf, withPlainInterval, withTurns } from './shaping.ts';
import type { Doc, Encoding, KeyRef, Motion } from './state.ts';
import { DEFAULT_SPEED, SPEED_NAME, TANGENT_NAME } from './speeds.ts';
import { referenceKey } from './state.ts';
import { SAME_TIME, clamp } from './time-scale.ts';
import type { Timing } from './timing-presets.ts';
import { regionsOfKeys, reversedRegions } from './timing-regions.ts';

/** Moves a key in the order. Times stay in place; shapes move. */
export function moveKey(doc: Doc, from: number, to: number): Doc {
  const target = clamp(to, 0, doc.keys.length - 1);
  if (from === target || !doc.keys[from]) return doc;
  const order = [...doc.keys.keys()];
  order.splice(target, 0, ...order.splice(from, 1));
  return ordered(
    doc,
    order.map((key, index) => ({ ...doc.keys[key]!, time: doc.keys[index]!.time })),
    order,
  );
}

/** A motion needs two keys, so the last two stay. */
export function removeKey(doc: Doc, index: number): Doc {
  if (doc.keys.length <= 2 || !doc.keys[index]) return doc;
  const left = [...doc.keys.keys()].filter((other) => other !== index);
  return ordered(
    doc,
    left.map((key) => doc.keys[key]!),
    left,
  );
}

/** Changes a key's time and, if it passes a neighbour, its order. Refuses the time of another key and invalid times. */
export function retimeKey(doc: Doc, index: number, time: number): Doc {
  const key = doc.keys[index];
  if (
    !key ||
    key.time === time ||
    !(Math.abs(time) <= MAX_TIME) ||
    doc.keys.some((other, at) => at !== index && other.time === time)
  )
    return doc;
  return sorted(doc, withKey(doc, index, { time }).keys);
}

export function renameKey(doc: Doc, index: number, name: string): Doc {
  if (doc.keys[index]?.name === name) return doc;
  return withKey(doc, index, { name });
}

/** Adds a key in time order, with default smooth options. The intervals before and after it get default ones, too. */
export function addKey(doc: Doc, key: Omit<KeyRef, 'shaping'>): Doc {
  if (doc.keys.some((other) => other.time === key.time)) return doc;
  const before = doc.keys.findLastIndex(({ time }) => time < key.time);
  const plain = reshaped(doc, before < 0 ? doc.keys.length - 1 : before, withPlainInterval);
  return sorted(plain, [...plain.keys, { ...key, shaping: DEFAULT_SHAPING }]);
}

/** Position for new keys: before the key of this number, or at this time. */
export type InsertPosition = { before: number } | { time: number };

/**
 * Times for new keys. A single key gets the requested time, if free. Several are spread evenly between their
 * neighbours; beyond the ends they use the keys' mean distance.
 */
export function timesAt({ keys }: Doc, place: InsertPosition, count: number): number[] {
  if ('time' in place && count === 1 && !isTaken(keys, place.time)) return [place.time];
  const at = 'before' in place ? place.before : keys.filter(({ time }) => time <= place.time).length;
  return timesBefore(keys, at, count);
}

/** Whether a key is at this time or too close to it for another key. */
export function isTaken(keys: readonly Pick<KeyRef, 'time'>[], t: number): boolean {
  const whole = (keys.at(-1)?.time ?? 0) - (keys[0]?.time ?? 0);
  return keys.some(({ time }) => Math.abs(time - t) <= 1000 * SAME_TIME * whole);
}

function timesBefore(keys: Doc['keys'], place: number, count: number): number[] {
  const first = keys[0]?.time ?? 0;
  const last = keys.at(-1)?.time ?? 0;
  const step = (last - first) / Math.max(keys.length - 1, 1) || 1;
  const [before, after] = [keys[place - 1]?.time, keys[place]?.time];
  return Array.from({ length: count }, (_, index) => {
    if (after === undefined) return last + step * (index + 1);
    if (before === undefined) return first - step * (count - index);
    return before + ((after - before) * (index + 1)) / (count + 1);
  });
}

export function setShaping(doc: Doc, name: ShapingNumber, index: number, value: number): Doc {
  return reshaped(doc, index, (shaping) => (shaping[name] === value ? shaping : { ...shaping, [name]: value }));
}

/** Timing of the interval after a key. */
export function setTiming(doc: Doc, index: number, timing: Timing): Doc {
  return setShaping(setShaping(doc, 'earlier', index, timing.earlier), 'swing', index, timing.swing);
}

/** One tension for all keys, or one per key. */
export function setTightness(doc: Doc, tension: number | readonly number[]): Doc {
  const at = (index: number): number => (typeof tension === 'number' ? tension : (tension[index] ?? 0));
  return doc.keys.reduce((next, _, index) => setShaping(next, 'tension', index, at(index)), doc);
}

/** Respaces the keys between the first and last time by their distances (`spacedTimes`). */
export function spaceKeys(doc: Doc, distance: readonly number[], power: number): Doc {
  const [first, last] = [doc.keys[0]?.time ?? 0, doc.keys.at(-1)?.time ?? 0];
  const times = spacedTimes(first, last, distance, power);
  if (doc.keys.every(({ time }, index) => time === times[index])) return doc;
  return { ...doc, keys: doc.keys.map((key, index) => ({ ...key, time: times[index]! })) };
}

/**
 * Reverses the motion between the same times: t becomes first + last - t. Between keys with large rotations the result
 * differs slightly, because successive rotations do not commute.
 */
export function reverseMotion(doc: Doc): Doc {
  const { keys, motion, encoding } = doc;
  const both = (keys[0]?.time ?? 0) + (keys.at(-1)?.time ?? 0);
  const mirrored = <T extends { time: number }>(ones: readonly T[]): T[] =>
    ones.map((one) => ({ ...one, time: both - one.time })).reverse();
  const shapings = keys.map(({ shaping }, index): Shaping => {
    // Each key takes the turns of the following interval, and the timing of the previous one, reversed.
    const way = keys[index + 1]?.shaping.turns ?? [];
    const { earlier, swing } = keys.at(index - 1)!.shaping;
    return {
      ...shaping,
      bias: -shaping.bias + 0,
      earlier: -earlier + 0,
      swing,
      turns: way.map((one) => ({ ...one, turns: -one.turns })),
    };
  });
  return {
    keys: mirrored(keys.map((key, index) => ({ ...key, shaping: shapings[index]! }))),
    motion: {
      ...motion,
      startSpeed: motion.endSpeed,
      endSpeed: motion.startSpeed,
      regions: reversedRegions(motion.regions),
      pins: motion.pins.map((pin) => (pin.path ? { ...pin, path: mirrored(pin.path) } : pin)),
    },
    encoding: {
      ...encoding,
      referencePose: keys[referenceKey(doc)]?.pose ?? null,
      startTangentPose: encoding.endTangentPose,
      endTangentPose: encoding.startTangentPose,
    },
  };
}

/** Mean tension of the keys. */
export function tightness({ keys }: Doc): number {
  return keys.reduce((sum, { shaping }) => sum + shaping.tension, 0) / Math.max(keys.length, 1);
}

/** Full turns between the previous key and this one; 0 removes them. */
export function setTurns(doc: Doc, index: number, added: KeyTurns): Doc {
  return reshaped(doc, index, (shaping) =>
    turnsOf(shaping, added.component) === added.turns ? shaping : withTurns(shaping, added),
  );
}

export function setMotion(doc: Doc, change: Partial<Motion>): Doc {
  return changed(doc.motion, change) ? { ...doc, motion: { ...doc.motion, ...change } } : doc;
}

/** A tangent pose has no effect at speed 0, so the speed becomes the default. */
export function setEncoding(doc: Doc, change: Partial<Encoding>): Doc {
  if (!changed(doc.encoding, change)) return doc;
  const still = (['start', 'end'] as const).filter(
    (end) => typeof change[TANGENT_NAME[end]] === 'number' && doc.motion[SPEED_NAME[end]] === 0,
  );
  const motion = setMotion(doc, Object.fromEntries(still.map((end) => [SPEED_NAME[end], DEFAULT_SPEED])));
  return { ...motion, encoding: { ...doc.encoding, ...change } };
}

function reshaped(doc: Doc, index: number, change: (shaping: Shaping) => Shaping): Doc {
  const key = doc.keys[index];
  const shaping = key && change(key.shaping);
  return shaping && shaping !== key.shaping ? withKey(doc, index, { shaping }) : doc;
}

function withKey(doc: Doc, index: number, change: Partial<KeyRef>): Doc {
  return { ...doc, keys: doc.keys.map((key, at) => (at === index ? { ...key, ...change } : key)) };
}

/** `keys`: those of the document in order, possibly followed by a new one. */
function sorted(doc: Doc, keys: readonly KeyRef[]): Doc {
  const order = [...keys.keys()].sort((a, b) => keys[a]!.time - keys[b]!.time);
  return ordered(
    doc,
    order.map((key) => keys[key]!),
    order.map((key) => (key < doc.keys.length ? key : null)),
  );
}

/** `from`: the former number of each key; null for a new one. */
function ordered(doc: Doc, keys: KeyRef[], from: readonly (number | null)[]): Doc {
  const { regions } = doc.motion;
  if (regions.length === 0) return { ...doc, keys };
  return { ...doc, keys, motion: { ...doc.motion, regions: regionsOfKeys(regions, from) } };
}

function changed<T extends object>(before: T, change: Partial<T>): boolean {
  return (Object.keys(change) as (keyof T)[]).some((key) => change[key] !== before[key]);
}
