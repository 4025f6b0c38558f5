// The npm packages of the lockfile.
import { rmSync } from 'node:fs';
import path from 'node:path';
import { run, withRetries } from './exec.mjs';
import { step } from './log.mjs';
import { inRoot } from './paths.mjs';
import { digest, isStamped, stamp } from './stamps.mjs';

const value = () =>
  digest(['package.json', 'package-lock.json', '.npmrc'], process.versions.node.split('.')[0], process.platform);
const outputs = ['node_modules/.package-lock.json'];

export const npmPackages = {
  isCurrent: () => isStamped('npm-packages', value(), outputs),
  async make() {
    step('installing npm packages');
    // The npm that runs this script, if any.
    const npm = process.env.npm_execpath;
    const [program, args] = npm && path.extname(npm) === '.js' ? [process.execPath, [npm]] : ['npm', []];
    await withRetries('npm ci', (attempt) => {
      // Remains of an interrupted installation can block npm.
      if (attempt > 1) rmSync(inRoot('node_modules'), { recursive: true, force: true, maxRetries: 5 });
      return run(program, [...args, 'ci', '--loglevel=error']);
    });
    stamp('npm-packages', value());
  },
};
