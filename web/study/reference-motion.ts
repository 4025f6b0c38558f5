/** A densely sampled animation, used as the reference for completed motions. */
import type { CallOptions, Engine, Keys } from '../engine/api/api.ts';
import type { AnimationInfo, ImportOptions, InputFile } from '../engine/api/types.ts';

/** Samples per second, if the limit allows. */
const RATE = 30;
const [MIN_TIMES, MAX_TIMES] = [9, 241];
const MAX_BYTES = 192e6;

export interface TimedShapes {
  readonly times: readonly number[];
  /**
   * The shape at t, 3 x vertices in a reused array. Interpolates linearly between samples, and is constant beyond them.
   */
  at(t: number): Float32Array;
}

export interface ReferenceMotion extends TimedShapes {
  /** Keys of the animation, one per sample. */
  readonly keys: Keys;
  dispose(): void;
}

/**
 * `vertices`: number of vertices, which limits the samples. `options`: the files' import options, and the keys that
 * they match.
 */
export async function readReference(
  engine: Engine,
  files: InputFile[],
  animation: number,
  { start, end }: AnimationInfo,
  vertices: number,
  options: ImportOptions,
  call: CallOptions = {},
): Promise<ReferenceMotion> {
  const room = Math.floor(MAX_BYTES / (12 * vertices));
  const count = Math.max(Math.min(Math.ceil((end - start) * RATE) + 1, MAX_TIMES, room), MIN_TIMES);
  const sample = Array.from({ length: count }, (_, i) =>
    i === count - 1 ? end : start + ((end - start) * i) / (count - 1),
  );
  const { up, unit, objects, like, likePose, likeObjects, offset } = options;
  const read = { up, unit, objects, like, likePose, likeObjects, offset };
  const keys = await engine.importKeyframes(files, { ...read, animation, sample }, call);
  return new Samples(keys);
}

class Samples implements ReferenceMotion {
  readonly times: readonly number[];
  private readonly shape: Float32Array;
  /** The samples around the last requested shape. */
  private ends: { index: number; before: Float32Array; after: Float32Array } | null = null;

  constructor(readonly keys: Keys) {
    this.times = keys.info.times;
    this.shape = keys.positions(0);
  }

  at(t: number): Float32Array {
    const { times, shape } = this;
    const next = times.findIndex((time) => time > t);
    const index = next < 0 ? times.length - 2 : Math.max(next - 1, 0);
    if (this.ends?.index !== index)
      this.ends = { index, before: this.keys.positions(index), after: this.keys.positions(index + 1) };
    const { before, after } = this.ends;
    const [from, to] = [times[index]!, times[index + 1]!];
    const share = Math.min(Math.max((t - from) / (to - from), 0), 1);
    for (let i = 0; i < shape.length; i += 1) shape[i] = before[i]! + share * (after[i]! - before[i]!);
    return shape;
  }

  dispose(): void {
    this.keys.dispose();
  }
}
