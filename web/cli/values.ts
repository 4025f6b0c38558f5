/** Parses the text of options. Each reader refuses invalid text with a UsageError that names the option. */
import { MAX_KEYS, PIN_RADIUS } from '../engine/api/option-table.ts';
import type { AddedTurns, PathKey, Pin } from '../engine/api/types.ts';
import { UsageError } from './arguments.ts';

type Read<T> = (text: string, option: string) => T;

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

export const number: Read<number> = (text, option) => {
  if (!NUMBER.test(text.trim()) || !Number.isFinite(Number(text)))
    throw new UsageError(`${option}: '${text}' is not a number`);
  return Number(text);
};

export const whole: Read<number> = (text, option) => {
  if (!/^[+-]?\d+$/.test(text.trim()) || !Number.isSafeInteger(Number(text))) {
    throw new UsageError(`${option}: '${text}' is not a whole number`);
  }
  return Number(text);
};

export const wholeFrom =
  (min: number): Read<number> =>
  (text, option) => {
    const value = whole(text, option);
    if (value < min) throw new UsageError(`${option}: must be at least ${min}, not ${value}`);
    return value;
  };

export const positive: Read<number> = (text, option) => {
  const value = number(text, option);
  if (!(value > 0)) throw new UsageError(`${option}: must be above 0, not ${value}`);
  return value;
};

export const numbers: Read<number[]> = (text, option) => text.split(',').map((part) => number(part, option));

export const times: Read<number[]> = (text, option) => {
  const values = numbers(text, option);
  if (values.some((t, i) => i > 0 && !(t > values[i - 1]!))) throw new UsageError(`${option}: the times must increase`);
  return values;
};

export const range: Read<[number, number]> = (text, option) => {
  const parts = text.split(':');
  if (parts.length !== 2) throw new UsageError(`${option}: '${text}' is not a range A:B`);
  const [first, last] = parts.map((part) => number(part, option)) as [number, number];
  if (!(first < last)) throw new UsageError(`${option}: ${first} is not before ${last}`);
  return [first, last];
};

export const oneOf =
  <T extends string>(...names: T[]): Read<T> =>
  (text, option) => {
    const found = names.find((name) => name === text);
    if (!found) throw new UsageError(`${option}: '${text}' is not one of ${names.join(', ')}`);
    return found;
  };

/** KEY, counted from 1, to an index from 0. */
export const key: Read<number> = (text, option) => {
  const value = wholeFrom(1)(text, option);
  if (value > MAX_KEYS)
    throw new UsageError(`${option}: there is no key ${value}, because a shape has at most ${MAX_KEYS} keys`);
  return value - 1;
};

/** KEY:N or KEY:N@COMPONENT, ... to full turns before a key. */
export const turns: Read<AddedTurns[]> = (text, option) =>
  text.split(',').map((part) => {
    const [, place, count, component] = /^([^:@]+):([^:@]+)(?:@([^:@]+))?$/.exec(part) ?? [];
    if (!place || !count) throw new UsageError(`${option}: '${part}' is not KEY:N or KEY:N@COMPONENT`);
    const index = key(place, option);
    if (index === 0)
      throw new UsageError(`${option}: turns are added between a key and the previous key, so key 1 has none`);
    const added = { key: index, turns: whole(count, option) };
    return component ? { ...added, component: wholeFrom(1)(component, option) - 1 } : added;
  });

/** VERTEX[:RADIUS|patch][:stay=KEY][:path=T/X/Y/Z,T/X/Y/Z...] to a pin. */
export const pin: Read<Pin> = (text, option) => {
  const [place = '', ...rest] = text.split(':');
  const result: Pin = { vertex: wholeFrom(0)(place, option), radius: PIN_RADIUS };
  for (const [index, word] of rest.entries()) {
    const [, name, value = ''] = /^(stay|path)=(.*)$/.exec(word) ?? [];
    if (name === 'stay') result.stay = key(value, option);
    else if (name === 'path') result.path = value.split(',').map((part) => pathKey(part, option));
    else if (index > 0) throw new UsageError(`${option}: '${word}' is not stay=KEY or path=T/X/Y/Z,...`);
    else result.radius = word === 'patch' ? 0 : positive(word, option);
  }
  return result;
};

function pathKey(text: string, option: string): PathKey {
  const [time, x, y, z, ...rest] = text.split('/').map((part) => number(part, option));
  if (z === undefined || rest.length > 0) throw new UsageError(`${option}: '${text}' is not T/X/Y/Z`);
  return { time: time!, move: [x!, y!, z] };
}

/** A number is an index from 0, as in glTF; other text is a name. */
export const animation: Read<string | number> = (text) => (/^\d+$/.test(text) ? Number(text) : text);
