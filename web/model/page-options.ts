/**
 * The engine's options in the page, under their names in the document and in links. An option that is a key or a shape
 * refers to one of the import's poses; null stands for the default.
 */
import { optionsIn } from '../engine/api/option-table.ts';
import type { Option, OptionTable, ValueOf } from '../engine/api/option-table.ts';

export type PageOptions<T> = {
  -readonly [N in keyof T as T[N] extends { page: infer P extends string } ? P : never]: T[N] extends {
    kind: 'key' | 'shape';
  }
    ? number | null
    : ValueOf<T[N]>;
};

interface PageOption {
  /** Name of the option in the engine. */
  name: string;
  page: string;
  option: Option;
}

export function pageOptions(table: OptionTable): PageOption[] {
  return optionsIn(table).flatMap(([name, option]) =>
    option.page === undefined ? [] : [{ name, page: option.page, option }],
  );
}

/** Whether the document stores a pose for this option. */
export function isPose({ kind }: Option): boolean {
  return kind === 'key' || kind === 'shape';
}

/** A value for each of the table's options that the page offers. */
export function forPage<T extends OptionTable>(table: T, value: (entry: PageOption) => unknown): PageOptions<T> {
  return Object.fromEntries(pageOptions(table).map((entry) => [entry.page, value(entry)])) as PageOptions<T>;
}

export function pageDefaults<T extends OptionTable>(table: T): PageOptions<T> {
  return forPage(table, ({ option }) => (isPose(option) ? null : option.default));
}
