/** Names of keys: the number, followed by the name, if any. */
import type { KeyRef } from './state.ts';

/** Label of a key; a name that equals its number is omitted. */
export function keyLabel(index: number, name: string): string {
  return name === '' || name === String(index + 1) ? `Key ${index + 1}` : `Key ${index + 1}, ${name}`;
}

/** The keys as choices, by pose. */
export function keyChoices(keys: readonly Pick<KeyRef, 'pose' | 'name'>[]): { value: string; label: string }[] {
  return keys.map(({ pose, name }, index) => ({ value: String(pose), label: keyLabel(index, name) }));
}

/** Text that starts a sentence, converted for use within one. */
export const lowerFirst = (words: string): string => words.charAt(0).toLowerCase() + words.slice(1);

/** Names without their common first words, because a card has room only for the differing words. */
export function shortNames(names: readonly string[]): string[] {
  const [first = '', ...rest] = names;
  let common = rest.length > 0 ? first.length : 0;
  for (const name of rest) while (!name.startsWith(first.slice(0, common))) common -= 1;
  // Whether the common part can end at this character: a word or number boundary, or before a number.
  const isEnd = (at: number): boolean =>
    /[\s_.-]/.test(first[at - 1]!) || (/\D/.test(first[at - 1]!) && names.every((name) => /\d/.test(name[at] ?? '')));
  while (common > 0 && !isEnd(common)) common -= 1;
  return names.some((name) => name.length === common) ? [...names] : names.map((name) => name.slice(common));
}
