/** Whole motions as in the paper's Table 2: so many shapes, without a ghost mesh and led by one. */
import type { Engine } from '../../web/engine/api.ts';
import { evenTimes, frameMs, ledRun, passes, type LedRun } from './led.ts';

export interface Motion {
  faces: number;
  shapes: number;
  /** Of the vertices that the ghost keeps. */
  fraction: number;
}

/** Milliseconds for all shapes, medians of five. */
export interface MotionRun {
  led: LedRun;
  buildMs: number;
  wholeMs: number;
}

export async function runMotion(engine: Engine, name: string, mesh: Uint8Array, { shapes, fraction }: Motion): Promise<MotionRun> {
  const keys = await engine.importKeyframes([{ name, bytes: mesh }]);
  const start = performance.now();
  const sequence = await engine.createSequence(keys);
  const buildMs = performance.now() - start;
  const wholeMs = await passes(evenTimes(sequence.range, shapes), (t) => frameMs(sequence, t));
  sequence.dispose();
  const led = await ledRun(engine, keys, Math.round(fraction * keys.info.report.faces), shapes);
  keys.dispose();
  return { led, buildMs, wholeMs };
}
