/** The package in common bundlers, in their default setup. */
import { cpSync } from 'node:fs';
import path from 'node:path';
import * as esbuild from 'esbuild';
import * as vite7 from 'vite';
import * as vite8 from 'vite8';
import { beforeAll, describe, expect, it } from 'vitest';
import { host, outcomeOf } from './support/browser.ts';
import { sumInNode } from './support/expected.ts';
import { newProject, type Outcome, packageIn, script } from './support/project.ts';

let project: string;
let expected: Outcome;
beforeAll(async () => {
  project = await newProject();
  expected = await sumInNode(project);
});

async function expectRunsAt(url: string): Promise<void> {
  const outcome = await outcomeOf(url);
  expect(outcome.error).toBeUndefined();
  expect(outcome.vertices).toBe(expected.vertices);
  expect(outcome.sum! / expected.sum!).toBeCloseTo(1, 6);
}

type Vite = Pick<typeof vite7, 'createServer' | 'build'>;

describe.each([
  ['Vite 7', vite7 as Vite],
  ['Vite 8', vite8 as unknown as Vite],
])('%s', (_, vite) => {
  const settings = (root: string) => ({ root, configFile: false as const, logLevel: 'error' as const });

  it('serves it in development, without any setting', async () => {
    const folder = await newProject();
    const server = await vite.createServer({ ...settings(folder), server: { port: 0, host: 'localhost' } });
    try {
      await server.listen();
      await expectRunsAt(server.resolvedUrls!.local[0]!);
    } finally {
      await server.close();
    }
  });
});

/** esbuild keeps URLs unchanged, so the test copies these files, as the package's README describes. */
const copied = ['worker.js', 'codecs.js', 'shapespline.wasm', 'shapespline_files.wasm', 'draco_decoder_gltf.wasm'];

it('esbuild builds it for a classic script, with the URLs of all files except the one next to the wasm', async () => {
  const first =
    "configure({ wasmUrl: 'lib/shapespline.wasm', workerUrl: 'lib/worker.js', dracoUrl: 'lib/draco_decoder_gltf.wasm' });";
  const folder = await newProject({
    'main.js': `void (async () => { const { configure, createEngine } = await import('shapespline'); ${script().split('\n').slice(2).join('\n').replace(/^/, first)} })();`,
    'index.html': '<!doctype html><script src="main.js"></script>',
  });
  const output = path.join(folder, 'dist');
  const format = 'iife';
  const entryPoints = ['main.js'];
  await esbuild.build({ absWorkingDir: folder, entryPoints, bundle: true, outdir: output, format, logLevel: 'silent' });
  for (const name of copied) cpSync(path.join(packageIn(folder), name), path.join(output, 'lib', name));
  await expectRunsAt(await host([output, folder, path.join(folder, 'public')]));
});
