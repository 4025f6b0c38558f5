/** One generated mesh through the engine: every stage of building its sequence, then single frames. Browser and Node. */
import type { Engine, Keys, Sequence } from '../../web/engine/api.ts';
import type { SequenceStats } from '../../web/engine/types.ts';
import { readBandwidth } from './bandwidth.ts';
import { quantile, spread, type Spread } from './quantile.ts';

/** Where frames are compared with those of the double precision. */
export const REFERENCE_TIME = 0.3;
const FRAMES = 60;
const BUILDS = 5;
/** No further sequence is built once they took so long together. */
const LONG_ENOUGH_MS = 15_000;

/** Milliseconds and bytes. */
export interface Run {
  faces: number;
  vertices: number;
  importMs: number;
  weldMs: number;
  encodeMs: number;
  orderMs: number;
  factorMs: number;
  buildMs: number;
  /** Sequences built: the stages above are their medians. */
  builds: number;
  /** Longest time without a sign of progress while one was built. */
  silentMs: number;
  /** The stage that was reported after it. */
  silentStage: string;
  firstMs: number;
  spline: Spread;
  solve: Spread;
  place: Spread;
  normals: Spread;
  frame: Spread;
  /** The cheap shape while a slider moves. */
  preview: Spread;
  heapBytes: number;
  factorBytes: number;
  /** Bytes a second. */
  bandwidth: number;
  /** Largest distance to the reference over the bounding box's diagonal. */
  error: number;
}

export interface Input {
  name: string;
  mesh: Uint8Array;
  /** The shape at REFERENCE_TIME: 3 numbers a vertex. */
  reference: Float64Array;
  /** The module that reads memory. */
  reader: BufferSource;
}

type Built = Pick<SequenceStats, 'weldMs' | 'encodeMs' | 'orderMs' | 'factorMs'> & { buildMs: number; silentMs: number; silentStage: string };

async function build(engine: Engine, keys: Keys): Promise<{ sequence: Sequence; built: Built }> {
  const start = performance.now();
  let last = start, silentMs = 0, silentStage = '';
  const tick = (stage: string): void => {
    const now = performance.now();
    if (now - last > silentMs) [silentMs, silentStage] = [now - last, stage];
    last = now;
  };
  const sequence = await engine.createSequence(keys, {}, { onProgress: ({ stage, fraction }) => tick(`${stage} ${fraction.toFixed(2)}`) });
  tick('end');
  const { weldMs, encodeMs, orderMs, factorMs } = await sequence.stats();
  return { sequence, built: { weldMs, encodeMs, orderMs, factorMs, buildMs: performance.now() - start, silentMs, silentStage } };
}

interface FrameTimes {
  ms: number;
  stats: SequenceStats;
}

async function frameAt(sequence: Sequence, t: number): Promise<FrameTimes> {
  const frame = await sequence.evaluate(t);
  if (!frame) throw new Error('a frame was overtaken although none else was asked for');
  frame.release();
  return { ms: frame.ms, stats: await sequence.stats() };
}

async function errorOf(sequence: Sequence, reference: Float64Array): Promise<number> {
  const frame = await sequence.evaluate(REFERENCE_TIME);
  if (frame?.positions.length !== reference.length) throw new Error('the reference belongs to another mesh');
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  let largest = 0;
  for (let v = 0; v < reference.length; v += 3) {
    let squared = 0;
    for (let k = 0; k < 3; ++k) {
      const x = reference[v + k]!;
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
      squared += (frame.positions[v + k]! - x) ** 2;
    }
    largest = Math.max(largest, squared);
  }
  frame.release();
  return Math.sqrt(largest) / Math.hypot(...high.map((h, k) => h - low[k]!));
}

export async function measure(engine: Engine, { name, mesh, reference, reader }: Input): Promise<Run> {
  const importStart = performance.now();
  const keys = await engine.importKeyframes([{ name, bytes: mesh }]);
  const importMs = performance.now() - importStart;
  const builds: Built[] = [];
  const stage = (of: Exclude<keyof Built, 'silentStage'>): number => quantile(builds.map((one) => one[of]));

  let { sequence, built } = await build(engine, keys);
  builds.push(built);
  const { heapBytes } = await sequence.stats();  // the import's memory is the same heap
  while (builds.length < BUILDS && builds.reduce((sum, { buildMs }) => sum + buildMs, 0) < LONG_ENOUGH_MS) {
    sequence.dispose();
    ({ sequence, built } = await build(engine, keys));
    builds.push(built);
  }
  const bandwidth = await readBandwidth(reader);
  const { ms: firstMs } = await frameAt(sequence, 0);
  const frames: FrameTimes[] = [];
  for (let k = 0; k <= FRAMES; ++k) frames.push(await frameAt(sequence, -0.2 + (1.4 * k) / FRAMES));
  await sequence.preview(0.1);  // makes the embedding
  const previews: number[] = [];
  for (let k = 0; k <= FRAMES; ++k) {
    const frame = await sequence.preview(-0.2 + (1.4 * k) / FRAMES);
    previews.push(frame?.ms ?? Number.NaN);
    frame?.release();
  }
  const part = (of: (frame: FrameTimes) => number): Spread => spread(frames.map(of));
  const stats = await sequence.stats();
  const quietest = builds.reduce((best, one) => (one.silentMs < best.silentMs ? one : best));
  const { vertices, faces } = keys.info.report;
  return {
    faces,
    vertices,
    importMs,
    weldMs: stage('weldMs'),
    encodeMs: stage('encodeMs'),
    orderMs: stage('orderMs'),
    factorMs: stage('factorMs'),
    buildMs: stage('buildMs'),
    builds: builds.length,
    silentMs: quietest.silentMs,
    silentStage: quietest.silentStage,
    firstMs,
    spline: part(({ stats: s }) => s.facesMs),
    solve: part(({ stats: s }) => s.solveMs),
    place: part(({ stats: s }) => s.placeMs),
    normals: part(({ stats: s }) => s.normalsMs),
    frame: part(({ ms }) => ms),
    preview: spread(previews),
    heapBytes: Math.max(heapBytes, stats.heapBytes),
    factorBytes: stats.factorBytes,
    bandwidth,
    error: await errorOf(sequence, reference),
  };
}
