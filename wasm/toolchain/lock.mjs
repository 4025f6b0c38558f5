// Prevents several runs from preparing a checkout at the same time; others wait.
import { linkSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { capture } from './exec.mjs';
import { Explained, step } from './log.mjs';
import { buildDir } from './paths.mjs';

// Process ids are reused, so the start time identifies the process. '' if the process does not exist.
function startOf(pid) {
  try {
    // The program name, in parentheses, may contain spaces; the start time is the 22nd field of the line.
    const stat = readFileSync(`/proc/${pid}/stat`, 'utf8');
    return stat.slice(stat.lastIndexOf(')') + 2).split(' ')[19];
  } catch {
    return process.platform === 'linux' ? '' : (capture('ps', ['-o', 'lstart=', '-p', String(pid)]) ?? '').trim();
  }
}

const read = (file) => {
  try {
    return readFileSync(file, 'utf8');
  } catch {
    return null;
  }
};

// The holder of a lock with this content; null if the content is invalid or the process has ended.
function holderIn(text) {
  try {
    const holder = JSON.parse(text);
    return Number.isInteger(holder.pid) && holder.start && startOf(holder.pid) === holder.start ? holder : null;
  } catch {
    return null;
  }
}

// The lock appears completely or not at all, even on a full disk.
function tryLock(file) {
  const own = `${file}.${process.pid}`;
  const holder = { pid: process.pid, start: startOf(process.pid), since: new Date().toISOString() };
  try {
    writeFileSync(own, JSON.stringify(holder));
    linkSync(own, file);
    return true;
  } catch (error) {
    if (error.code === 'EEXIST') return false;
    throw new Explained(`cannot write ${file}: ${error.code === 'ENOSPC' ? 'the disk is full' : error.message}`);
  } finally {
    rmSync(own, { force: true });
  }
}

// Another process may have replaced the stale lock meanwhile. If so, that lock is moved back.
function removeStale(file, text) {
  const away = `${file}.stale.${process.pid}`;
  try {
    renameSync(file, away);
    if (read(away) !== text) linkSync(away, file);
  } catch {
    // Another process was faster.
  }
  rmSync(away, { force: true });
}

/** Runs the action while no other process holds the lock `file`. Reports the process that it waits for. */
export async function whileHolding(file, action) {
  mkdirSync(path.dirname(file), { recursive: true });
  let told = false;
  while (!tryLock(file)) {
    const text = read(file);
    if (text === null) continue;
    const holder = holderIn(text);
    if (!holder) {
      removeStale(file, text);
      continue;
    }
    if (!told) step(`waiting for another run in this folder (process ${holder.pid}, since ${holder.since})`);
    told = true;
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

/** Runs the action while no other process of this checkout runs one. */
export const whileLocked = (action) => whileHolding(path.join(buildDir, 'preparing.lock'), action);
