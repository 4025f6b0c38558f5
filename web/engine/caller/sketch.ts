/** What moves while a large sequence is made: the motion of a coarse mesh, at the pace of a clock. */
import type { Sequence, Sketch } from '../api/api.ts';

/** Milliseconds from one shape to the next, at least. */
const PACE_MS = 30;

/** The moment that is played so many seconds after the first one, between the first key and the last. */
export function sketchTime(
  { time, speed, bounce = false }: Omit<Sketch, 'onFrame'>,
  [first, last]: readonly [number, number],
  seconds: number,
): number {
  const length = last - first;
  const way = Math.max(time - first, 0) + seconds * speed;
  const round = way % (bounce ? 2 * length : length);
  return first + Math.min(round, 2 * length - round);
}

/** `sequence`: of the coarse mesh with these faces. Resolves once `signal` says that it is over. */
export async function playSketch(
  sequence: Sequence,
  faces: Uint32Array,
  sketch: Sketch,
  signal: AbortSignal,
): Promise<void> {
  const ends = [sequence.keyTimes[0]!, sequence.keyTimes.at(-1)!] as const;
  const begun = performance.now();
  for (let now = begun; !signal.aborted; now = performance.now()) {
    const frame = await sequence.evaluate(sketchTime(sketch, ends, (now - begun) / 1000));
    if (signal.aborted) return;
    if (frame) sketch.onFrame({ t: frame.t, positions: frame.positions, normals: frame.normals, faces });
    await new Promise((resolve) => setTimeout(resolve, PACE_MS));
  }
}
