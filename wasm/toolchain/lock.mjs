// One run at a time prepares a checkout; others wait for it.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { step } from './log.mjs';
import { buildDir } from './paths.mjs';

const file = path.join(buildDir, 'preparing.pid');

function holder() {
  try {
    const pid = Number(readFileSync(file, 'utf8'));
    process.kill(pid, 0);
    return pid;
  } catch {
    return null;
  }
}

function tryLock() {
  try {
    writeFileSync(file, String(process.pid), { flag: 'wx' });
    return true;
  } catch (error) {
    if (error.code !== 'EEXIST') throw error;
    return false;
  }
}

/** Runs the action while no other process of this checkout runs one. */
export async function whileLocked(action) {
  mkdirSync(buildDir, { recursive: true });
  for (let waited = 0; !tryLock(); ++waited) {
    const pid = holder();
    if (pid === null) rmSync(file, { force: true });
    else if (waited === 0) step(`waiting for another run in this folder (process ${pid})`);
    await new Promise((wake) => setTimeout(wake, 300));
  }
  const release = () => rmSync(file, { force: true });
  process.once('exit', release);
  try {
    return await action();
  } finally {
    release();
    process.off('exit', release);
  }
}
