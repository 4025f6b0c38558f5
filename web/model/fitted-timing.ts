/** A timing fitted to the animation from which the keys were taken, in the document. */
import type { TimingFit, Timings } from '../engine/api/types.ts';
import { setMotion, setTiming } from './edits.ts';
import type { Doc } from './state.ts';

/** Result of a fit. */
export interface TimingResult {
  /** What it belongs to (`fitKey`). */
  key: string;
  unseen: TimingFit['unseen'];
}

export function withTimings(doc: Doc, { earlier, swing, regions }: Timings): Doc {
  const timed = doc.keys.reduce(
    (next, _, key) => setTiming(next, key, { earlier: earlier[key] ?? 0, swing: swing[key] ?? 0 }),
    doc,
  );
  return setMotion(timed, { regions });
}

export function isTimed({ keys, motion }: Doc): boolean {
  return motion.regions.length > 0 || keys.some(({ shaping }) => shaping.earlier !== 0 || shaping.swing !== 0);
}

/** The parts of the document that a fit depends on, as text. Scaling all times changes nothing. */
export function fitKey({ keys, motion, encoding }: Doc): string {
  const [start, end] = [keys[0]!.time, keys.at(-1)!.time];
  const { method, boundary, startSpeed, endSpeed, keepLengths } = motion;
  return JSON.stringify([
    keys.map(({ pose, time, shaping: { tension, bias, turns } }) => [
      pose,
      Number(((time - start) / (end - start)).toPrecision(9)),
      tension,
      bias,
      turns,
    ]),
    { method, boundary, startSpeed, endSpeed, keepLengths },
    encoding.stretch,
    encoding.ghostFaces,
  ]);
}
