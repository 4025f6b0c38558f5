/** What users of the engine import in Node. */
export { createEngine } from './node.ts';
export * from './everywhere.ts';
