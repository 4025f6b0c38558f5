/**
 * Tells the browser in the page's head of what its script will ask for: the wasm, the list of samples and what makes
 * the first one come beside it.
 */
import type { Plugin } from 'vite';

export function preload(): Plugin {
  return {
    name: 'shapespline-preload',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_, { bundle, path }) {
        const wasm = Object.keys(bundle ?? {}).find((name) => /(^|\/)shapespline-[^/]*\.wasm$/.test(name));
        if (path !== '/index.html' || !wasm) return [];
        const link = (href: string, type: string) => ({
          tag: 'link',
          attrs: { rel: 'preload', as: 'fetch', crossorigin: true, href: `./${href}`, type },
          injectTo: 'head' as const,
        });
        const make = Object.keys(bundle ?? {}).find((name) => /(^|\/)make-[^/]*\.js$/.test(name));
        return [
          link(wasm, 'application/wasm'),
          link('samples/samples.json', 'application/json'),
          ...(make ? [{ tag: 'link', attrs: { rel: 'modulepreload', crossorigin: true, href: `./${make}` } }] : []),
        ];
      },
    },
  };
}
