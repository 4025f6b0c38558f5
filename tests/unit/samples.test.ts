import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, it, vi } from 'vitest';
import { fetchSample, fetchSamples } from '../../web/app/sources/samples.ts';
import type { Sample } from '../../web/app/sources/samples.ts';

const folder = path.resolve(import.meta.dirname, '../../public/samples');
const MOST_BYTES = 120_000;

it('no sample file is larger than necessary', () => {
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

it('a sample that cannot be loaded is named, with advice', async () => {
  vi.stubGlobal('document', { baseURI: 'http://localhost/' });
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  const hand = { made: false, files: ['hand.glb'] } as Sample;
  await expect(fetchSample(hand, new AbortController().signal)).rejects.toThrow(
    'The sample could not be fetched: samples/hand.glb. Check the connection and try again.',
  );
  vi.unstubAllGlobals();
});

it('a list or sample that a host answers with a page, or that is damaged, is reported by its name', async () => {
  vi.stubGlobal('document', { baseURI: 'http://localhost/' });
  const answer = (text: string, type: string): void => {
    vi.stubGlobal('fetch', () => Promise.resolve(new Response(text, { headers: { 'content-type': type } })));
  };
  const hand = { made: false, files: ['hand.glb'] } as Sample;
  const remedy = "Check that the page's folder is complete.";
  answer('<!doctype html>', 'text/html; charset=utf-8');
  await expect(fetchSamples()).rejects.toThrow(
    `The sample could not be fetched: samples/samples.json returned a web page. ${remedy}`,
  );
  await expect(fetchSample(hand, new AbortController().signal)).rejects.toThrow(
    /samples\/hand.glb returned a web page/,
  );
  for (const type of ['application/json', 'text/plain']) {
    answer('<!doctype html>', type);
    await expect(fetchSamples()).rejects.toThrow(`samples/samples.json is not JSON. ${remedy}`);
  }
  vi.unstubAllGlobals();
});
