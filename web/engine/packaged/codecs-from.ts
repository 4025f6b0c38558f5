/** The libraries of `codecs.js`, imported on first use. */
import type { Codecs } from '../worker/codecs.ts';

/** `address` is called on first use. */
export function codecsFrom(address: () => string | undefined): Codecs {
  let loaded: Promise<Codecs> | null = null;
  const load = async (): Promise<Codecs> => {
    const url = address();
    if (url === undefined) throw new Error('codecs.js was not found');
    return ((await import(/* @vite-ignore */ /* webpackIgnore: true */ url)) as { codecs: Codecs }).codecs;
  };
  const all = (): Promise<Codecs> => (loaded ??= load());
  return {
    core: async () => (await all()).core(),
    extensions: async () => (await all()).extensions(),
    functions: async () => (await all()).functions(),
    draco: async () => (await all()).draco(),
    meshoptDecoder: async () => (await all()).meshoptDecoder(),
    meshoptEncoder: async () => (await all()).meshoptEncoder(),
  };
}
