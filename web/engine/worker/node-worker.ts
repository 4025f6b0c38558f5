/** The worker thread of Node. */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { parentPort, Worker } from 'node:worker_threads';
import createWasm from '../../../build/wasm/shapespline.mjs';
import { decoder } from './decompress.ts';
import type { ToWorker } from '../wire/protocol.ts';
import { RequestHandler } from './request-handler.ts';

const require = createRequire(import.meta.url);

const handler = new RequestHandler({
  post: (message, transfer) => parentPort?.postMessage(message, transfer),
  create: createWasm,
  createThreaded: async () => (await import('../../../build/wasm/shapespline_threads.mjs')).default,
  startSecondThread: (start, onReady) => {
    const secondThread = new Worker(new URL('./second-thread-node.mjs', import.meta.url), { workerData: start });
    secondThread.on('message', onReady);
    secondThread.on('error', () => undefined);
    secondThread.unref();
  },
  decode: decoder(() => readFile(require.resolve('draco3dgltf/draco_decoder_gltf.wasm'))),
});
parentPort?.on('message', (message: ToWorker) => handler.receive(message));
