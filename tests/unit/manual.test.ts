import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { manualPage } from '../../web/manual/plugin.ts';

it('converts Markdown to a page without scripts, whose headings have the same anchors as in Markdown viewers', () => {
  const html = manualPage('# The `manual`\n\n## Feet and pins\n\nSee [hosting](#hosting).\n\n## Hosting\n', 'b {}\n');
  expect(html).toContain('<h1 id="the-manual">The <code>manual</code></h1>');
  expect(html).toContain('<h2 id="feet-and-pins">Feet and pins</h2>');
  expect(html).toContain('<a href="#hosting">hosting</a>');
  expect(html).toContain('b {}');
  expect(html).not.toContain('<script');
});

it('the README links existing sections of the manual', () => {
  const root = path.resolve(import.meta.dirname, '../..');
  const html = manualPage(readFileSync(path.join(root, 'web/manual/MANUAL.md'), 'utf8'), '');
  const readme = readFileSync(path.join(root, 'README.md'), 'utf8');
  const anchors = Array.from(readme.matchAll(/MANUAL\.md#([\w-]+)/g), ([, anchor]) => anchor!);
  expect(anchors.length).toBeGreaterThan(0);
  for (const anchor of anchors) expect(html).toContain(`id="${anchor}"`);
});
