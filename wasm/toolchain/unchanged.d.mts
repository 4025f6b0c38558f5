export interface Counts {
  passed: number;
  failed: number;
  skipped: number;
  unchanged?: boolean;
}
export function unlessUnchanged(
  name: string,
  programs: readonly string[],
  runAll: () => Counts | Promise<Counts>,
): Promise<Counts>;
