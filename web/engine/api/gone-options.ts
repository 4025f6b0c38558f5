/** Options of earlier versions. What these wrote still opens, without the option. */
interface GoneOption {
  flag: string;
  /** Value of files that did not use the option. */
  off: unknown;
  words: string;
}

const GONE: Readonly<Record<string, GoneOption>> = {
  ownPaths: { flag: 'own-paths', off: 'off', words: 'own paths of faces' },
};

export const GONE_NAMES: readonly string[] = Object.keys(GONE);
export const GONE_FLAGS: readonly string[] = Object.values(GONE).map(({ flag }) => flag);

/** The names of stored options that are gone and were in use. */
export function goneIn(stored: object): string[] {
  const values = stored as Record<string, unknown>;
  return GONE_NAMES.filter((name) => (values[name] ?? GONE[name]!.off) !== GONE[name]!.off);
}

/** The flags of a command line that are gone and were in use. */
export function goneFlags(values: ReadonlyMap<string, string>): string[] {
  return Object.values(GONE).flatMap(({ flag, off }) => ((values.get(flag) ?? off) === off ? [] : [flag]));
}

/** Stored options without those that are gone. */
export function withoutGone<T extends object>(stored: T): T {
  return Object.fromEntries(Object.entries(stored).filter(([name]) => !GONE_NAMES.includes(name))) as T;
}

/** One sentence for the user, or null without any. `names`: those of goneIn(). */
export function goneSentence(names: readonly string[]): string | null {
  if (names.length === 0) return null;
  const words = names.map((name) => GONE[name]!.words).join(', ');
  return `An earlier version saved this with ${words}. The option is gone, and the motion is shown without it.`;
}
