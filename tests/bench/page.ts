/** What the benchmark's page runs: the engine in the browser's own worker. */
import { EngineClient } from '../../web/engine/engine.ts';
import { endedWorker, type Spawn } from '../../web/engine/remote.ts';
import type { FromWorker } from '../../web/engine/protocol.ts';
import { measure, type Run } from './measure.ts';

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

export async function measureFile(mesh: string): Promise<Run> {
  const engine = new EngineClient({ spawn, module: fetchBytes(beside('wasm/shapespline.wasm')).then((bytes) => WebAssembly.compile(bytes)) });
  try {
    return await measure(engine, {
      name: 'bench.glb',
      mesh: new Uint8Array(await fetchBytes(mesh)),
      reference: new Float64Array(await fetchBytes(`${mesh}.reference`)),
      reader: await fetchBytes(beside('cmake-wasm/shapespline_bench_read.wasm')),
    });
  } finally {
    engine.dispose();
  }
}
