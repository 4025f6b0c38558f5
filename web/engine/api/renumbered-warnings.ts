/** Warnings of an import after its keys were removed or moved. Loaded if there are any. */
import type { KeysInfo, Warning } from './types.ts';

/** In messages: "(key 3)" after the name of a file, "Keys 2, 3 and 4", "key 1". */
const NAMED_KEYS = /(\()?\b([Kk]eys?) (\d+(?:(?:, | and | to )\d+)*)(?!\.?\w|(?:, | and | to )\d)/g;

/** The warnings about poses that are keys. `keyOf`: the key of a pose, -1 for none. */
export function renumberedWarnings({ names, warnings }: KeysInfo, keyOf: (pose: number) => number): Warning[] {
  return warnings.flatMap((warning) => renumbered(warning, names, keyOf) ?? []);
}

/**
 * An import's warning, with `keyOf` (0-based, -1 for none) instead of the poses' numbers. null if its pose is no longer
 * a key.
 */
export function renumbered(
  warning: Warning,
  names: readonly string[],
  keyOf: (pose: number) => number,
): Warning | null {
  let key = warning.key < 0 ? -1 : keyOf(warning.key);
  let gone = false;
  const message = warning.message.replace(NAMED_KEYS, (_, ofFile: string | undefined, word: string, list: string) => {
    const poses = numbersIn(list);
    const keys = poses
      .map(keyOf)
      .filter((index) => index >= 0)
      .sort((a, b) => a - b);
    if (poses.length > 1) {
      gone ||= keys.length < 2;
      // Such a warning is about the last of its keys.
      if (poses.includes(warning.key)) key = keys.at(-1) ?? -1;
      return `${word} ${listOf(keys)}`;
    }
    gone ||= ofFile !== undefined && keys.length === 0;
    return keys.length > 0 ? `${ofFile ?? ''}${word} ${keys[0]! + 1}` : `the pose “${names[poses[0]!] ?? ''}”`;
  });
  return gone || (warning.key >= 0 && key < 0) ? null : { ...warning, key, message };
}

/** Indices of a list of numbers that start at 1, such as "1, 2 and 3" or "1 to 9". */
function numbersIn(list: string): number[] {
  const [first = 0, ...others] = (list.match(/\d+/g) ?? []).map((number) => Number(number) - 1);
  const last = others.at(-1) ?? first;
  return list.includes(' to ') ? Array.from({ length: last - first + 1 }, (_, i) => first + i) : [first, ...others];
}

function listOf(indices: readonly number[]): string {
  const numbers = indices.map((index) => index + 1);
  const last = numbers.at(-1)!;
  if (numbers.length > 8 && last - numbers[0]! === numbers.length - 1) return `${numbers[0]} to ${last}`;
  return `${numbers.slice(0, -1).join(', ')} and ${last}`;
}
