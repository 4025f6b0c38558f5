/** A program that stays and replies to each empty line with a line of JSON, one at a time. */
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';

export interface LineProtocol {
  /** Unrequested output. */
  next(): Promise<unknown>;
  ask(): Promise<unknown>;
}

/** The program ends with the work. A reply that never comes because it has ended before is an error. */
export async function withProgram<T>(
  program: string,
  args: string[],
  env: Record<string, string>,
  work: (lines: LineProtocol) => Promise<T>,
): Promise<T> {
  const child = spawn(program, args, { stdio: ['pipe', 'pipe', 'inherit'], env: { ...process.env, ...env } });
  child.stdin.on('error', () => undefined); // one that has ended is noticed by its missing reply
  const ended = new Promise((end) => child.once('close', end));
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const next = async (): Promise<unknown> => {
    const line = await lines.next();
    if (line.done) throw new Error(`${program} ended without a reply`);
    return JSON.parse(line.value);
  };
  const ask = (): Promise<unknown> => {
    child.stdin.write('\n');
    return next();
  };
  try {
    return await work({ next, ask });
  } finally {
    child.stdin.end();
    await ended;
  }
}
