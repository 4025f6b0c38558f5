export interface CodeFile {
  name: string;
  kind: 'JavaScript' | 'wasm';
  /** After gzip. */
  bytes: number;
  when: 'start' | 'later' | 'elsewhere';
}
export const LIMITS: Readonly<Record<'JavaScript' | 'wasm', number>>;
export function sizesOf(folder: string, page?: string): CodeFile[];
export function checkSizes(folder: string, print?: (line: string) => void): void;
