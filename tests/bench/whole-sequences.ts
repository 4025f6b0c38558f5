/** Whole motions as in the paper's Table 2: several numbers of shapes, with and without a ghost mesh. */
import type { Engine } from '../../web/engine/api/api.ts';
import { createWithGhost, ghostFrames, stagesOf, type GhostFrames } from './ghost-frames.ts';

export interface Motion {
  faces: number;
  shapes: number;
  /** Share of vertices that the ghost keeps. */
  fraction: number;
}

/** Milliseconds for all shapes, medians of five. */
export interface MotionRun {
  withGhost: GhostFrames;
  buildMs: number;
  /** t_o: all stages of the frames without a ghost. */
  wholeMs: number;
}

export async function runMotion(
  engine: Engine,
  name: string,
  mesh: Uint8Array,
  { shapes, fraction }: Motion,
): Promise<MotionRun> {
  const keys = await engine.importKeyframes([{ name, bytes: mesh }]);
  const start = performance.now();
  const sequence = await engine.createSequence(keys);
  const buildMs = performance.now() - start;
  const wholeMs = await stagesOf(sequence, shapes);
  sequence.dispose();
  const withGhost = await createWithGhost(engine, keys, Math.round(fraction * keys.info.report.faces));
  const run = await ghostFrames(withGhost, shapes);
  withGhost.sequence.dispose();
  keys.dispose();
  return { withGhost: run, buildMs, wholeMs };
}
