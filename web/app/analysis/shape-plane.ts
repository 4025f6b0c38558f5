/** The motions in the principal plane of the keys, with the tangents at the ends. */
import { METHOD, isFitted } from '../../engine/api/methods.ts';
import type { ShapePlane } from '../../engine/api/types.ts';
import { USUAL_MAX_SPEEDS, maxSpeed } from '../../model/speeds.ts';
import type { End, Speeds } from '../../model/speeds.ts';
import type { Towards } from '../../model/state.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { PlaneShapes } from './plane-weights.ts';
import type { RunningMotion } from '../../playback/frame-set.ts';

export interface ShapePlaneInput {
  sequences: readonly RunningMotion[];
  keyTimes: readonly number[];
  range: Range;
  /** Hermite: the shapes that give the end directions; null for other boundaries. */
  towards: Readonly<Record<End, Towards>> | null;
}

/** Bézier handles: a third of the tangent at speed 1. `shape`: position of the tangent pose. */
export interface Tangent {
  handle: [number, number];
  shape: [number, number] | null;
}

export type Tangents = Readonly<Record<End, Tangent>>;

export interface ShapePlanes {
  times: number[];
  range: Range;
  /** One entry per motion in LRI space, all in the first one's plane. */
  planes: { method: RunningMotion['method']; plane: ShapePlane }[];
  tangents: Tangents | null;
}

const POINTS = 97;

/** Whether the motion lies in the plane of its keys, which fitted shapes do not. */
export function inPlane({ method, sequence }: RunningMotion): boolean {
  return METHOD[method].space === 'lri' && !isFitted(sequence.options);
}

export async function computeShapePlanes(input: ShapePlaneInput): Promise<ShapePlanes> {
  const { sequences, keyTimes, range, towards } = input;
  const times = plottedTimes(range, keyTimes, POINTS);
  // Holding moves shapes but not their coordinates, so the curve does not depend on it.
  const inLri = sequences
    .filter(inPlane)
    .filter(({ method, plain }, _, all) => !plain || !all.some((one) => one.method === method && !one.plain));
  const planes = await Promise.all(
    inLri.map(async ({ method, sequence }) => {
      const plane = await sequence.shapePlane(times);
      return { method, plane };
    }),
  );
  const [main] = planes;
  return { times, range, planes, tangents: main && towards ? tangentsOf(main.plane, towards) : null };
}

/**
 * Shapes with known weights: the keys and the motion's shapes. If tangent poses contribute to the motion's shapes,
 * only the keys are used.
 */
export function knownShapes({ keys, curve, weights }: ShapePlane): PlaneShapes {
  const count = keys.length / 2;
  const own = weights.length === (curve.length / 2) * count;
  const units = Array.from({ length: count * count }, (_, i) => Number(i % (count + 1) === 0));
  return { keys, points: [...keys, ...(own ? curve : [])], weights: [...units, ...(own ? weights : [])] };
}

/** The largest offered end speeds, from the distances between tangent poses and their keys in the plane. */
export function maxSpeeds(plane: ShapePlane, towards: ShapePlaneInput['towards']): Speeds {
  if (!towards) return USUAL_MAX_SPEEDS;
  const { start, end } = endsOf(plane, towards);
  const max = ({ key, neighbour, shape }: Ended): number => maxSpeed(apart(key, neighbour), shape && apart(key, shape));
  return { start: max(start), end: max(end) };
}

/** The handle of a cubic with slope m over a time h ends at its second Bézier point: h m / 3 from the first. */
function tangentsOf(plane: ShapePlane, towards: Readonly<Record<End, Towards>>): Tangents {
  const { start, end } = endsOf(plane, towards);
  const tangent = ({ key, neighbour, shape }: Ended): Tangent => {
    const to = shape ?? neighbour;
    return { handle: [(to[0] - key[0]) / 3, (to[1] - key[1]) / 3], shape };
  };
  return { start: tangent(start), end: tangent(end) };
}

type Point = [number, number];

/** Positions of an end's key, of its neighbouring key, and of the tangent pose, if any. */
interface Ended {
  key: Point;
  neighbour: Point;
  shape: Point | null;
}

function endsOf({ keys, tangents }: ShapePlane, towards: Readonly<Record<End, Towards>>): Record<End, Ended> {
  const at = (list: readonly number[], index: number): Point => [list[2 * index]!, list[2 * index + 1]!];
  // A motion under construction has no positions yet.
  const shape = (index: number): Point | null => (2 * index < tangents.length ? at(tangents, index) : null);
  const last = keys.length / 2 - 1;
  const start = towards.start === 'shape' ? shape(0) : null;
  const end = towards.end === 'shape' ? shape(start ? 1 : 0) : null;
  return {
    start: { key: at(keys, 0), neighbour: at(keys, 1), shape: start },
    end: { key: at(keys, last), neighbour: at(keys, last - 1), shape: end },
  };
}

function apart([x, y]: Point, [u, v]: Point): number {
  return Math.hypot(u - x, v - y);
}
