import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, it, vi } from 'vitest';
import { fetchSample, fetchSamples } from '../../web/app/sources/samples.ts';
import type { Sample } from '../../web/app/sources/samples.ts';

const folder = path.resolve(import.meta.dirname, '../../public/samples');
const MAX_BYTES = 120_000;

it('no sample file is larger than necessary', () => {
  const models = readdirSync(folder).filter((name) => name.endsWith('.glb'));
  expect(models.length).toBeGreaterThan(0);
  const long = models.filter((name) => gzipSync(readFileSync(path.join(folder, name))).length > MAX_BYTES);
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

it('a sample that cannot be loaded is named, with advice', async () => {
  vi.stubGlobal('document', { baseURI: 'http://localhost/' });
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  const hand = { made: false, files: ['hand.glb'] } as Sample;
  await expect(fetchSample(hand, new AbortController().signal)).rejects.toThrow(
    'The sample could not be fetched: samples/hand.glb. Check the connection and try again.',
  );
  vi.unstubAllGlobals();
});

it('a web page instead of a sample or the list is named, with advice', async () => {
  vi.stubGlobal('document', { baseURI: 'http://localhost/' });
  const answer = (type: string) => () =>
    Promise.resolve(new Response('<!doctype html>', { headers: { 'content-type': type } }));
  vi.stubGlobal('fetch', answer('text/html; charset=utf-8'));
  await expect(fetchSamples()).rejects.toThrow(
    "samples/samples.json returned a web page. Check that the page's folder is complete.",
  );
  vi.stubGlobal('fetch', answer('application/json'));
  await expect(fetchSamples()).rejects.toThrow(/^The list of samples cannot be read: .*folder is complete\.$/);
  vi.unstubAllGlobals();
});
