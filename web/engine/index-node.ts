/** Exports of the engine in Node. */
export { createEngine } from './node.ts';
export * from './everywhere.ts';
