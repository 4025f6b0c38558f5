export interface Range {
  first: number;
  last: number;
}
export function rangesOf(count: number, parts: number): Range[];
