/** Exports of the engine in a browser; index-node.ts has the same names for Node. */
export { createEngine } from './browser.ts';
export * from './everywhere.ts';
