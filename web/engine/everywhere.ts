/** Exports of the engine common to browser and Node. */
export type { AheadOptions, CallOptions, Engine, Keys, Motion, MotionChange, Sequence, Shape } from './api/api.ts';
export { configure, type EngineUrls, type FileUrls } from './api/configure.ts';
export { EngineError, isCancelled } from './api/errors.ts';
export { FramePlayer, type FrameSource, type PlayerOptions } from './api/frame-player.ts';
export { type Pose, readPose, readPoses } from './api/read-poses.ts';
export * from './api/types.ts';
export { keysOf } from './api/warning-keys.ts';
