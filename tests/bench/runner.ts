/** Runs the engine for measurements, in Node or in a page. Meshes are files; `mesh` is a path. */
import type { RunNative } from './native-round.ts';
import type { KeysRun } from './key-counts.ts';
import type { Run } from './measure.ts';
import type { Resolutions } from './resolutions.ts';
import type { Motion, MotionRun } from './whole-sequences.ts';

export interface Runner {
  /** Program and version. */
  name: string;
  /** The double-precision references are next to the mesh. */
  measure(mesh: string, runNative: RunNative): Promise<Run>;
  motion(mesh: string, motion: Motion): Promise<MotionRun>;
  resolutions(coarse: string, fine: string): Promise<Resolutions>;
  /** `many` has `count` keys. */
  keys(few: string, many: string, count: number): Promise<KeysRun>;
  close(): Promise<void>;
}

/** Suffix of the mesh's path for references, followed by the number of the time in the sweep. */
export const REFERENCE = '.reference';
