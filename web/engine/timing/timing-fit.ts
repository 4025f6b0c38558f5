/**
 * Fits the timing of each interval (options `earlier` and `swing`) to the animation from which the keys were taken: for
 * the whole shape or for regions, and for the mean position. One step of least squares over frames between the keys,
 * on a simplified shape.
 */
import type { CallOptions, Engine, Keys, Motion, MotionChange, Shape, TimedFrames } from '../api/api.ts';
import { cancelled } from '../api/errors.ts';
import type { TimingFit, TimingRegion, Timings } from '../api/types.ts';
import { KgError } from './kg-error.ts';
import { mergedPatches } from './merged-patches.ts';
import { NormalEquations } from './normal-equations.ts';
import { smallShape, type SmallShape } from './small-shape.ts';

/** A motion to fit: the shape with its keys, key times, options without timing, and the animation. */
export interface Fitted {
  engine: Engine;
  keys: Keys;
  shape: Shape;
  times: readonly number[];
  options: MotionChange;
  animation: TimedFrames;
}

const NAMES = ['earlier', 'swing'] as const;
/** Largest sizes of the numbers. At most .35, the speed along the curve stays above a tenth. */
const BOUNDS = { earlier: 0.35, swing: 1.5 };
const MAX_FRAMES = 4;
const RIDGE = 0.02;
const DIGITS = 1000;
const AT_ONCE = 16;
const NO_TIMINGS: Timings = { earlier: [], swing: [], regions: [] };

/**
 * Returns null if the animation has no frame between the keys. `regions`: largest number of regions; with 1, the whole
 * shape has one timing.
 */
export async function fitTiming(
  fitted: Fitted,
  regions: number,
  { signal, onProgress }: CallOptions = {},
): Promise<TimingFit | null> {
  const { times } = fitted;
  const between = framesBetween(times, fitted.animation.times);
  if (between.flat().length === 0) return null;
  const report = (fraction: number): void => {
    if (signal?.aborted) throw cancelled();
    onProgress?.({ stage: 'fitting the timing', fraction });
  };
  report(0);
  const plain = await fitted.shape.motion({ ...fitted.options, keyTimes: [...times], ...NO_TIMINGS });
  const regionOf = regions > 1 ? await mergedPatches(plain, fitted.keys, regions) : null;
  plain.dispose();
  report(0.05);
  const small = await smallShape(fitted.engine, fitted.keys, fitted.shape.options, regionOf);
  try {
    const halves = await equationsOf(fitted, small, between.flatMap(spread), (done) => report(0.1 + 0.8 * done));
    const timingsFrom = (equations: NormalEquations): Timings => timingsOf(equations, regionOf, times.length);
    const all = timingsFrom(halves[0].equations.plus(halves[1].equations));
    const seen = new Set(halves[0].frames);
    const unseen = between.flat().filter((frame) => !seen.has(frame));
    if (unseen.length === 0) return { timings: all, unseen: null };
    const half = timingsFrom(halves[0].equations);
    const [before, after] = [await errorOf(fitted, unseen, NO_TIMINGS), await errorOf(fitted, unseen, half)];
    report(1);
    return { timings: after < before ? all : NO_TIMINGS, unseen: { frames: unseen.length, before, after } };
  } finally {
    small.dispose();
  }
}

/** The frames strictly between two neighbouring keys, for each interval. */
function framesBetween(keys: readonly number[], times: readonly number[]): number[][] {
  return keys.slice(1).map((end, interval) => {
    const start = keys[interval]!;
    const near = 1e-6 * (end - start);
    return times.flatMap((t, frame) => (t > start + near && t < end - near ? [frame] : []));
  });
}

const spread = (frames: number[]): number[] => {
  const count = Math.min(frames.length, MAX_FRAMES);
  return Array.from({ length: count }, (_, i) => frames[Math.floor(((i + 0.5) * frames.length) / count)]!);
};

interface Half {
  equations: NormalEquations;
  frames: number[];
}

/**
 * The equations of every second frame, and of the others. Unknowns of an interval: both numbers of each part, the
 * position last.
 */
async function equationsOf(
  { times, options, animation }: Fitted,
  small: SmallShape,
  frames: readonly number[],
  done: (fraction: number) => void,
): Promise<[Half, Half]> {
  const { regionOfPatch } = small;
  const parts = Math.max(...regionOfPatch) + 2;
  const [first, second] = [0, 1].map(() => ({
    equations: new NormalEquations(times.length - 1, 2 * parts),
    frames: [] as number[],
  }));
  const plain = await small.shape.motion({ ...options, keyTimes: [...times], ...NO_TIMINGS });
  try {
    for (const [i, frame] of frames.entries()) {
      const t = animation.times[frame]!;
      const [[shown], { intervals, shapes }] = await Promise.all([
        shapesOf(plain, [t]),
        plain.timingDerivatives(t, regionOfPatch),
      ]);
      const unknowns = intervals.flatMap((interval) =>
        NAMES.flatMap((_, number) =>
          Array.from({ length: parts }, (__, part) => interval * 2 * parts + 2 * part + number),
        ),
      );
      const columns = unknowns.map((_, column) =>
        shapes.subarray(column * shown!.length, (column + 1) * shown!.length),
      );
      const half = (i % 2 === 0 ? first : second)!;
      half.frames.push(frame);
      half.equations.add(unknowns, columns, minus(small.verticesOf(animation.at(frame)), shown!));
      done((i + 1) / frames.length);
    }
  } finally {
    plain.dispose();
  }
  return [first!, second!];
}

/** The options from the solution. Without regions, the one part before the position is the whole. */
function timingsOf(equations: NormalEquations, regionOf: Int32Array | null, keys: number): Timings {
  const { size } = equations;
  const x = equations.solve(
    RIDGE,
    (unknown) => Math.floor((unknown % size) / 2),
    (unknown) => BOUNDS[NAMES[unknown % 2]!],
  );
  const timingOf = (part: number): Pick<TimingRegion, 'earlier' | 'swing'> => {
    const [earlier, swing] = NAMES.map((_, number) =>
      Array.from({ length: keys }, (_, key) =>
        key === keys - 1 ? 0 : Math.round(DIGITS * x[key * size + 2 * part + number]!) / DIGITS + 0,
      ),
    );
    return { earlier: earlier!, swing: swing! };
  };
  const parts = size / 2;
  const position: TimingRegion = { faces: [], ...timingOf(parts - 1), soft: false };
  if (!regionOf) return { ...timingOf(0), regions: [position] };
  const regions = runsOf(regionOf).map((faces, part) => ({ faces, ...timingOf(part), soft: false }));
  return { earlier: [], swing: [], regions: [...regions, position] };
}

/** For each region, its runs of faces. */
export function runsOf(regionOf: Int32Array): number[][] {
  const runs: number[][] = [];
  let before = -1;
  regionOf.forEach((region, face) => {
    if (region >= 0) {
      runs[region] ??= [];
      const own = runs[region];
      if (region === before) own[own.length - 1]! += 1;
      else own.push(face, 1);
    }
    before = region;
  });
  return runs;
}

async function shapesOf(motion: Motion, times: number[]): Promise<Float32Array[]> {
  const frames = await motion.evaluateMany(times);
  return frames.map((frame) => {
    const positions = frame.positions.slice();
    frame.release();
    return positions;
  });
}

const minus = (a: Float32Array, b: Float32Array): Float32Array => a.map((value, i) => value - b[i]!);

async function errorOf(
  { shape, times, options, animation }: Fitted,
  frames: readonly number[],
  timings: Timings,
): Promise<number> {
  const motion = await shape.motion({ ...options, keyTimes: [...times], ...timings });
  const error = new KgError();
  try {
    for (let start = 0; start < frames.length; start += AT_ONCE) {
      const some = frames.slice(start, start + AT_ONCE);
      const shown = await shapesOf(
        motion,
        some.map((frame) => animation.times[frame]!),
      );
      shown.forEach((positions, i) => error.add(animation.at(some[i]!), positions));
    }
  } finally {
    motion.dispose();
  }
  return error.percent;
}
