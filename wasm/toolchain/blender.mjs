// Blender as a Python module (bpy), for the tests in tests/tools that open our files in it. It is large and supports
// few Python versions, so it is optional: without it those tests are skipped.
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { installPackages, whyNoInstall } from './apt.mjs';
import { capture, run, which } from './exec.mjs';
import { whileHolding } from './lock.mjs';
import { Explained, step } from './log.mjs';
import { inRoot, toolchainDir } from './paths.mjs';

/** Blender's last long-term release with all dependencies, pinned by digests. */
const requirements = inRoot('wasm/toolchain/blender-requirements.txt');
const VERSION = /^bpy==(\S+)/m.exec(readFileSync(requirements, 'utf8'))[1];
/** The only Python version with modules for it. */
const PYTHON = '3.11';

const folder = path.join(toolchainDir, 'blender');
const python = path.join(folder, 'bin', 'python');
const ready = path.join(folder, 'ready');

// Libraries that the module loads and that a system without a desktop may lack.
const debianPackages = ['python3', 'python3-venv', 'libgl1', 'libsm6', 'libxi6', 'libxkbcommon0', 'libxrender1'];

/** Path of the Python with the module, or null if it is not installed. */
export function findBlender() {
  return existsSync(ready) && readFileSync(ready, 'utf8') === VERSION ? python : null;
}

// Whether a Python has venv and pip, which Debian packages separately.
function isUsable(program) {
  const asked = 'import ensurepip, sys, venv; print("%d.%d" % sys.version_info[:2])';
  return capture(program, ['-c', asked])?.trim() === PYTHON;
}

function findPython() {
  const onPath = [`python${PYTHON}`, 'python3'].map((name) => which(name));
  return [...onPath, `/usr/bin/python${PYTHON}`].find((program) => program && isUsable(program)) ?? null;
}

async function install() {
  if (process.env.SHAPESPLINE_NO_INSTALL) throw new Explained('SHAPESPLINE_NO_INSTALL is set');
  if (!findPython() && !whyNoInstall()) await installPackages(debianPackages);
  const base = findPython();
  if (!base) throw new Explained(`it needs Python ${PYTHON} with venv and pip`);
  step(`installing Blender ${VERSION} as a Python module (about 350 MB)`);
  rmSync(folder, { recursive: true, force: true });
  await run(base, ['-m', 'venv', folder]);
  const checked = ['--require-hashes', '--only-binary=:all:', '--requirement', requirements];
  await run(python, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', ...checked]);
  if (capture(python, ['-c', 'import bpy']) === null && !whyNoInstall()) await installPackages(debianPackages);
  await run(python, ['-c', 'import bpy']);
  writeFileSync(ready, VERSION);
}

/** Installs Blender's module if possible, otherwise prints the reason. Returns the Python with the module, or null. */
export async function installBlender() {
  return findBlender() ?? whileHolding(path.join(toolchainDir, 'blender.lock'), installOnce);
}

async function installOnce() {
  const already = findBlender();
  if (already) return already;
  try {
    await install();
  } catch (error) {
    if (!(error instanceof Explained)) throw error;
    step(`Blender cannot be installed here, the tests that need it are skipped: ${error.message}`);
  }
  return findBlender();
}
