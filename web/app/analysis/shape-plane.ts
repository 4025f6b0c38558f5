/** The motions in the principal plane of the keys, with the tangents at the ends. */
import type { ShapePlane } from '../../engine/api/types.ts';
import type { End } from '../../model/speeds.ts';
import { isInLri } from '../../model/state.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { PlaneShapes } from './plane-weights.ts';
import type { RunningSequence } from '../session/sequence-set.ts';

export interface ShapePlaneInput {
  sequences: readonly RunningSequence[];
  keyTimes: readonly number[];
  range: Range;
  /** Hermite: the key that tells the direction at an end, null where none does; null = another boundary. */
  towards: Readonly<Record<End, number | null>> | null;
}

export type Tangents = Readonly<Record<End, [number, number] | null>>;

export interface ShapePlanes {
  times: number[];
  range: Range;
  /** One per motion of LRI space, the first one's plane for all. */
  planes: { method: RunningSequence['method']; plane: ShapePlane }[];
  tangents: Tangents | null;
}

const POINTS = 97;

export async function computeShapePlanes(input: ShapePlaneInput): Promise<ShapePlanes> {
  const { sequences, keyTimes, range, towards } = input;
  const times = plottedTimes(range, keyTimes, POINTS);
  const inLri = sequences.filter(({ method }) => isInLri(method));
  const planes = await Promise.all(
    inLri.map(async ({ method, sequence }) => {
      const plane = await sequence.shapePlane(times);
      return { method, plane };
    }),
  );
  const [main] = planes;
  return { times, range, planes, tangents: main && towards ? tangentsOf(main.plane.keys, towards) : null };
}

/** The shapes whose weights are known: those of the motion, unless tangent shapes have a part in them, and the keys. */
export function knownShapes({ keys, curve, weights }: ShapePlane): PlaneShapes {
  const count = keys.length / 2;
  const own = weights.length === (curve.length / 2) * count;
  const units = Array.from({ length: count * count }, (_, i) => Number(i % (count + 1) === 0));
  return { keys, points: [...keys, ...(own ? curve : [])], weights: [...units, ...(own ? weights : [])] };
}

/** The handle of a cubic with slope m over a time h ends at its second Bézier point: h m / 3 from the first. */
function tangentsOf(keys: readonly number[], towards: Readonly<Record<End, number | null>>): Tangents {
  const along = (key: number, target: number, axis: 0 | 1): number =>
    (keys[2 * target + axis]! - keys[2 * key + axis]!) / 3;
  const from = (key: number, target: number | null): [number, number] | null =>
    target === null ? null : [along(key, target, 0), along(key, target, 1)];
  return { start: from(0, towards.start), end: from(keys.length / 2 - 1, towards.end) };
}
