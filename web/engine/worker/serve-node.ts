/** Serves requests in a Node worker thread. */
import { readFile } from 'node:fs/promises';
import { parentPort, Worker } from 'node:worker_threads';
import createWasm from '../../../build/wasm/shapespline.mjs';
import type { ToWorker, WorkerFiles } from '../wire/protocol.ts';
import type { Codecs } from './codecs.ts';
import { decoder } from './decompress.ts';
import { RequestHandler } from './request-handler.ts';

/** `codecsOf` may call `files` when a library is first needed. */
export function serveInNode(codecsOf: (files: () => WorkerFiles) => Codecs): void {
  let files: WorkerFiles = {};
  const codecs = codecsOf(() => files);
  const handler = new RequestHandler({
    post: (message, transfer) => parentPort?.postMessage(message, transfer),
    create: createWasm,
    createThreaded: async () => (await import('../../../build/wasm/shapespline_threads.mjs')).default,
    createFiles: async () => (await import('../../../build/wasm/shapespline_files.mjs')).default,
    startShells: async (module) => (await import('./start-shells.ts')).startShells(module),
    startSecondThread: (start, onReady) => {
      const secondThread = new Worker(new URL('./second-thread-node.mjs', import.meta.url), { workerData: start });
      secondThread.on('message', onReady);
      secondThread.on('error', () => undefined);
      secondThread.unref();
    },
    decode: decoder(codecs, () => readFile(new URL(files.draco ?? ''))),
    codecs,
  });
  parentPort?.on('message', (message: ToWorker) => {
    if (message.type === 'start') files = message.files;
    handler.receive(message);
  });
}
