/**
 * The files of the npm package as a browser finds them: beside the script that this becomes part of. Bundlers copy what
 * they see as `new URL('./name', import.meta.url)`; each is looked at when it is needed, as some bundles have no such
 * address.
 */
import { engineError, type EngineError } from '../api/errors.ts';
import type { BrowserFiles, StartedWorker } from '../caller/browser-files.ts';
import { inlinedWorker } from './inlined-worker.ts';
import { PatientWorker } from './patient-worker.ts';

const beside = {
  wasm: () => whereItIs(new URL('./shapespline.wasm', import.meta.url)),
  threads: () => whereItIs(new URL('./shapespline_threads.wasm', import.meta.url)),
  draco: () => whereItIs(new URL('./draco_decoder_gltf.wasm', import.meta.url)),
  worker: () => whereItIs(new URL('./worker.js', import.meta.url)),
  codecs: () => whereItIs(new URL('./codecs.js', import.meta.url)),
};

/** Vite's development server moves the scripts of a package, and leaves its other files where they are (vite#8427). */
function whereItIs(url: URL): URL {
  return new URL(url.href.replace('/node_modules/.vite/deps/', '/node_modules/shapespline/'));
}

/** undefined where the script does not know its own address, as in a bundle for a classic script. */
function known(address: () => URL): string | undefined {
  try {
    return address().href;
  } catch {
    return undefined;
  }
}

export const files: BrowserFiles = {
  wasm: () => required(beside.wasm, 'wasmUrl'),
  threads: async () => beside.threads(),
  forWorker: ({ draco = known(beside.draco), worker }) => ({
    draco,
    // Where the script knows no address, it lies beside the worker's that was named.
    codecs: known(beside.codecs) ?? known(() => new URL('./codecs.js', worker)),
  }),
  startWorker: (name, given) => {
    const ways = given || !inlinedWorker ? waysFrom(given ?? required(beside.worker, 'workerUrl')) : inlinedWays();
    return new PatientWorker(ways.map((address) => () => start(address(), name)));
  },
  notStarted: (given) => notStarted(given?.href ?? known(beside.worker) ?? 'its own text'),
};

const start = (address: string, name: string): StartedWorker => new Worker(address, { type: 'module', name });

/** A worker's script must be of the page's own origin; one of another origin is imported by a small one that is. */
function waysFrom(url: URL): (() => string)[] {
  const importing = (): string => scriptAddress(`import ${JSON.stringify(url.href)};`);
  return url.origin === location.origin ? [() => url.href, importing] : [importing];
}

/** Some sites refuse `blob:`; there the file beside the script may do. */
function inlinedWays(): (() => string)[] {
  return [() => scriptAddress(inlinedWorker ?? ''), () => beside.worker().href];
}

const addresses = new Map<string, string>();

/** The address of a script with this text: one for each text, as the worker's second thread starts from it, too. */
function scriptAddress(text: string): string {
  const made = addresses.get(text) ?? URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  addresses.set(text, made);
  return made;
}

function required(address: () => URL, name: string): URL {
  try {
    return address();
  } catch {
    throw engineError(
      'not-loaded',
      `This script does not know its own address, so that its other files must be named: configure({ ${name} }).`,
    );
  }
}

function notStarted(from: string): EngineError {
  return engineError(
    'not-loaded',
    `The worker did not start from ${from}, neither as it is nor by a blob: address. Put worker.js at an address of ` +
      "the page's own origin and name it, configure({ workerUrl }), or allow blob: in the page's policy (worker-src).",
  );
}
