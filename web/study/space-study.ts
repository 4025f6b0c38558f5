/** Motions of several methods through the same keys, measured in the same way: kept measures, bending and costs. */
import type { CallOptions, Engine, Keys, Sequence } from '../engine/api/api.ts';
import { EngineError, isCancelled } from '../engine/api/errors.ts';
import { partOf } from '../engine/api/progress.ts';
import { OWN_METHOD } from '../engine/api/methods.ts';
import { ghostFor, motionFor } from '../engine/api/method-options.ts';
import { SEQUENCE_DEFAULTS, type Method, type SequenceOptions, type Timings } from '../engine/api/types.ts';
import { conformalDistortion } from './conformal-distortion.ts';
import { edgeLengths, edgesOf } from './edge-lengths.ts';
import { fitWarnings, fittedCount, isOwnAt, unfittedNote } from './fitted-intervals.ts';
import { MotionError } from './motion-error.ts';

/** The animation of the keys: a shape per time. */
export interface ReferenceShapes {
  times: readonly number[];
  shapes: readonly Float32Array[];
}

/** Frames of another motion of the same mesh, at the times of the reference. */
export interface OtherFrames {
  name: string;
  shapes: readonly Float32Array[];
}

export interface SpaceRow {
  /** The method, or the name of other frames. */
  method: string;
  /** Whether the row has the fitted timing. */
  isTimed: boolean;
  /** Number of intervals between keys with fitted shapes. Only these are measured. null for methods without fits. */
  fitted: number | null;
  /** Largest difference over time from the natural spline of the keys' volumes, in percent; NaN for open surfaces. */
  volume: number;
  /** The same for areas. */
  area: number;
  /**
   * How far edge lengths deviate from the natural spline of their lengths in the keys, in percent of the splined length
   * (root mean square over edges and times).
   */
  lengths: number;
  /** Mean over time of the conformal distortion relative to the first key (conformal-distortion). */
  conformal: number;
  /** Mean over time of the bending energy of edge lengths and angles, and its largest value. */
  bending: number;
  peak: number;
  /** Error against the animation, in percent; NaN without one. */
  kg: number;
  /** Largest distance of a vertex from the animation, in percent of the diagonal; NaN without an animation. */
  largest: number;
  /** Median time of a frame in the worker. */
  ms: number;
  /** Milliseconds from the keys until the first frame can be computed. */
  buildMs: number;
  /** Why the method cannot move this shape; then all numbers are NaN. */
  note: string;
  /** About intervals without a fit. */
  warnings: string[];
}

export interface SpaceStudyOptions extends CallOptions {
  methods: readonly Method[];
  reference: ReferenceShapes | null;
  /** A timing for further rows of the methods that support it. */
  timing?: Timings | null;
  /** Rows beside the methods. They need a reference. */
  others?: readonly OtherFrames[];
}

/** Times per range, in the middle of as many intervals. */
const TIMES = 48;

export async function studySpaces(
  engine: Engine,
  keys: Keys,
  options: Partial<SequenceOptions>,
  { methods, reference, timing, others = [], signal, onProgress = () => undefined }: SpaceStudyOptions,
): Promise<SpaceRow[]> {
  const spline = await splineOf(engine, keys);
  const rows: SpaceRow[] = [];
  const motions = methods.flatMap((method) => [
    { method, isTimed: false },
    ...(timing && method === OWN_METHOD ? [{ method, isTimed: true }] : []),
  ]);
  for (const [index, { method, isTimed }] of motions.entries()) {
    const report = partOf(onProgress, index / motions.length, (index + 1) / motions.length);
    const call = { ...(signal && { signal }), onProgress: partOf(report, 0, 0.5) };
    try {
      const start = performance.now();
      const own = motionFor(ghostFor({ ...SEQUENCE_DEFAULTS, ...options }, method), { method });
      if (isTimed) Object.assign(own, timing);
      const sequence = await engine.createSequence(keys, own, call);
      const buildMs = performance.now() - start;
      const numbers = await measured(sequence, keys, spline, reference, signal).finally(() => sequence.dispose());
      const fitted = fittedCount(sequence);
      rows.push({
        method,
        isTimed,
        fitted,
        note: unfittedNote(sequence),
        warnings: fitWarnings(sequence),
        ...numbers,
        buildMs,
      });
    } catch (error) {
      if (!(error instanceof EngineError) || isCancelled(error)) throw error;
      rows.push({ ...NOTHING, method, isTimed, note: error.message });
    }
  }
  for (const { name, shapes } of others) rows.push({ ...NOTHING, method: name, ...errorsOf(keys, reference, shapes) });
  return rows;
}

const NO_NUMBERS = {
  ...{ volume: NaN, area: NaN, lengths: NaN, conformal: NaN, bending: NaN, peak: NaN },
  ...{ kg: NaN, largest: NaN, ms: NaN },
};
const NOTHING = { ...NO_NUMBERS, isTimed: false, fitted: null, note: '', warnings: [], buildMs: NaN };

function errorsOf(keys: Keys, reference: ReferenceShapes | null, shapes: readonly Float32Array[]): Partial<Numbers> {
  const { faces, report } = keys.info;
  const error = new MotionError(report.diagonal);
  let conformal = 0;
  shapes.forEach((shape, index) => {
    error.add(reference!.shapes[index]!, shape);
    conformal += conformalDistortion(faces, keys.positions(0), shape) / shapes.length;
  });
  return { kg: error.percent, largest: error.largest, conformal };
}

/** The natural spline of the keys' own measures, at the times of the study. */
interface Spline {
  times: number[];
  edges: Uint32Array;
  /** One per time; null for open surfaces. */
  volume: number[] | null;
  area: number[];
  /** Lengths of all edges at a time, by its index. */
  lengthsAt(time: number): Float64Array;
}

async function splineOf(engine: Engine, keys: Keys): Promise<Spline> {
  const { times: keyTimes, faces, report } = keys.info;
  const [start, end] = [keyTimes[0]!, keyTimes.at(-1)!];
  const times = Array.from({ length: TIMES }, (_, i) => start + ((i + 0.5) / TIMES) * (end - start));
  const natural = await engine.createSequence(keys);
  const { weights } = await natural.shapePlane(times);
  const { volume, area } = await natural.measures(keyTimes);
  natural.dispose();
  const count = keyTimes.length;
  const blend = (time: number, of: (key: number) => number): number => {
    let sum = 0;
    for (let key = 0; key < count; key += 1) sum += weights[time * count + key]! * of(key);
    return sum;
  };
  const edges = edgesOf(faces);
  const lengths = keyTimes.map((_, key) => edgeLengths(edges, keys.positions(key)));
  return {
    times,
    edges,
    volume: report.boundaryEdges > 0 ? null : times.map((_, time) => blend(time, (key) => volume[key]!)),
    area: times.map((_, time) => blend(time, (key) => area[key]!)),
    lengthsAt: (time) => lengths[0]!.map((_, edge) => blend(time, (key) => lengths[key]![edge]!)),
  };
}

type Numbers = typeof NO_NUMBERS;

async function measured(
  sequence: Sequence,
  keys: Keys,
  { times, edges, lengthsAt, ...spline }: Spline,
  reference: ReferenceShapes | null,
  signal: AbortSignal | undefined,
): Promise<Numbers> {
  const call = signal && { signal };
  const ms: number[] = [];
  let [sum, count, conformal] = [0, 0, 0];
  // Elsewhere, the row would have the numbers of another method.
  const own = times.flatMap((t, index) => (isOwnAt(sequence, t) ? [index] : []));
  if (own.length === 0) return NO_NUMBERS;
  const ownTimes = own.map((index) => times[index]!);
  const splined = (values: readonly number[]): number[] => own.map((index) => values[index]!);
  for (const [place, t] of ownTimes.entries()) {
    const [frame] = await sequence.evaluateMany([t], call);
    const wanted = lengthsAt(own[place]!);
    edgeLengths(edges, frame!.positions).forEach((length, edge) => {
      if (!(wanted[edge]! > 0)) return;
      sum += (length / wanted[edge]! - 1) ** 2;
      count += 1;
    });
    conformal += conformalDistortion(keys.info.faces, keys.positions(0), frame!.positions) / own.length;
    ms.push(frame!.ms);
    frame!.release();
  }
  const { volume, area } = await sequence.measures(ownTimes, call);
  const bending = await sequence.shellBending(ownTimes, call);
  return {
    volume: spline.volume ? largestOff(volume, splined(spline.volume)) : NaN,
    area: largestOff(area, splined(spline.area)),
    lengths: 100 * Math.sqrt(sum / count),
    conformal,
    bending: bending.reduce((total, energy) => total + energy / bending.length, 0),
    peak: Math.max(...bending),
    ...(reference ? await errorsAgainst(sequence, reference, keys.info.report.diagonal, signal) : NO_ERRORS),
    ms: ms.sort((a, b) => a - b)[Math.floor(ms.length / 2)]!,
  };
}

function largestOff(values: readonly number[], wanted: readonly number[]): number {
  return 100 * Math.max(...values.map((value, i) => Math.abs(value / wanted[i]! - 1)));
}

const NO_ERRORS = { kg: NaN, largest: NaN };

async function errorsAgainst(
  sequence: Sequence,
  { times, shapes }: ReferenceShapes,
  diagonal: number,
  signal?: AbortSignal,
): Promise<typeof NO_ERRORS> {
  const error = new MotionError(diagonal);
  const own = times.map((t) => isOwnAt(sequence, t));
  if (!own.includes(true)) return NO_ERRORS;
  for (const [index, t] of times.entries()) {
    if (!own[index]) continue;
    const [frame] = await sequence.evaluateMany([t], signal && { signal });
    error.add(shapes[index]!, frame!.positions);
    frame!.release();
  }
  return { kg: error.percent, largest: error.largest };
}
