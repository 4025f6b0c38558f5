/** Runs the CLI as a process in a new folder. */
import { spawn } from 'node:child_process';
import { mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll } from 'vitest';
import type { InputFile } from '../../../web/engine/api/types.ts';

export const program = fileURLToPath(new URL('../../../build/node/cli.mjs', import.meta.url));
const folders: string[] = [];

afterAll(async () => {
  for (const folder of folders.splice(0)) await rm(folder, { recursive: true, force: true });
});

/** A new folder with these files. */
export async function folderOf(files: InputFile[]): Promise<string> {
  const folder = await mkdtemp(path.join(tmpdir(), 'shapespline-cli-'));
  folders.push(folder);
  for (const { name, bytes } of files) await writeFile(path.join(folder, name), bytes);
  return folder;
}

/** All paths in a folder, relative to it. */
export async function listed(folder: string): Promise<string[]> {
  return (await readdir(folder, { recursive: true })).map((name) => name.replaceAll(path.sep, '/')).sort();
}

export interface Outcome {
  code: number | null;
  stdout: string;
  stderr: string;
}

export function runCli(folder: string, ...words: string[]): Promise<Outcome> {
  return runNode(folder, program, ...words);
}

/** Runs Node with these words. */
export function runNode(folder: string, ...words: string[]): Promise<Outcome> {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, words, { cwd: folder });
    const outcome: Outcome = { code: null, stdout: '', stderr: '' };
    child.stdout.on('data', (chunk: Buffer) => (outcome.stdout += chunk.toString()));
    child.stderr.on('data', (chunk: Buffer) => (outcome.stderr += chunk.toString()));
    child.on('close', (code) => resolve({ ...outcome, code }));
  });
}
