import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, it } from 'vitest';

const folder = path.resolve(import.meta.dirname, '../../public/samples');
const MOST_BYTES = 120_000;

it('no sample is longer on its way to a visitor than it has to be', () => {
  const models = readdirSync(folder).filter((name) => name.endsWith('.glb'));
  expect(models.length).toBeGreaterThan(0);
  const long = models.filter((name) => gzipSync(readFileSync(path.join(folder, name))).length > MOST_BYTES);
  expect(long).toEqual([]);
});

it('the list names each sample and its file', () => {
  const list = JSON.parse(readFileSync(path.join(folder, 'samples.json'), 'utf8')) as { id: string; files: string[] }[];
  const named = list.flatMap(({ files }) => files).sort();
  expect(named).toEqual(
    readdirSync(folder)
      .filter((name) => name.endsWith('.glb'))
      .sort(),
  );
});
