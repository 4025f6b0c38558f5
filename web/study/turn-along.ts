/** Rotation of a shape between its two ends: the sum of the rotations between neighbouring patches along a path. */
import type { PatchCurve } from '../engine/api/types.ts';
import { rotationVector } from './rotation-vectors.ts';
import type { Quaternion, Vector } from './rotation-vectors.ts';

export interface TurnAlong {
  /** Number of patches on the path, including both ends. */
  patches: number;
  /** Total rotation in degrees, per time. */
  total: number[];
  /** Largest rotation between two neighbours on the path at any time, in degrees. */
  largest: number;
}

type Turns = ReadonlyMap<number, Vector[]>;

const DEGREES = 180 / Math.PI;

/**
 * `curveOf` returns a patch's curve at `count` times. The ends are the patches farthest apart. The sum is meaningful if
 * all rotations have nearly the same axis, as in a twisted bar. null without neighbours.
 */
export async function turnAlong(
  patches: number,
  count: number,
  curveOf: (patch: number) => Promise<PatchCurve>,
): Promise<TurnAlong | null> {
  const curves = await Promise.all(Array.from({ length: patches }, (_, patch) => curveOf(patch)));
  const turns = curves.map((curve) => turnsOf(curve, count));
  const start = wayToFurthest(turns, 0).at(-1) ?? 0;
  const way = wayToFurthest(turns, start);
  if (way.length < 2) return null;
  const steps = way.slice(1).map((patch, i) => turns[way[i]!]!.get(patch)!);
  const times = Array.from({ length: count }, (_, time) => time);
  const sumAt = (time: number, axis: number): number => steps.reduce((sum, step) => sum + step[time]![axis]!, 0);
  return {
    patches: way.length,
    total: times.map((time) => DEGREES * Math.hypot(sumAt(time, 0), sumAt(time, 1), sumAt(time, 2))),
    largest: DEGREES * Math.max(...steps.flat().map((vector) => Math.hypot(...vector))),
  };
}

/** The rotation vectors of each neighbour over time. */
function turnsOf({ neighbours, numbers }: PatchCurve, count: number): Turns {
  const width = 1 + 4 * neighbours.length;
  const turnAt = (time: number, place: number): Vector => {
    const [w, x, y, z] = numbers.slice(time * width + 1 + 4 * place) as unknown as Quaternion;
    return rotationVector([1, 0, 0, 0], [w, x, y, z]);
  };
  const times = Array.from({ length: count }, (_, time) => time);
  return new Map(neighbours.map((patch, place) => [patch, times.map((time) => turnAt(time, place))]));
}

/** A shortest path from one patch to one of the farthest patches. */
function wayToFurthest(turns: readonly Turns[], from: number): number[] {
  const before = new Map<number, number>([[from, from]]);
  const reached = [from];
  for (const patch of reached)
    for (const next of turns[patch]?.keys() ?? [])
      if (!before.has(next)) {
        before.set(next, patch);
        reached.push(next);
      }
  const way = [reached.at(-1)!];
  while (way[0] !== from) way.unshift(before.get(way[0]!)!);
  return way;
}
