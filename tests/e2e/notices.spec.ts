/** The page lists the authors and licences of its parts. */
import { readFileSync } from 'node:fs';
import { expect, test } from './support.ts';

const { packages } = JSON.parse(readFileSync(new URL('../../package-lock.json', import.meta.url), 'utf8')) as {
  packages: Record<string, { version: string }>;
};

test('the help copies the citation of the paper, and links the notices of all bundled packages', async ({ app }) => {
  await app.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await app.open();
  await app.by('help').click();
  await app.by('copy-bibtex').click();
  await expect(app.by('help-dialog').getByRole('status')).toHaveText('Copied.');
  const copied = await app.page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/^@article\{xia2019shapecompletion,[\s\S]*Computers \\& Graphics[\s\S]*\}\n$/);
  await app.page.context().clearPermissions();

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

test('the help links the manual, a page without scripts', async ({ app }) => {
  await app.open();
  await app.by('help').click();
  const href = await app.by('help-dialog').getByRole('link', { name: 'Manual' }).getAttribute('href');
  const response = await app.page.request.get(new URL(href!, app.page.url()).href);
  expect(response.ok()).toBe(true);
  expect(response.headers()['content-type']).toContain('text/html');
  const html = await response.text();
  expect(html).toContain('<h1 id="shapespline-manual">');
  expect(html).not.toContain('<script');
});
