/** A page author's project: the installed package, two poses, and a script that uses them. */
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { afterAll, inject } from 'vitest';
import { draco } from '../../engine/support/compress.ts';
import { poseFiles } from '../../engine/support/glb.ts';
import { bar, bent } from '../../engine/support/shapes.ts';

/** The package's folder in a project. */
export const packageIn = (project: string): string => path.join(project, 'node_modules', 'shapespline');

/** Compressed, to use every file of the package: worker, both wasm files, codecs. */
const poses = draco(
  poseFiles(
    bar(),
    [0, 60].map((degrees) => bent(bar(), degrees)),
  ),
);

const folders: string[] = [];
afterAll(() => {
  for (const folder of folders.splice(0)) rmSync(folder, { recursive: true, force: true });
});

/** Expected output: a number for the frame between the keys, or the error's message. */
export interface Outcome {
  vertices?: number;
  /** Sum of all coordinates. */
  sum?: number;
  error?: string;
}

/** `from`: import path of the engine; `first`: code to run before an engine is made. */
export const script = (from = 'shapespline', first = ''): string => `
  import { configure, createEngine } from '${from}';
  ${first}
  const read = async (name) =>
    ({ name, bytes: new Uint8Array(await (await fetch(new URL(name, document.baseURI))).arrayBuffer()) });
  try {
    const engine = createEngine();
    const keys = await engine.importKeyframes([await read('pose-0.glb'), await read('pose-1.glb')]);
    const sequence = await engine.createSequence(keys);
    const { positions } = await sequence.evaluate(0.5);
    window.outcome = { vertices: positions.length / 3, sum: positions.reduce((sum, x) => sum + Math.abs(x), 0) };
  } catch (error) {
    window.outcome = { error: String(error) };
  }
`;

/** A new folder with the package, `index.html`, `main.js` and the poses in `public`. */
export async function newProject(files: Record<string, string> = {}): Promise<string> {
  const folder = mkdtempSync(path.join(path.dirname(inject('installed')), 'project-'));
  folders.push(folder);
  cpSync(path.join(inject('installed'), 'node_modules'), path.join(folder, 'node_modules'), { recursive: true });
  mkdirSync(path.join(folder, 'public'));
  for (const [index, { bytes }] of (await poses).entries())
    writeFileSync(path.join(folder, 'public', `pose-${index}.glb`), bytes);
  const all = {
    'package.json': '{ "name": "project", "private": true, "type": "module" }',
    'index.html': '<!doctype html><title>A page</title><script type="module" src="./main.js"></script>',
    'main.js': script(),
    ...files,
  };
  for (const [name, text] of Object.entries(all)) {
    mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
    writeFileSync(path.join(folder, name), text);
  }
  return folder;
}
