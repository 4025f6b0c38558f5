/**
 * Files that declare, nest or chain more than they contain. Each is refused in one line, with memory in proportion to
 * its size, like an ordinary file. The figures are printed.
 */
import { spawn } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { oneInput } from '../fuzz/decoders-input.ts';
import { program } from './support/cli.ts';
import { draco, meshopt } from './support/compress.ts';
import { glbParts, gltfInside as gltf, meshGlb, poseFiles } from './support/glb.ts';
import { bar } from './support/shapes.ts';

const MB = 1e6;
/** Memory of Node, its workers and the module, including garbage. */
const AT_REST = 450 * MB;
/** Memory for an OBJ over its size: its bytes in the program, its worker and the module, and its numbers. */
const TIMES_ITS_SIZE = 5;

const fuzzed = fileURLToPath(new URL('../fuzz/found', import.meta.url));
const peakMemory = fileURLToPath(new URL('support/peak-memory.mjs', import.meta.url));
const mesh = bar();
const rows: string[] = [];
let folder = '';

beforeAll(async () => {
  folder = await mkdtemp(path.join(tmpdir(), 'hostile-'));
});
afterAll(async () => {
  await rm(folder, { recursive: true });
  console.log([`${'input'.padEnd(48)}      size   seconds      peak`, ...rows].join('\n'));
});

interface Outcome {
  code: number | null;
  stderr: string;
  peak: number;
}

function inspect(file: string): Promise<Outcome> {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, ['--import', peakMemory, program, 'inspect', file], {
      cwd: folder,
      stdio: ['ignore', 'ignore', 'pipe', 'pipe'],
    });
    let [stderr, peak] = ['', ''];
    child.stdio[2]!.on('data', (chunk: Buffer) => {
      stderr += chunk.toString();
    });
    child.stdio[3]!.on('data', (chunk: Buffer) => {
      peak += chunk.toString();
    });
    child.on('close', (code) => resolve({ code, stderr, peak: Number(peak) }));
  });
}

async function refused(what: string, name: string, content: Uint8Array | string, sentence: RegExp): Promise<void> {
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  await writeFile(path.join(folder, name), bytes);
  const started = performance.now();
  const { code, stderr, peak } = await inspect(name);
  const seconds = (performance.now() - started) / 1000;
  const numbers = [`${(bytes.length / MB).toFixed(3)} MB`, seconds.toFixed(1), `${(peak / MB).toFixed(0)} MB`];
  rows.push(what.padEnd(48) + numbers.map((one) => one.padStart(10)).join(''));
  expect([code, stderr]).toEqual([1, expect.stringMatching(sentence)]);
  expect(stderr.match(/\n/g)).toHaveLength(1);
  expect(peak).toBeGreaterThan(10 * MB);
  expect(peak).toBeLessThan(AT_REST + TIMES_ITS_SIZE * bytes.length);
}

describe('memory is bounded by the file:', () => {
  it('an OBJ of 100 MB @all', { timeout: 120_000 }, async () => {
    const line = 'v 0.123456789 0.123456789 0.123456789\n';
    const faces = 'f 1 2 3\n'.repeat(1_000_000);
    const text = line.repeat(Math.ceil((100 * MB - faces.length) / line.length)) + faces;
    await refused('OBJ', 'large.obj', text, /has only one pose/);
  });

  it('nested lists', () =>
    refused('{"a": and 40 million [', 'nested.gltf', `{"a":${'['.repeat(40e6)}`, /nested more than 100 levels deep/));

  it('empty objects', () =>
    refused(
      '13 million nodes, 3 bytes each',
      'empty.gltf',
      `{"asset":{"version":"2.0"},"nodes":[${'{},'.repeat(13e6)}{}]}`,
      /limit of 250,000 objects/,
    ));

  it('a chain of nodes', () =>
    refused(
      'a million nodes in a chain',
      'chain.gltf',
      `{"asset":{"version":"2.0"},"nodes":[${Array.from({ length: 1e6 }, (_, i) => `{"children":[${i + 1}]}`).join()},{}]}`,
      /limit of 250,000 objects/,
    ));

  it('the longest allowed chain of nodes @all', () => {
    const nodes = Array.from({ length: 240_000 }, (_, i) => `{"children":[${i + 1}]}`).join();
    return refused(
      '240,000 nodes in a chain',
      'short-chain.gltf',
      `{"asset":{"version":"2.0"},"nodes":[${nodes},{}]}`,
      /no mesh/,
    );
  });

  it('a few bytes of meshopt', async () => {
    const [file] = await meshopt(poseFiles(mesh, [mesh.positions]));
    const { json, bin } = glbParts(file!.bytes);
    const views = (json as unknown as { bufferViews: { extensions?: Record<string, { count: number }> }[] })
      .bufferViews;
    views.find(({ extensions }) => extensions)!.extensions!['EXT_meshopt_compression']!.count = 150e6;
    await refused('meshopt that declares 1.8 GB', 'meshopt.gltf', gltf(json, bin), /declares more than its \d+ bytes/);
  });

  it('a few bytes of Draco', async () => {
    const [file] = await draco(poseFiles(mesh, [mesh.positions]));
    const { json, bin } = glbParts(file!.bytes);
    // The numbers of vertices and faces follow the header and the encoding method.
    expect(new TextDecoder().decode(bin.subarray(0, 5))).toBe('DRACO');
    const ends = (at: number): number => (bin[at]! < 128 ? at + 1 : ends(at + 1));
    const many = [0xff, 0xff, 0xff, 0x7f]; // encodes 268 million
    const rest = bin.subarray(ends(ends(12)));
    const changed = Uint8Array.from([...bin.subarray(0, 12), ...many, ...many, ...rest]);
    const { bufferViews } = json as unknown as { bufferViews: { byteLength: number }[] };
    bufferViews[0]!.byteLength += changed.length - bin.length;
    await refused('Draco that declares 268 million faces', 'draco.gltf', gltf(json, changed), /cannot be decoded/);
  });

  it('an accessor that extends beyond its view', async () => {
    const [file] = await meshopt(poseFiles(mesh, [mesh.positions]));
    const { json, bin } = glbParts(file!.bytes);
    const { accessors } = json as unknown as { accessors: { count: number }[] };
    accessors[0]!.count = 500e6;
    await refused(
      '500 million elements of a small view',
      'long.gltf',
      gltf(json, bin),
      /expands to more than the 67 MB/,
    );
  });

  it('a node that is its own parent, with every compression', async () => {
    const plain = poseFiles(mesh, [mesh.positions]);
    for (const [name, files] of Object.entries({ plain, meshopt: await meshopt(plain), draco: await draco(plain) })) {
      const { json, bin } = glbParts(files[0]!.bytes);
      const { nodes } = json as unknown as { nodes: { children?: number[] }[] };
      const cycle = [{ children: [2] }, { children: [1] }];
      for (const [what, changed] of [
        ['is its own child', [{ ...nodes[0], children: [0] }, ...nodes.slice(1)]],
        ['cycle', [nodes[0]!, ...cycle]],
      ] as const) {
        Object.assign(json, { nodes: changed });
        await refused(`${name}: a node ${what}`, `${name}.gltf`, gltf(json, bin), new RegExp(what));
      }
    }
  });
});

it('all findings of the fuzz targets of the decoders are handled', async () => {
  const found = ['meshopt', 'draco'].map((target) => path.join(fuzzed, target)).filter((place) => existsSync(place));
  const files = found.flatMap((place) => readdirSync(place).map((name) => path.join(place, name)));
  for (const file of files) await oneInput(new Uint8Array(readFileSync(file)));
  const [sound] = await meshopt(poseFiles(mesh, [mesh.positions]));
  expect(await oneInput(sound!.bytes)).toBe(true);
});

it('the files are valid without their changes', async () => {
  expect(meshGlb(mesh).length).toBeGreaterThan(1000);
  for (const compress of [meshopt, draco]) {
    const [file] = await compress(poseFiles(mesh, [mesh.positions]));
    const { json, bin } = glbParts(file!.bytes);
    await refused(
      `${compress.name}, sound, of one pose`,
      `sound.gltf`,
      gltf(json, bin),
      /only one pose|fewer than two|one key/,
    );
  }
});
