export interface PrivateName {
  /** 0 for the path. */
  line: number;
  name: string;
  instead: string;
}
export const PRIVATE: { pattern: RegExp; instead: string }[];
export function wordsOf(name: string): string;
export function privateNamesIn(file: string, source: string): PrivateName[];
export function lintNames(): string[];
