/** Results of the installed package in Node for a project's poses. */
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import type { Outcome } from './project.ts';

const PROGRAM = `
  import { createEngine } from 'shapespline';
  import { readFile } from 'node:fs/promises';
  const read = async (name) => ({ name, bytes: await readFile('public/' + name) });
  const engine = createEngine();
  const keys = await engine.importKeyframes([await read('pose-0.glb'), await read('pose-1.glb')]);
  const sequence = await engine.createSequence(keys);
  const { positions } = await sequence.evaluate(0.5);
  console.log(JSON.stringify({ vertices: positions.length / 3, sum: positions.reduce((s, x) => s + Math.abs(x), 0) }));
  engine.dispose();
`;

export async function sumInNode(folder: string): Promise<Required<Omit<Outcome, 'error'>>> {
  const run = promisify(execFile);
  return JSON.parse((await run(process.execPath, ['--input-type=module', '-e', PROGRAM], { cwd: folder })).stdout);
}
