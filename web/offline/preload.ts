/**
 * Adds preload links to the page's head for files requested by its first script: the app, the wasm, the list of
 * samples, and the code that makes the first sample.
 */
import type { Plugin } from 'vite';

/** The used part of a bundle. */
type Bundle = Record<string, { type: string; imports?: readonly string[] }>;

export function preload(): Plugin {
  return {
    name: 'shapespline-preload',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(html, { bundle = {}, path }) {
        const named = (pattern: RegExp): string[] => Object.keys(bundle).filter((name) => pattern.test(name));
        const [wasm] = named(/(^|\/)shapespline-[^/]*\.wasm$/);
        if (path !== '/index.html' || !wasm) return [];
        const link = (attrs: Record<string, string>) => ({
          tag: 'link',
          attrs: { crossorigin: true, ...attrs },
          injectTo: 'head' as const,
        });
        const scripts = withImports(bundle as Bundle, named(/(^|\/)(app|make)-[^/]*\.js$/));
        return [
          link({ rel: 'preload', as: 'fetch', href: `./${wasm}`, type: 'application/wasm' }),
          ...scripts
            .filter((name) => !html.includes(name))
            .map((name) => link({ rel: 'modulepreload', href: `./${name}` })),
          link({ rel: 'preload', as: 'fetch', href: './samples/samples.json', type: 'application/json' }),
        ];
      },
    },
  };
}

/** Chunks with their static imports. */
function withImports(bundle: Bundle, names: readonly string[]): string[] {
  const found = new Set(names);
  for (const name of found) for (const imported of bundle[name]?.imports ?? []) found.add(imported);
  return [...found];
}
