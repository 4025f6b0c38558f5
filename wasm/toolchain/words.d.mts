export interface Banned {
  line: number;
  words: string;
  instead: string;
}
export const EXCEPTIONS: { file: string; words: RegExp; why: string }[];
export function bannedIn(file: string, source: string): Banned[];
export function codeOf(file: string, source: string): string | null;
export function readableFiles(): string[];
export function lintWords(files?: string[]): string[];
