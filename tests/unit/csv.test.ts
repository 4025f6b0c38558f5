import { expect, it } from 'vitest';
import { measuresCsv, patchesCsv } from '../../web/app/export/csv.ts';
import { ENCODING, MOTION, PER_KEY } from '../../web/engine/api/option-table.ts';
import { pageOptions } from '../../web/model/page-options.ts';
import { docOfKeys, keyRef } from './documents.ts';

it('a table begins with every option of the page, with options per key next to their key', () => {
  const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 2, { tension: 0.5, turns: [{ component: 3, turns: -1 }] }));
  const [version, keys, options, ...rows] = patchesCsv(Int32Array.of(4, 5), doc, '1.2.3').split('\n');
  expect(version).toBe('# shapespline 1.2.3');
  const spelt = JSON.parse(keys!.replace('# keys ', '')) as object[];
  expect(spelt[1]).toMatchObject({ name: 'b', time: 2, tension: 0.5, bias: 0, turns: [{ component: 3, turns: -1 }] });
  for (const key of spelt) expect(Object.keys(key)).toEqual(['name', 'time', ...Object.keys(PER_KEY)]);
  expect(Object.keys(JSON.parse(options!.replace('# options ', '')) as object)).toEqual(
    [...pageOptions(MOTION), ...pageOptions(ENCODING)].map(({ page }) => page),
  );
  expect(rows).toEqual(['face,patch', '0,4', '1,5', '']);
});

it('times of keys are written without rounding errors', () => {
  const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 3 * 0.4));
  expect(patchesCsv(Int32Array.of(4), doc, '1.2.3')).toContain('"time":1.2,');
});

it('no file name becomes a spreadsheet formula', () => {
  const names = ['=1+1', 'x",=HYPERLINK("http://a.test")', "x';=cmd|'/c calc'!A0", '@SUM(1)', '\t=1', '\r\n=1'];
  const doc = docOfKeys(...names.map((name, index) => keyRef(index, name, index)));
  const table = patchesCsv(Int32Array.of(4), doc, '1.2.3');
  const cells = table.split(/[,;\t\r\n]/).map((cell) => cell.replace(/^[\s"']+/, ''));
  expect(cells.filter((cell) => /^[=+@-]/.test(cell))).toEqual([]);
  const keys = /^# keys (.*)$/m.exec(table)![1]!;
  expect((JSON.parse(keys) as { name: string }[]).map(({ name }) => name)).toEqual(names);
});

it('a table has the bending by edge lengths and angles of each motion where it was measured, with its unit', () => {
  const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
  const values = { volume: [1, 2], area: [3, 4], bending: [5, 6], sliding: [NaN, NaN], plane: null };
  const table = (shell: object): string[] => {
    const motions = (['lri', 'shell'] as const).map((method) => ({ method, ...values, ...shell }));
    return measuresCsv({ times: [0, 1], keyTimes: [0, 1], range: [0, 1], motions }, doc, '1.2.3', 1).split('\n');
  };
  expect(table({}).join('\n')).not.toContain('bending by');
  const [row, last, head, ...above] = table({ shell: [7, 8] })
    .toReversed()
    .slice(1);
  expect(head).toMatch(
    /lri sliding,lri bending by edge lengths and angles,shell volume.*,shell bending by edge lengths and angles$/,
  );
  expect([row, last]).toEqual(['1,1,2,4,6,,8,2,4,6,,8', '0,0,1,3,5,,7,1,3,5,,7']);
  expect(above[0]).toMatch(/^# bending by edge lengths and angles: /);
});
