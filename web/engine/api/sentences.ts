/** Sentences of warnings that name keys. Loaded if there are warnings. */
import type { Warning } from './types.ts';

/** The keys that a warning names, 0-based. `count`: number of keys of the motion. */
function namedKeys({ about, key, count: locations }: Warning, count: number): number[] {
  if (about === 'Between') return [(key || count) - 1, key];
  return about === 'Keys' ? Array.from({ length: locations }, (_, i) => key - locations + 1 + i) : [key];
}

/** The warning with a message that names these keys. */
function naming(warning: Warning, keys: readonly number[]): Warning {
  const { about, text } = warning;
  if (!about) return warning;
  const numbers = keys.map((key) => key + 1);
  const start = about === 'Between' ? `Between key ${numbers.join(' and key ')}` : `${about} ${listOf(numbers)}`;
  return { ...warning, start, message: `${start} ${text}` };
}

/** The core's warnings in sentences. `userKeys`: the user's number of each key, if they differ. */
export function withSentences(warnings: readonly Warning[], count: number, userKeys?: readonly number[]): Warning[] {
  return warnings.map((warning) => {
    const numbered = { ...warning, key: userKeys?.[warning.key] ?? warning.key, text: warning.message };
    return naming(numbered, namedKeys(numbered, count));
  });
}

/** An import's warning, with `keyOf` (-1 for none) instead of the poses' numbers; null if its pose is not a key. */
export function renumbered(warning: Warning, keyOf: (pose: number) => number): Warning | null {
  if (warning.key < 0) return warning;
  const poses = namedKeys(warning, 0);
  const keys = poses.map(keyOf).filter((key) => key >= 0);
  if (keys.length < Math.min(poses.length, 2)) return null;
  keys.sort((a, b) => a - b);
  return naming({ ...warning, key: keys.at(-1)! }, keys);
}

function listOf(numbers: readonly number[]): string {
  const [first, last] = [numbers[0]!, numbers.at(-1)!];
  if (numbers.length > 8 && last - first === numbers.length - 1) return `${first} to ${last}`;
  return numbers.length > 1 ? `${numbers.slice(0, -1).join(', ')} and ${last}` : `${last}`;
}
