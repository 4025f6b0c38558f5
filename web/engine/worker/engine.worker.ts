/** The browser's worker. */
import createWasm from '../../../build/wasm/shapespline.mjs';
import { acquireLock } from '../wire/worker-lock.ts';
import { codecs } from './codecs.ts';
import { decoder } from './decompress.ts';
import type { Locked, Ready, ToWorker } from '../wire/protocol.ts';
import { RequestHandler } from './request-handler.ts';

async function dracoWasm(): Promise<Uint8Array> {
  const { default: url } = await import('draco3dgltf/draco_decoder_gltf.wasm?url');
  const response = await fetch(new URL(url, import.meta.url));
  if (!response.ok) throw new Error(`the decoder could not be fetched: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

const handler = new RequestHandler({
  post: (message, transfer) => self.postMessage(message, { transfer }),
  create: createWasm,
  createThreaded: async () => (await import('../../../build/wasm/shapespline_threads.mjs')).default,
  createFiles: async () => (await import('../../../build/wasm/shapespline_files.mjs')).default,
  startShells: async (module) => (await import('./start-shells.ts')).startShells(module),
  startSecondThread: (start, onReady) => {
    const secondThread = new Worker(new URL('./second-thread.worker.ts', import.meta.url), { type: 'module' });
    secondThread.onmessage = onReady;
    secondThread.onerror = (event) => event.preventDefault();
    secondThread.postMessage(start);
  },
  decode: decoder(codecs, dracoWasm),
  codecs,
});
if (self.name) acquireLock(self.name, () => self.postMessage({ type: 'locked' } satisfies Locked));
self.addEventListener('message', ({ data }: MessageEvent<ToWorker>) => handler.receive(data));
self.postMessage({ type: 'ready' } satisfies Ready);
