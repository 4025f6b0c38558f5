/** What users of the engine import in a browser; in Node it is index-node.ts, with the same names. */
export { createEngine } from './browser.ts';
export * from './everywhere.ts';
