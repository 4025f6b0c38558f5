// Progress goes to stderr, because stdout has the command's result (a URL, a report, the CLI's JSON).
const started = Date.now();

export function step(text) {
  const seconds = ((Date.now() - started) / 1000).toFixed(0).padStart(3);
  process.stderr.write(`[${seconds} s] ${text}\n`);
}

/** A failure whose message explains it completely; `run.mjs` prints it without a stack. */
export class Explained extends Error {}
