/** A program that keeps running and replies to each empty line with a line of JSON. */
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';

export interface LineProtocol {
  /** Reads the program's next line without a request. */
  next(): Promise<unknown>;
  ask(): Promise<unknown>;
}

/** Ends the program after the work. Reports an error if the program ends before a reply. */
export async function withProgram<T>(
  program: string,
  args: string[],
  env: Record<string, string>,
  work: (lines: LineProtocol) => Promise<T>,
): Promise<T> {
  const child = spawn(program, args, { stdio: ['pipe', 'pipe', 'inherit'], env: { ...process.env, ...env } });
  child.stdin.on('error', () => undefined); // an ended program is noticed by its missing reply
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
