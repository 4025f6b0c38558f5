/** The error if the WebAssembly is missing at its URL. */
import { expect, it } from 'vitest';
import { compileFrom } from '../../../web/engine/caller/wasm-file.ts';

const url = new URL('https://example.org/app/shapespline.wasm');
const EMPTY_MODULE = new Uint8Array([0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);

const answer =
  (body: BodyInit | null, type?: string, status = 200) =>
  (): Promise<Response> =>
    Promise.resolve(new Response(body, { status, headers: type === undefined ? {} : { 'Content-Type': type } }));

it.each(['application/wasm', 'application/octet-stream', undefined])('compiles a module served as %s', async (type) => {
  expect(await compileFrom(url, 'wasmUrl', answer(EMPTY_MODULE, type))).toBeInstanceOf(WebAssembly.Module);
});

it.each(['text/html', 'application/wasm'])('reports a web page instead of the module, served as %s', async (type) => {
  const failure = compileFrom(url, 'wasmUrl', answer('<!doctype html><title>Home</title>', type));
  await expect(failure).rejects.toMatchObject({ code: 'not-loaded' });
  await expect(failure).rejects.toThrow(
    `${url.href} returned “<!doctype html><title>Ho…” (${type}) instead of WebAssembly. ` +
      'Put the .wasm file there, or set its URL: configure({ wasmUrl }).',
  );
});

it('reports other errors: no response, an error status, no connection, a damaged file', async () => {
  await expect(compileFrom(url, 'wasmUrl', answer(null, 'text/plain'))).rejects.toThrow('returned nothing instead');
  await expect(compileFrom(url, 'wasmUrl', answer('', undefined, 404))).rejects.toThrow(
    `${url.href} returned 404 instead`,
  );
  const offline = compileFrom(url, 'wasmUrl', () => Promise.reject(new TypeError('Failed to fetch')));
  await expect(offline).rejects.toThrow('Failed to fetch). Check the connection and reload the page.');
  const damaged = compileFrom(url, 'wasmUrl', answer(new Uint8Array([...EMPTY_MODULE, 99]), 'application/wasm'));
  await expect(damaged).rejects.toMatchObject({ code: 'not-loaded' });
});
