export interface Size {
  faces: number;
  /** null where none were given. */
  keys: number | null;
}

export interface Wanted {
  what: 'stages' | 'threads' | 'exports' | 'ghost' | 'ghost browser' | 'embed' | 'start' | 'drop' | 'hold' | 'inputs';
  /** null: the usual ones. */
  sizes: Size[] | null;
  /** Animations, for `hold`. */
  files: string[];
  browser: boolean;
  save: boolean;
}

/** Throws the usage where the words make no sense. */
export function benchArguments(words: readonly string[]): Wanted;
