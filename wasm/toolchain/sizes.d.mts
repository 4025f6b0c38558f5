export interface PageFile {
  name: string;
  kind: 'JavaScript' | 'wasm' | 'style' | 'page';
  /** After gzip. */
  bytes: number;
  when: 'start' | 'later' | 'elsewhere';
}
export const LIMITS: Readonly<Record<'firstPicture' | 'shapespline_threads' | 'shapespline_files' | 'shapespline_shells', number>>;
export const PACKAGE_LIMITS: Readonly<Record<string, number>>;
export function sizesOf(folder: string, page?: string): PageFile[];
export function checkSizes(folder: string, print?: (line: string) => void): void;
export function packageSizes(folder: string): { name: string; limit: number; bytes: number }[];
export function checkPackageSizes(folder: string, print?: (line: string) => void): void;
