/** Whoever has the page can read whose work it is. */
import { readFileSync } from 'node:fs';
import { expect, test } from './support.ts';

const { packages } = JSON.parse(readFileSync(new URL('../../package-lock.json', import.meta.url), 'utf8')) as {
  packages: Record<string, { version: string }>;
};

test('the help links the notices of everything that is bundled', async ({ app }) => {
  await app.open();
  await app.by('help').click();
  const href = await app.by('notices').getAttribute('href');
  const response = await app.page.request.get(new URL(href!, app.page.url()).href);
  expect(response.ok()).toBe(true);
  const text = await response.text();
  for (const name of [
    'three',
    'draco3dgltf',
    'meshoptimizer',
    'idb-keyval',
    'client-zip',
    'mediabunny',
    '@gltf-transform/core',
    '@gltf-transform/extensions',
    'property-graph',
  ])
    expect(text).toMatch(new RegExp(`^${name} ${packages[`node_modules/${name}`]!.version},`, 'm'));
  expect(text).toContain('https://gitlab.com/libeigen/eigen');
  expect(text).toContain('The Emscripten Authors');
});
