/** Numbers and tables as Markdown. */
import type { Spread } from './quantile.ts';

/** A number with about three digits. */
export function short(value: number): string {
  if (!Number.isFinite(value)) return '-';
  if (value !== 0 && Math.abs(value) < 0.01) return value.toExponential(1);
  if (value !== 0 && Math.abs(value) < 0.1) return value.toFixed(3);
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}

/** Shortest duration that every clock here can resolve; an isolated page's clock has steps of 5 microseconds. */
export const CLOCK_MS = 0.01;

/** Formats measured milliseconds. */
export const msText = (ms: number): string => (ms < CLOCK_MS ? `< ${CLOCK_MS}` : short(ms));

/** Median / 95th percentile, in milliseconds. */
export const both = ({ median, slow }: Spread): string => `${msText(median)} / ${msText(slow)}`;

/** Columns are as wide as their longest cell. */
export function table(titles: string[], rows: string[][]): string {
  const widths = titles.map((title, i) => Math.max(title.length, ...rows.map((row) => row[i]!.length)));
  const line = (cells: string[]): string => `| ${cells.map((cell, i) => cell.padStart(widths[i]!)).join(' | ')} |`;
  return [line(titles), `|${widths.map((width) => `${'-'.repeat(width + 1)}:`).join('|')}|`, ...rows.map(line)].join(
    '\n',
  );
}
