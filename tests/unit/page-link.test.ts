import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { createPageLink } from '../../web/app/sources/page-link.ts';
import { createStore } from '../../web/app/session/store.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

/** The URL: a fragment set by the user takes effect immediately, and its event comes later. */
const location = { hash: '', pathname: '/', search: '', href: 'http://a.test/' };
let hashChange: (event: { newURL: string }) => void;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('location', location);
  vi.stubGlobal('history', {
    replaceState: (_: unknown, __: unknown, url: string) => (location.hash = new URL(url, location.href).hash),
  });
  vi.stubGlobal('window', {
    setTimeout: (work: () => void, ms: number) => setTimeout(work, ms),
    clearTimeout: (timer: number) => clearTimeout(timer),
    addEventListener: (_: string, listener: typeof hashChange) => (hashChange = listener),
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it('a URL with a pending change event is not overwritten', () => {
  location.hash = '#tour=1';
  const onGuide = vi.fn();
  const parts = { store: createStore(EMPTY_STATE), initial: () => null, say: vi.fn(), onLink: vi.fn() };
  const link = createPageLink(parts);
  link.listen(onGuide);
  link.pin('tour=2');
  vi.runAllTimers();
  expect(location.hash).toBe('#tour=2');
  link.pin('tour=3'); // the URL is written shortly after
  location.hash = '#tour=4'; // the user navigates meanwhile
  vi.runAllTimers();
  expect(location.hash).toBe('#tour=4');
  hashChange({ newURL: 'http://a.test/#tour=4' });
  expect(onGuide).toHaveBeenCalledWith('tour=4');
  link.pin('tour=5');
  vi.runAllTimers();
  expect(location.hash).toBe('#tour=5');
  // Copied links and QR codes name the page of the guide as well.
  expect(link.address()).toBe('http://a.test/#tour=5');
});
