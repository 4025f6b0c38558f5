import type { Plugin } from 'esbuild';

export const wasmStaysOutside: Plugin;
