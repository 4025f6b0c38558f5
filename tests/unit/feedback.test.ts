/** Errors of a page whose files the host has replaced by a new build. */
import { afterEach, expect, it, vi } from 'vitest';
import { createFeedback } from '../../web/app/view/feedback.ts';
import { createViewState } from '../../web/app/view/view-state.ts';
import { EngineError } from '../../web/engine/api/errors.ts';

vi.mock('../../web/ui/messages.ts', () => ({ createToast: () => ({}) }));
afterEach(() => void vi.unstubAllGlobals());

const page = (script: string): string => `<title>shapespline</title><script src="./assets/${script}"></script>`;
const NOT_FOUND = new TypeError('Failed to fetch dynamically imported module: http://localhost/assets/export-1.js');
const NO_WASM = new EngineError('not-loaded', 'worker.js returned status 404. Put the file there.');

async function messageOf(error: Error, answer: Response | null): Promise<string> {
  const src = 'http://localhost/assets/index-1.js';
  vi.stubGlobal('document', { baseURI: 'http://localhost/page/', querySelector: () => ({ src }) });
  const fetched = vi.fn(() => (answer ? Promise.resolve(answer) : Promise.reject(new TypeError())));
  vi.stubGlobal('fetch', fetched);
  const viewState = createViewState(() => undefined);
  createFeedback(viewState).onError(error);
  await vi.waitFor(() => expect(viewState.page.errorMessage).not.toBeNull());
  expect(fetched).toHaveBeenCalledWith('/page/', expect.anything());
  expect(viewState.page.errorMessage!.retry).toBe(true);
  return viewState.page.errorMessage!.message;
}

it.each([NOT_FOUND, NO_WASM])('ask for a reload', async (error) => {
  expect(await messageOf(error, new Response(page('index-2.js')))).toContain('There is a new version of this page.');
});

it.each([
  ['another page of the network', new Response('<title>Log in')],
  ['the same build', new Response(page('index-1.js'))],
  ['an error', new Response(page('index-2.js'), { status: 500 })],
  ['no connection', null],
])('are shown as they are for %s', async (_, answer) => {
  expect(await messageOf(NO_WASM, answer)).toBe(NO_WASM.message);
});
