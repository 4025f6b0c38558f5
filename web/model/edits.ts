/** Edits of the document: each takes one and returns the next, or the same where nothing changes. */
import type { Doc, Encoding, KeyRef, Motion, PartTurns, Shaping } from './state.ts';
import { clamp } from './time-scale.ts';

/** Puts a key elsewhere in the order; the times stay where they are and the shapes change places. */
export function moveKey(doc: Doc, from: number, to: number): Doc {
  const target = clamp(to, 0, doc.keys.length - 1);
  if (from === target || !doc.keys[from]) return doc;
  const times = doc.keys.map((key) => key.time);
  const keys = moved(doc.keys, from, target).map((key, index) => ({ ...key, time: times[index]! }));
  return { ...doc, keys, ...ofEachKey(doc, (list) => moved(list, from, target)) };
}

/** A motion needs two keys: the last two stay. */
export function removeKey(doc: Doc, index: number): Doc {
  if (doc.keys.length <= 2 || !doc.keys[index]) return doc;
  const without = <T>(list: readonly T[]): T[] => list.filter((_, other) => other !== index);
  return { ...doc, keys: without(doc.keys), ...ofEachKey(doc, without) };
}

/** Gives a key another time; past its neighbours it takes another place in the order. Equal times are refused. */
export function retimeKey(doc: Doc, index: number, time: number): Doc {
  const key = doc.keys[index];
  if (!key || key.time === time || doc.keys.some((other, at) => at !== index && other.time === time)) return doc;
  return sorted({ ...doc, keys: doc.keys.map((other, at) => (at === index ? { ...other, time } : other)) });
}

export function renameKey(doc: Doc, index: number, name: string): Doc {
  if (name === '' || doc.keys[index]?.name === name) return doc;
  return { ...doc, keys: doc.keys.map((key, at) => (at === index ? { ...key, name } : key)) };
}

/** Adds a key in order of time. */
export function addKey(doc: Doc, key: KeyRef): Doc {
  if (doc.keys.some((other) => other.time === key.time)) return doc;
  return sorted({ ...doc, keys: [...doc.keys, key] });
}

export function setShaping(doc: Doc, name: Shaping, index: number, value: number): Doc {
  const values = shapingOf(doc, name);
  if (values[index] === value) return doc;
  return { ...doc, [name]: values.map((other, at) => (at === index ? value : other)) };
}

/** Whole turns of one component on the way to a key; 0 takes them away. */
export function setPartTurns(doc: Doc, index: number, component: number, turns: number): Doc {
  const lists = partTurnsOf(doc);
  const before = lists[index] ?? [];
  if ((before.find((part) => part.component === component)?.turns ?? 0) === turns) return doc;
  const others = before.filter((part) => part.component !== component);
  const list = turns === 0 ? others : [...others, { component, turns }].sort((a, b) => a.component - b.component);
  return { ...doc, partTurns: lists.map((other, at) => (at === index ? list : other)) };
}

export function setMotion(doc: Doc, change: Partial<Motion>): Doc {
  return changed(doc.motion, change) ? { ...doc, motion: { ...doc.motion, ...change } } : doc;
}

export function setEncoding(doc: Doc, change: Partial<Encoding>): Doc {
  return changed(doc.encoding, change) ? { ...doc, encoding: { ...doc.encoding, ...change } } : doc;
}

/** One value a key, in the keys' order. */
export function shapingOf(doc: Doc, name: Shaping): number[] {
  return doc.keys.map((_, index) => doc[name][index] ?? 0);
}

/** Whole turns of separate parts, a list for each key. */
export function partTurnsOf(doc: Doc): (readonly PartTurns[])[] {
  return doc.keys.map((_, index) => doc.partTurns[index] ?? []);
}

/** What is kept for each key, arranged as the keys are. */
function ofEachKey(doc: Doc, arrange: <T>(list: readonly T[]) => T[]): Pick<Doc, Shaping | 'partTurns'> {
  const values = (name: Shaping): number[] => arrange(shapingOf(doc, name));
  return { tension: values('tension'), bias: values('bias'), turns: values('turns'), partTurns: arrange(partTurnsOf(doc)) };
}

function sorted(doc: Doc): Doc {
  const { keys } = doc;
  const order = keys.map((_, index) => index).sort((a, b) => keys[a]!.time - keys[b]!.time);
  const arranged = <T>(list: readonly T[]): T[] => order.map((index) => list[index]!);
  return { ...doc, keys: arranged(keys), ...ofEachKey(doc, arranged) };
}

function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const rest = list.filter((_, index) => index !== from);
  return [...rest.slice(0, to), list[from]!, ...rest.slice(to)];
}

function changed<T extends object>(before: T, change: Partial<T>): boolean {
  return (Object.keys(change) as (keyof T)[]).some((key) => change[key] !== before[key]);
}
