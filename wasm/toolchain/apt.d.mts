export interface Archive {
  file: string;
  sha256: string;
}
export function namedArchives(printed: string): Archive[];
export function verifyArchives(folder: string, archives: readonly Archive[]): void;
