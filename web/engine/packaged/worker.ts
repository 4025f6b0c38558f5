/**
 * `worker.js`: the worker or its second thread, depending on the first message. One file without relative URLs, so it
 * works from any location and from a `blob:` URL.
 */
import createWasm from '../../../build/wasm/shapespline.mjs';
import createFiles from '../../../build/wasm/shapespline_files.mjs';
import { startShells } from '../worker/start-shells.ts';
import createThreaded from '../../../build/wasm/shapespline_threads.mjs';
import type { Locked, Ready, ToWorker, WorkerFiles } from '../wire/protocol.ts';
import { acquireLock } from '../wire/worker-lock.ts';
import { decoder } from '../worker/decompress.ts';
import { RequestHandler } from '../worker/request-handler.ts';
import { help, type SecondThreadStart } from '../worker/second-thread.ts';
import { codecsFrom } from './codecs-from.ts';
import { trustedAddress } from './trusted-address.ts';

function serve(): void {
  let files: WorkerFiles = {};
  const codecs = codecsFrom(() => files.codecs);
  const handler = new RequestHandler({
    post: (message, transfer) => self.postMessage(message, { transfer }),
    create: createWasm,
    createThreaded: async () => createThreaded,
    createFiles: async () => createFiles,
    startShells,
    startSecondThread: (start, onReady) => {
      const secondThread = new Worker(trustedAddress(self.location.href), { type: 'module' });
      secondThread.onmessage = ({ data }: MessageEvent<null | Ready>) => {
        if (data === null) onReady();
      };
      secondThread.onerror = (event) => event.preventDefault();
      secondThread.postMessage(start);
    },
    decode: decoder(codecs, async () => fetchDraco(files.draco)),
    codecs,
  });
  self.addEventListener('message', ({ data }: MessageEvent<ToWorker | SecondThreadStart>) => {
    if ('memory' in data) return help(data, () => self.postMessage(null));
    if (data.type === 'start') files = data.files;
    handler.receive(data);
  });
  self.postMessage({ type: 'ready' } satisfies Ready);
  if (self.name) acquireLock(self.name, () => self.postMessage({ type: 'locked' } satisfies Locked));
}

async function fetchDraco(url: string | undefined): Promise<Uint8Array> {
  const response = url === undefined ? null : await fetch(url);
  if (!response?.ok) throw new Error(`the decoder could not be fetched from ${url}: ${response?.status ?? 'unknown'}`);
  return new Uint8Array(await response.arrayBuffer());
}

// Does nothing outside a worker, for example on a server that imports every entry of a package.
if (typeof self !== 'undefined' && 'postMessage' in self) serve();
