// Progress goes to stderr: stdout belongs to the command itself (a URL, a report, the CLI's JSON).
const started = Date.now();

export function step(text) {
  const seconds = ((Date.now() - started) / 1000).toFixed(0).padStart(3);
  process.stderr.write(`[${seconds} s] ${text}\n`);
}

/** A failure that is explained by its message alone; `run.mjs` prints it without a stack. */
export class Explained extends Error {}
