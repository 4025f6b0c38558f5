export interface Wanted {
  what: 'stages' | 'exports' | 'start' | 'drop' | 'hold';
  /** null: the default sizes. */
  sizes: { faces: number }[] | null;
  /** Animations, for `hold`. */
  files: string[];
  browser: boolean;
  save: boolean;
}

/** Throws a usage message if the words are invalid. */
export function benchArguments(words: readonly string[]): Wanted;
