/**
 * Locates the npm package's files in a browser: next to the script that includes this code. Bundlers copy files
 * referenced as `new URL('./name', import.meta.url)`. Each URL is created on use, because some bundles have no base
 * URL.
 */
import { engineError, type EngineError } from '../api/errors.ts';
import type { BrowserFiles, StartedWorker } from '../caller/browser-files.ts';
import { inlinedWorker } from './inlined-worker.ts';
import { FallbackWorker } from '../caller/fallback-worker.ts';
import { trustedAddress } from './trusted-address.ts';

const beside = {
  wasm: () => whereItIs(new URL('./shapespline.wasm', import.meta.url)),
  files: () => whereItIs(new URL('./shapespline_files.wasm', import.meta.url)),
  shells: () => whereItIs(new URL('./shapespline_shells.wasm', import.meta.url)),
  threads: () => whereItIs(new URL('./shapespline_threads.wasm', import.meta.url)),
  draco: () => whereItIs(new URL('./draco_decoder_gltf.wasm', import.meta.url)),
  worker: () => whereItIs(new URL('./worker.js', import.meta.url)),
  codecs: () => whereItIs(new URL('./codecs.js', import.meta.url)),
};

/** Vite's development server moves a package's scripts but not its other files (vite#8427). */
function whereItIs(url: URL): URL {
  return new URL(url.href.replace('/node_modules/.vite/deps/', '/node_modules/shapespline/'));
}

/** undefined if the script does not know its own URL, as in a bundle for a classic script. */
function known(address: () => URL): string | undefined {
  try {
    return address().href;
  } catch {
    return undefined;
  }
}

export const files: BrowserFiles = {
  wasm: () => required(beside.wasm, 'wasmUrl'),
  filesWasm: () => required(beside.files, 'filesUrl'),
  shellsWasm: () => required(beside.shells, 'shellsUrl'),
  threads: beside.threads,
  forWorker: ({ draco = known(beside.draco), worker }) => ({
    draco,
    // Without its own URL, the script uses the folder of the configured worker.
    codecs: known(beside.codecs) ?? known(() => new URL('./codecs.js', worker)),
  }),
  startWorker(name, loaded, given) {
    listenToPolicy();
    const methods =
      given || !inlinedWorker ? methodsFrom(given ?? required(beside.worker, 'workerUrl')) : inlinedMethods();
    return new FallbackWorker(
      methods.map((address) => () => start(address(), name)),
      loaded,
    );
  },
  notStarted: (silent, given) => notStarted(silent, given?.href ?? known(beside.worker) ?? 'its own text'),
};

const start = (address: string, name: string): StartedWorker =>
  new Worker(trustedAddress(address), { type: 'module', name });

/**
 * A worker's script must have the page's origin, so a small local script imports a foreign one. A frame sandboxed
 * without allow-same-origin has an opaque origin: its `blob:` URLs count as foreign, but `data:` works.
 */
function methodsFrom(url: URL): (() => string)[] {
  const text = `import ${JSON.stringify(url.href)};`;
  const importing = [() => blobAddress(text), () => dataAddress(text)];
  return url.origin === globalThis.origin ? [() => url.href, ...importing] : importing;
}

/** Some sites refuse `blob:`, but may accept the file next to the script. */
function inlinedMethods(): (() => string)[] {
  const text = inlinedWorker ?? '';
  return [() => blobAddress(text), () => beside.worker().href, () => dataAddress(text)];
}

const addresses = new Map<string, string>();

/** A blob: URL for this text, cached because the worker's second thread uses the same one. */
function blobAddress(text: string): string {
  const made = addresses.get(text) ?? URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  addresses.set(text, made);
  return made;
}

const dataAddress = (text: string): string => `data:text/javascript,${encodeURIComponent(text)}`;

function required(address: () => URL, name: string): URL {
  try {
    return address();
  } catch {
    throw engineError(
      'not-loaded',
      `This script does not know its own URL, so the URLs of its other files must be set: configure({ ${name} }).`,
    );
  }
}

/** Directives of the page's policy that have blocked a worker. */
const refusals = new Set<string>();

const note = ({ effectiveDirective, sample }: SecurityPolicyViolationEvent): void => {
  if (effectiveDirective === 'worker-src' || /^(Worker|shapespline)\b/.test(sample)) refusals.add(effectiveDirective);
};

function listenToPolicy(): void {
  globalThis.document?.addEventListener('securitypolicyviolation', note);
}

function notStarted(silent: boolean, from: string): EngineError {
  if (silent)
    return engineError(
      'not-loaded',
      `The worker from ${from} does not respond. Put the worker.js of this version there, and reload the page.`,
    );
  return engineError('not-loaded', `The worker did not start from ${from}, nor from a blob: or data: URL. ${why()}`);
}

const OWN = "Put worker.js on the page's own origin and set its URL: configure({ workerUrl })";

function why(): string {
  if (refusals.has('trusted-types'))
    return "The page's policy does not list this package's Trusted Types policy: add shapespline to its trusted-types.";
  if (refusals.has('require-trusted-types-for'))
    return "The page's policy requires Trusted Types, but the policy named shapespline could not be created.";
  if (refusals.has('worker-src'))
    return `The page's policy blocks the worker: ${lowered(OWN)}, or allow blob: in its worker-src.`;
  if (globalThis.origin === 'null')
    return 'This frame is sandboxed without allow-same-origin: the host must send Access-Control-Allow-Origin: * with worker.js.';
  return `${OWN}.`;
}

const lowered = (sentence: string): string => sentence.charAt(0).toLowerCase() + sentence.slice(1);
