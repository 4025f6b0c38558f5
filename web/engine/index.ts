/** What users of the engine import in a browser; in Node it is node.ts. */
export type { AheadOptions, CallOptions, Engine, Keys, Sequence } from './api.ts';
export { createEngine, type EngineUrls } from './client.ts';
export { EngineError } from './errors.ts';
export { FramePlayer, type FrameSource, type PlayerOptions } from './frame-player.ts';
export { readPose } from './pose.ts';
export * from './types.ts';
export { keysInWords, keysOf } from './warning-keys.ts';
