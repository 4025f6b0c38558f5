// Runs other programs.
import { spawn, spawnSync } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import path from 'node:path';
import { Explained, step } from './log.mjs';
import { root } from './paths.mjs';

const tailLength = 16_000;

// Running programs, stopped together with the script.
const running = new Set();
for (const [signal, number] of [
  ['SIGINT', 2],
  ['SIGTERM', 15],
  ['SIGHUP', 1],
]) {
  process.on(signal, () => {
    for (const child of running) child.kill(signal);
    process.exit(128 + number);
  });
}

/**
 * Runs a program to its end. On failure, rejects with the last part of its output. `show`: 'all' passes the output to
 * stderr immediately, 'after' when the program has ended, 'quiet' keeps it for the error message. `inherit` connects
 * all three streams, for programs whose output is that of the command.
 */
export function run(
  program,
  args,
  { cwd = root, env = {}, show = 'quiet', inherit = false, allowFailure = false } = {},
) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: inherit ? 'inherit' : ['ignore', 'pipe', 'pipe'],
    });
    running.add(child);
    child.on('close', () => running.delete(child));
    let tail = '';
    const kept = [];
    const take = (chunk) => {
      tail = (tail + chunk).slice(-tailLength);
      if (show === 'all') process.stderr.write(chunk);
      if (show === 'after') kept.push(chunk);
    };
    child.stdout?.on('data', take);
    child.stderr?.on('data', take);
    child.on('error', (error) => reject(new Explained(`cannot run ${program}: ${error.message}`)));
    child.on('close', (code, signal) => {
      process.stderr.write(Buffer.concat(kept));
      if (code === 0 || allowFailure) return resolve({ code: code ?? 1, tail });
      const said = show !== 'quiet' || inherit ? '' : `\n${tail.trimEnd()}`;
      reject(new Explained(`${program} ${args.join(' ')} failed (${signal ?? `exit code ${code}`})${said}`));
    });
  });
}

/** A program's stdout, or null if it cannot be run or fails. */
export function capture(program, args, { env = {}, cwd = root } = {}) {
  const result = spawnSync(program, args, { encoding: 'utf8', cwd, env: { ...process.env, ...env } });
  return result.status === 0 ? result.stdout : null;
}

/** The full path of a program on PATH, or null. */
export function which(program, searchPath = process.env.PATH ?? '') {
  for (const folder of searchPath.split(path.delimiter)) {
    const candidate = path.join(folder, program);
    try {
      accessSync(candidate, constants.X_OK);
      if (folder && statSync(candidate).isFile()) return candidate;
    } catch {
      // the program is not in this folder
    }
  }
  return null;
}

/** Retries a network action a few times with increasing delays. The action receives the number of the attempt. */
export async function withRetries(what, action, attempts = 3) {
  for (let attempt = 1; ; ++attempt) {
    try {
      return await action(attempt);
    } catch (error) {
      if (attempt === attempts) throw error;
      step(`${what} failed, trying again (${attempt} of ${attempts - 1})`);
      await new Promise((wake) => setTimeout(wake, 3000 * attempt));
    }
  }
}
