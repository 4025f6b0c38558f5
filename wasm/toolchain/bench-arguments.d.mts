export interface Size {
  faces: number;
  /** null if none were given. */
  keys: number | null;
}

export interface Wanted {
  what: 'stages' | 'threads' | 'exports' | 'ghost' | 'ghost browser' | 'embed' | 'start' | 'drop' | 'hold' | 'inputs';
  /** null: the default sizes. */
  sizes: Size[] | null;
  /** Animations, for `hold`. */
  files: string[];
  browser: boolean;
  save: boolean;
}

/** Throws a usage message if the words are invalid. */
export function benchArguments(words: readonly string[]): Wanted;
