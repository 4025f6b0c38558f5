/** Blender as a Python module: runs a script of this folder. */
import { spawn } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe } from 'vitest';
import { installBlender } from '../../wasm/toolchain/blender.mjs';

const python = await installBlender();

/** Tests in the real Blender; skipped if it is not installed. */
export const describeBlender = describe.skipIf(python === null);

/**
 * Runs `script` (a Python file of this folder) in a Blender with an empty scene, and returns the value passed to
 * `answer`. The script gets `args` from `arguments()`; both functions are in `blender_script.py`.
 */
export async function runInBlender<T>(script: string, args: object): Promise<T> {
  const folder = await mkdtemp(path.join(tmpdir(), 'shapespline-blender-'));
  try {
    const asked = path.join(folder, 'arguments.json');
    const answered = path.join(folder, 'answer.json');
    await writeFile(asked, JSON.stringify(args));
    await runPython(fileURLToPath(new URL(script, import.meta.url)), asked, answered);
    return JSON.parse(await readFile(answered, 'utf8')) as T;
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

function runPython(...words: string[]): Promise<void> {
  return new Promise((resolve, reject) => {
    const child = spawn(python!, words, { env: { ...process.env, PYTHONDONTWRITEBYTECODE: '1' } });
    let said = '';
    const hear = (chunk: Buffer): void => {
      said = (said + chunk.toString()).slice(-8000);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.on('error', reject);
    child.on('close', (code) => (code === 0 ? resolve() : reject(new Error(`Blender ended with ${code}:\n${said}`))));
  });
}
