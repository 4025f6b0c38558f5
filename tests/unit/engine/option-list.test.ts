/** web/engine/OPTIONS.md lists the options of the table, with their help. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, optionsIn } from '../../../web/engine/api/option-table.ts';
import type { Option, OptionTable } from '../../../web/engine/api/option-table.ts';

function entry([name, option]: [string, Option]): string {
  const { flag, value, help, default: usual = null } = option;
  const values = option.kind === 'choice' ? option.choices.map((choice) => `'${choice}'`).join(', ') : '';
  const start = usual === null ? '' : ` = ${JSON.stringify(usual).replaceAll('"', "'")}`;
  const offered = values && ` (${values})`;
  const word = flag === undefined ? '' : `, \`--${flag}${value === undefined ? '' : ` ${value}`}\``;
  return `- \`${name}${start}\`${offered}${word}: ${help}`;
}

const listOf = (title: string, table: OptionTable): string => [`${title}:`, ...optionsIn(table).map(entry)].join('\n');

const EXPECTED = [
  listOf('Motion options of `createSequence`, which `update` changes', MOTION),
  listOf('Options for each key', PER_KEY),
  listOf('Encoding options of `createSequence`', ENCODING),
  listOf('`importKeyframes`', IMPORT),
  listOf('`export`', EXPORT),
].join('\n');

/** Lines can break anywhere. */
const onOneLine = (text: string): string => text.replace(/\s+/g, ' ').trim();

it('the list agrees with the table', () => {
  const list = readFileSync(new URL('../../../web/engine/OPTIONS.md', import.meta.url), 'utf8');
  const [, listed] = list.split('<!-- options -->');
  expect(onOneLine(listed!)).toBe(onOneLine(EXPECTED));
});
