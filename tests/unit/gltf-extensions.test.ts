/** The lists in wasm/io/gltf/EXTENSIONS.md match the code. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';

const io = path.resolve(import.meta.dirname, '../../wasm/io/gltf');
const read = (name: string): string => readFileSync(path.join(io, name), 'utf8');

const TITLES = { Applied: 'Applied', Decoded: 'Decoded', Harmless: 'Harmless', Ignored: 'Named in a warning' };

it.each(Object.entries(TITLES))('%s', (use, title) => {
  const code = read('gltf_extensions.cpp').matchAll(/\{"([^"]+)", (\w+)\}/g);
  const inCode = Array.from(code).flatMap(([, name, of]) => (of === use ? [name] : []));
  const item = read('EXTENSIONS.md')
    .split(/^- \*\*/m)
    .find((text) => text.startsWith(`${title}**`));
  const inList = Array.from(item!.split('\n\n')[0]!.matchAll(/`([A-Z][\w*]+)`/g), ([, name]) => name);
  expect(inCode.length).toBeGreaterThan(1);
  expect(inList).toEqual(inCode);
});
