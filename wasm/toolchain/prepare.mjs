// Prepares everything that a script needs: system, npm packages, build steps. Silent if everything is ready.
import { accessSync, constants } from 'node:fs';
import { whileLocked } from './lock.mjs';
import { Explained } from './log.mjs';
import { npmPackages } from './packages.mjs';
import { inParallel } from './parallel.mjs';
import { root } from './paths.mjs';
import { checkInstallable, installMissing } from './requirements.mjs';

function checkWritable() {
  try {
    accessSync(root, constants.W_OK);
  } catch {
    throw new Explained(`shapespline is built inside its own folder, and ${root} is not writable`);
  }
}

const packagesAsRequirement = { name: 'the npm packages of package-lock.json', hint: 'npm ci' };
const mayInstall = () => !process.env.SHAPESPLINE_NO_INSTALL;

/** Brings `requirements` (see requirements.mjs) up to date, then `steps`. */
export async function prepare(requirements, steps) {
  const order = [npmPackages, ...steps];
  // Requirements are needed only to build; finished builds need none.
  if (order.every((each) => each.isCurrent())) return;
  await prepareSystem(requirements);
  await whileLocked(async () => {
    for (const each of order) if (!each.isCurrent()) await each.make();
  });
}

/** Prepares only the system. */
export async function prepareSystem(requirements) {
  checkWritable();
  checkInstallable(requirements, npmPackages.isCurrent() || mayInstall() ? [] : [packagesAsRequirement]);
  await whileLocked(async () => {
    const npm = async () => {
      if (!npmPackages.isCurrent()) await npmPackages.make();
    };
    await inParallel([npm, () => installMissing(requirements)], 2);
  });
}
