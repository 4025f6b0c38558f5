/** One sentence about unusable values of a link, or null without any. */
export function ignoredValuesSentence(names: readonly string[]): string | null {
  if (names.length === 0) return null;
  const [what, was] = names.length === 1 ? ['a value', 'was'] : ['values', 'were'];
  return `The link has ${what} that cannot be used and ${was} ignored: ${names.join(', ')}.`;
}
