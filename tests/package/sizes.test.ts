/** Each script of the package has a size limit, which the build checks. */
import { randomBytes } from 'node:crypto';
import { appendFileSync, cpSync } from 'node:fs';
import path from 'node:path';
import { expect, inject, it } from 'vitest';
import { PACKAGE_LIMITS, checkPackageSizes, packageSizes } from '../../wasm/toolchain/sizes.mjs';
import { newProject, packageIn } from './support/project.ts';

const quiet = (): void => undefined;

it('every script stays within its limit, including its static imports', () => {
  const sizes = packageSizes(packageIn(inject('installed')));
  // The entries for frameworks contain types only.
  const scripts = inject('packed').filter((file) => /^(?!chunk-|jsx|vue|svelte)[\w-]+\.js$/.test(file));
  expect(sizes.map(({ name }) => name).sort()).toEqual(scripts.sort());
  for (const { bytes, limit } of sizes) expect(bytes).toBeLessThanOrEqual(limit);
});

it('fails if an imported chunk makes a script too large', async () => {
  const folder = packageIn(await newProject());
  cpSync(path.join(folder, 'codecs.js'), path.join(folder, 'chunk-LARGE.js'));
  appendFileSync(path.join(folder, 'chunk-LARGE.js'), `// ${randomBytes(PACKAGE_LIMITS['index.js']!).toString('hex')}`);
  appendFileSync(path.join(folder, 'index.js'), '\nimport"./chunk-LARGE.js";');
  expect(() => checkPackageSizes(folder, quiet)).toThrow(/^index\.js of the package has/);
});
