/** Names of keys: the number, and a name if there is one. */

/** Label of a key; a name that equals its number is omitted. */
export function keyLabel(index: number, name: string): string {
  return name === '' || name === String(index + 1) ? `Key ${index + 1}` : `Key ${index + 1}, ${name}`;
}

/** Words that begin a sentence, within one. */
export const lowerFirst = (words: string): string => words.charAt(0).toLowerCase() + words.slice(1);

/** Names without their common first words: a card has room only for the words that differ. */
export function shortNames(names: readonly string[]): string[] {
  const [first = '', ...rest] = names;
  let common = rest.length > 0 ? first.length : 0;
  for (const name of rest) while (!name.startsWith(first.slice(0, common))) common -= 1;
  // Not in the middle of a word or a number; a number may follow a word at once.
  const isEnd = (at: number): boolean =>
    /[\s_.-]/.test(first[at - 1]!) || (/\D/.test(first[at - 1]!) && names.every((name) => /\d/.test(name[at] ?? '')));
  while (common > 0 && !isEnd(common)) common -= 1;
  return names.some((name) => name.length === common) ? [...names] : names.map((name) => name.slice(common));
}
