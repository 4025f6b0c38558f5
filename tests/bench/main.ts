/**
 * npm run bench [-- FACES,FACES,...]: times of every stage over generated meshes, in Node on the app's own wasm.
 * Medians and 95th percentiles of single frames; machines differ, so compare columns of one run.
 */
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { cpus, tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createEngine } from '../../web/engine/node.ts';
import { benchGhost } from './ghost.ts';

const DEFAULT_SIZES = [10_000, 32_000, 80_000];
const FRAMES = 60;
/** Seconds for one frame without a ghost mesh, from Table 1 of the paper, by faces. */
const PAPER_SECONDS: Record<number, number> = { 10_000: 0.25, 32_000: 0.75, 80_000: 1.29, 332_000: 6.5, 1_300_000: 37.2 };
const generator = fileURLToPath(new URL('../cmake-wasm/shapespline_samples.js', import.meta.url));

interface Row {
  faces: number;
  vertices: number;
  importMs: number;
  weldMs: number;
  encodeMs: number;
  orderMs: number;
  factorMs: number;
  firstMs: number;
  medianMs: number;
  slowMs: number;
  heapMB: number;
}

/** The middle of sorted values, or another quantile. */
function quantile(values: number[], q: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? Number.NaN;
}

async function measure(file: string): Promise<Row> {
  const engine = createEngine();
  try {
    const bytes = new Uint8Array(await readFile(file));
    const importStart = performance.now();
    const keys = await engine.importKeyframes([{ name: path.basename(file), bytes }]);
    const importMs = performance.now() - importStart;
    const sequence = await engine.createSequence(keys);
    const ms: number[] = [];
    for (let k = 0; k <= FRAMES; k++) {
      const frame = await sequence.evaluate(-0.2 + (1.4 * k) / FRAMES);
      if (!frame) throw new Error('a frame was overtaken although none else was asked for');
      ms.push(frame.ms);
      frame.release();
    }
    const stats = await sequence.stats();
    const { vertices, faces } = keys.info.report;
    const { weldMs, encodeMs, orderMs, factorMs } = stats;
    const [firstMs = Number.NaN, ...rest] = ms;
    return {
      faces, vertices, importMs, weldMs, encodeMs, orderMs, factorMs, firstMs,
      medianMs: quantile(rest, 0.5), slowMs: quantile(rest, 0.95), heapMB: stats.heapBytes / 2 ** 20,
    };
  } finally {
    engine.dispose();
  }
}

function print(rows: Row[]): void {
  const titles = ['faces', 'vertices', 'import', 'weld', 'encode', 'order', 'factor', 'first', 'frame', '95 %', 'heap MB', 'paper', 'times faster'];
  const table = rows.map((row) => {
    const paper = PAPER_SECONDS[Math.round(row.faces / 1000) * 1000];
    const ms = [row.importMs, row.weldMs, row.encodeMs, row.orderMs, row.factorMs, row.firstMs, row.medianMs, row.slowMs];
    return [
      String(row.faces), String(row.vertices), ...ms.map((value) => value.toFixed(value < 10 ? 2 : 0)), row.heapMB.toFixed(0),
      paper ? String(paper * 1000) : '-', paper ? ((paper * 1000) / row.medianMs).toFixed(0) : '-',
    ];
  });
  const widths = titles.map((title, column) => Math.max(title.length, ...table.map((line) => line[column]!.length)));
  for (const line of [titles, ...table]) console.log(line.map((cell, column) => cell.padStart(widths[column]!)).join('  '));
}

function sizesFrom(argument: string | undefined): number[] {
  if (argument === undefined) return DEFAULT_SIZES;
  const sizes = argument.split(',').map(Number);
  if (sizes.some((size) => !Number.isInteger(size) || size < 64 || size > 4_000_000)) {
    console.error('usage: npm run bench [-- FACES,FACES,...] with 64 to 4000000 faces each');
    process.exit(2);
  }
  return sizes;
}

if (process.argv[2] === 'ghost') process.exit(await benchGhost(process.argv.slice(3)));
const sizes = sizesFrom(process.argv[2]);
if (!existsSync(generator)) throw new Error(`the generator of benchmark meshes is missing: ${generator}`);
const folder = await mkdtemp(path.join(tmpdir(), 'shapespline-bench-'));
try {
  const rows: Row[] = [];
  for (const faces of sizes) {
    execFileSync(process.execPath, [generator, '--bench', String(faces), folder], { stdio: ['ignore', 'ignore', 'inherit'] });
    rows.push(await measure(path.join(folder, `bench-${faces}.glb`)));
  }
  console.log(`\n${cpus()[0]?.model ?? 'unknown processor'}, Node ${process.version}; 3 keys; milliseconds; frame = median of ${FRAMES}\n`);
  print(rows);
} finally {
  await rm(folder, { recursive: true, force: true });
}
