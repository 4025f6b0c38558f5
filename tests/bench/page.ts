/** Runs in the benchmark's page: the engine in the browser's worker. Files are URLs. */
import type { Engine } from '../../web/engine/api/api.ts';
import { EngineClient, onlyOnce } from '../../web/engine/caller/engine.ts';
import { endedWorker, type Spawn } from '../../web/engine/caller/worker-client.ts';
import type { FromWorker } from '../../web/engine/wire/protocol.ts';
import type { RunNative } from './native-round.ts';
import { compareKeys, type KeysRun } from './key-counts.ts';
import { measure, type Run } from './measure.ts';
import { REFERENCE } from './runner.ts';
import { compareResolutions, type Resolutions } from './resolutions.ts';
import { runMotion, type Motion, type MotionRun } from './whole-sequences.ts';

const spawn: Spawn = (events) => {
  const worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
  worker.onmessage = ({ data }: MessageEvent<FromWorker>) => events.message(data);
  worker.onerror = ({ message }) => events.failure(endedWorker(message));
  return { post: (message, transfer) => worker.postMessage(message, transfer), terminate: () => worker.terminate() };
};

async function fetchBytes(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response.arrayBuffer();
}

const beside = (file: string): string => new URL(file, new URL('../', import.meta.url)).href;
const meshOf = async (url: string): Promise<Uint8Array> => new Uint8Array(await fetchBytes(url));

const compile = async (name: string): Promise<WebAssembly.Module> =>
  WebAssembly.compile(await fetchBytes(beside(`wasm/${name}.wasm`)));

/** Targets are for one thread. */
async function withEngine<T>(work: (engine: Engine) => Promise<T>): Promise<T> {
  const filesModule = onlyOnce(() => compile('shapespline_files'));
  const shellsModule = onlyOnce(() => compile('shapespline_shells'));
  const engine = new EngineClient({ spawn, module: compile('shapespline'), filesModule, shellsModule, threaded: null });
  try {
    return await work(engine);
  } finally {
    engine.dispose();
  }
}

export function measureFile(mesh: string, runNative: RunNative): Promise<Run> {
  return withEngine(async (engine) =>
    measure(engine, {
      name: 'bench.glb',
      mesh: await meshOf(mesh),
      reference: async (k) => new Float64Array(await fetchBytes(mesh + REFERENCE + k)),
      reader: await fetchBytes(beside('cmake-wasm/shapespline_bench_read.wasm')),
      runNative,
      // A page cannot measure this.
      processBytes: () => NaN,
    }),
  );
}

export function motionOf(mesh: string, motion: Motion): Promise<MotionRun> {
  return withEngine(async (engine) => runMotion(engine, 'bench.glb', await meshOf(mesh), motion));
}

export function resolutionsOf(coarse: string, fine: string): Promise<Resolutions> {
  return withEngine(async (engine) => compareResolutions(engine, await meshOf(coarse), await meshOf(fine)));
}

export function keysOf(few: string, many: string, count: number): Promise<KeysRun> {
  return withEngine(async (engine) => compareKeys(engine, await meshOf(few), await meshOf(many), count));
}
