/**
 * Fits the timing of each interval (options `earlier` and `swing`) to the animation from which the keys were taken: one
 * step of least squares over frames between the keys, with derivatives by differences of shapes.
 */
import type { CallOptions, MotionChange, Shape } from '../engine/api/api.ts';
import { KgError } from './kg-error.ts';

/** Frames of an animation on the timeline of the keys. */
export interface TimedFrames {
  readonly times: readonly number[];
  /** The positions of a frame, 3 x vertices. */
  frame(index: number): Float32Array;
}

export interface TimingFit {
  /** One number per key; empty if no timing lowers the error. */
  earlier: number[];
  swing: number[];
  /**
   * KG errors in percent without and with timing, on this number of frames that a fit to the other frames has not seen;
   * null if every interval has at most one frame.
   */
  unseen: { frames: number; before: number; after: number } | null;
}

type Name = 'earlier' | 'swing';
type Numbers = Record<Name, number[]>;

/** A number to fit: of the interval after this key. */
interface Unknown {
  name: Name;
  key: number;
}

/** Largest sizes of the numbers. At most .35, the speed along the curve stays above a tenth. */
const BOUNDS: Record<Name, number> = { earlier: 0.35, swing: 1.5 };
const MAX_FRAMES = 4;
const MAX_VERTICES = 2000;
const RIDGE = 0.02;
/** Step of the differences. Shapes in single precision are too coarse for a much smaller one. */
const STEP = 0.01;
const DIGITS = 1000;
const AT_ONCE = 16;

/** A motion to fit: a shape, and options without timing. */
interface Fitted {
  shape: Shape;
  options: MotionChange;
  animation: TimedFrames;
}

/** Returns null if the animation has no frame between the keys. `keys`: their times. */
export async function fitTiming(
  fitted: Fitted,
  keys: readonly number[],
  { signal, onProgress }: CallOptions = {},
): Promise<TimingFit | null> {
  const between = framesBetween(keys, fitted.animation.times);
  if (between.flat().length === 0) return null;
  const halves = [0, 1].map((half) => between.map((frames) => frames.filter((_, i) => i % 2 === half)));
  const unseen = halves[1]!.flat();
  const progress =
    (from: number, to: number) =>
    (fraction: number): void => {
      signal?.throwIfAborted();
      onProgress?.({ stage: 'fitting the timing', fraction: from + (to - from) * fraction });
    };
  if (unseen.length === 0) return { ...(await fitTo(fitted, between, progress(0, 1))), unseen: null };
  const half = await fitTo(fitted, halves[0]!, progress(0, 0.45));
  const [before, after] = [await errorOf(fitted, unseen, {}), await errorOf(fitted, unseen, half)];
  const tried = { frames: unseen.length, before, after };
  if (after >= before) return { earlier: [], swing: [], unseen: tried };
  return { ...(await fitTo(fitted, between, progress(0.5, 1))), unseen: tried };
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

async function fitTo(fitted: Fitted, between: number[][], done: (fraction: number) => void): Promise<Numbers> {
  const frames = between.map(spread);
  const plain = await shapesAt(fitted, frames.flat(), {});
  const missing = new Map<number, Float32Array>();
  for (const [frame, shape] of plain) missing.set(frame, minus(thinned(fitted.animation.frame(frame)), shape));
  const unknowns = frames.flatMap((_, key) => (['earlier', 'swing'] as const).map((name): Unknown => ({ name, key })));
  const columns: Map<number, Float32Array>[] = [];
  for (const { name, key } of unknowns) {
    const near = frames.slice(Math.max(key - 1, 0), key + 2).flat();
    const unit = (value: number): Partial<Numbers> => ({
      [name]: Array.from({ length: between.length + 1 }, (_, i) => (i === key ? value : 0)),
    });
    const after = await shapesAt(fitted, near, unit(STEP));
    const before = await shapesAt(fitted, near, unit(-STEP));
    columns.push(new Map(near.map((frame) => [frame, minus(after.get(frame)!, before.get(frame)!, 2 * STEP)])));
    done(columns.length / unknowns.length);
  }
  const normal = columns.map((one) => columns.map((other) => product(one, other)));
  const mean = normal.reduce((sum, row, i) => sum + row[i]!, 0) / normal.length;
  normal.forEach((row, i) => (row[i]! += 2 * RIDGE * mean));
  const found = boundedMinimum(
    normal,
    columns.map((column) => product(column, missing)),
    unknowns.map(({ name }) => BOUNDS[name]),
  );
  const listOf = (wanted: Name): number[] => {
    const values = found.filter((_, i) => unknowns[i]!.name === wanted);
    return [...values, 0].map((value) => Math.round(DIGITS * value) / DIGITS + 0);
  };
  return { earlier: listOf('earlier'), swing: listOf('swing') };
}

/** Calls `use` with each frame's positions in the motion with this timing. */
async function eachShape(
  { shape, options, animation: { times } }: Fitted,
  frames: number[],
  numbers: Partial<Numbers>,
  use: (frame: number, positions: Float32Array) => void,
): Promise<void> {
  const motion = await shape.motion({ ...options, ...numbers });
  try {
    for (let start = 0; start < frames.length; start += AT_ONCE) {
      const some = frames.slice(start, start + AT_ONCE);
      const shown = await motion.evaluateMany(some.map((frame) => times[frame]!));
      shown.forEach((one, i) => {
        use(some[i]!, one.positions);
        one.release();
      });
    }
  } finally {
    motion.dispose();
  }
}

/** Some of the vertices of the motion's shapes at these frames. */
async function shapesAt(
  fitted: Fitted,
  frames: number[],
  numbers: Partial<Numbers>,
): Promise<Map<number, Float32Array>> {
  const shapes = new Map<number, Float32Array>();
  await eachShape(fitted, frames, numbers, (frame, positions) => shapes.set(frame, thinned(positions)));
  return shapes;
}

function thinned(positions: Float32Array): Float32Array {
  const vertices = positions.length / 3;
  const every = Math.max(Math.ceil(vertices / MAX_VERTICES), 1);
  return positions.filter((_, i) => Math.floor(i / 3) % every === 0);
}

const minus = (a: Float32Array, b: Float32Array, over = 1): Float32Array => a.map((value, i) => (value - b[i]!) / over);

/** Inner product over the frames of both. */
function product(a: ReadonlyMap<number, Float32Array>, b: ReadonlyMap<number, Float32Array>): number {
  let sum = 0;
  for (const [frame, values] of a) {
    const others = b.get(frame);
    if (others) for (let i = 0; i < values.length; i += 1) sum += values[i]! * others[i]!;
  }
  return sum;
}

/** Minimises x N x / 2 - g x with |x| within bounds, one unknown after the other. N: symmetric, positive definite. */
function boundedMinimum(normal: number[][], rhs: number[], bounds: number[]): number[] {
  const x = rhs.map(() => 0);
  for (let round = 0, change = 1; round < 2000 && change > 1e-7; round += 1) {
    change = 0;
    normal.forEach((row, i) => {
      const rest = row.reduce((sum, value, j) => (j === i ? sum : sum - value * x[j]!), rhs[i]!);
      const next = Math.min(Math.max(rest / row[i]!, -bounds[i]!), bounds[i]!);
      change = Math.max(change, Math.abs(next - x[i]!));
      x[i] = next;
    });
  }
  return x;
}

async function errorOf(fitted: Fitted, frames: number[], numbers: Partial<Numbers>): Promise<number> {
  const error = new KgError();
  await eachShape(fitted, frames, numbers, (frame, positions) => error.add(fitted.animation.frame(frame), positions));
  return error.percent;
}
