/**
 * Options per key. In the document they belong to the key and move with it. The engine takes lists; only this file
 * converts between both.
 */
import { PER_KEY } from '../engine/api/option-table.ts';
import type { AddedTurns, PerKey } from '../engine/api/types.ts';

/** Full turns between the previous key and this one; the first key has none. */
export type KeyTurns = Omit<AddedTurns, 'key'>;
export type Shaping = { readonly [N in keyof PerKey]: PerKey[N] extends number[] ? number : readonly KeyTurns[] };
/** The options with one number per key. */
export type ShapingNumber = { [N in keyof PerKey]: PerKey[N] extends number[] ? N : never }[keyof PerKey];

export const SHAPING_NUMBERS = (Object.keys(PER_KEY) as (keyof PerKey)[]).filter(
  (name): name is ShapingNumber => PER_KEY[name].kind === 'number',
);

/** Those of the interval after the key. */
export type IntervalNumber = {
  [N in ShapingNumber]: (typeof PER_KEY)[N] extends { ofInterval: true } ? N : never;
}[ShapingNumber];
export const INTERVAL_NUMBERS = SHAPING_NUMBERS.filter((name): name is IntervalNumber => 'ofInterval' in PER_KEY[name]);

function shapingWith(number: (name: ShapingNumber) => number, turns: readonly KeyTurns[]): Shaping {
  const numbers = Object.fromEntries(SHAPING_NUMBERS.map((name) => [name, number(name)]));
  return { ...(numbers as Record<ShapingNumber, number>), turns };
}

export const DEFAULT_SHAPING: Shaping = shapingWith((name) => PER_KEY[name].default, []);

/** The same key with the default motion to the next key. */
export function withPlainInterval(shaping: Shaping): Shaping {
  return { ...shaping, ...Object.fromEntries(INTERVAL_NUMBERS.map((name) => [name, PER_KEY[name].default])) };
}

/** Options of one key from the engine's lists. */
export function shapingOf(lists: Partial<PerKey>, index: number): Shaping {
  const turns = (lists.turns ?? []).filter(({ key }) => key === index).map(({ key: _, ...rest }) => rest);
  return shapingWith((name) => lists[name]?.[index] ?? PER_KEY[name].default, turns);
}

/** The engine's lists; a list of numbers is empty if all are the default. */
export function listsOf(shapings: readonly Shaping[]): PerKey {
  const numbers = SHAPING_NUMBERS.map((name) => {
    const values = shapings.map((shaping) => shaping[name]);
    return [name, values.every((value) => value === PER_KEY[name].default) ? [] : values];
  });
  const turns = shapings.flatMap((shaping, key) => (key === 0 ? [] : shaping.turns.map((one) => ({ key, ...one }))));
  return { ...(Object.fromEntries(numbers) as Record<ShapingNumber, number[]>), turns };
}

/** Turns of one component, or of the whole shape if omitted. */
export function turnsOf({ turns }: Shaping, component?: number): number {
  return turns.find((one) => one.component === component)?.turns ?? 0;
}

/** Replaces the turns of a component or of the whole shape; 0 removes them. The whole shape comes first. */
export function withTurns(shaping: Shaping, { component, turns }: KeyTurns): Shaping {
  const others = shaping.turns.filter((one) => one.component !== component);
  const added = component === undefined ? { turns } : { component, turns };
  const order = (one: KeyTurns): number => one.component ?? -1;
  return { ...shaping, turns: turns === 0 ? others : [...others, added].sort((a, b) => order(a) - order(b)) };
}
