/** Packs the package and installs it as a page author would, so all tests use the tarball. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { TestProject } from 'vitest/node';

declare module 'vitest' {
  export interface ProvidedContext {
    /** The folder of a project with the installed package. */
    installed: string;
    /** Every path in the tarball. */
    packed: string[];
  }
}

const packageFolder = fileURLToPath(new URL('../../../build/package', import.meta.url));

export default function setup({ provide }: TestProject): () => void {
  // The folder is outside the repository, so the repository's packages cannot be found from it.
  const folder = mkdtempSync(path.join(tmpdir(), 'shapespline-package-'));
  const npm = (...args: string[]): string =>
    execFileSync('npm', args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
  const [packed] = JSON.parse(npm('pack', packageFolder, '--json', '--loglevel=error')) as [
    { filename: string; files: { path: string }[] },
  ];
  const installed = path.join(folder, 'project');
  mkdirSync(installed);
  writeFileSync(path.join(installed, 'package.json'), '{ "name": "project", "private": true, "type": "module" }\n');
  npm(
    'install',
    '--prefix',
    installed,
    `./${packed.filename}`,
    '--offline',
    '--no-audit',
    '--no-fund',
    '--loglevel=error',
  );
  provide('installed', installed);
  provide(
    'packed',
    packed.files.map((file) => file.path),
  );
  return () => rmSync(folder, { recursive: true, force: true });
}
