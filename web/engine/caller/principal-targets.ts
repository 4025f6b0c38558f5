/**
 * The keys as morph targets, with a few corrections. Between two keys, one fades out while the other fades in. Such a
 * blend alone would lose bending, which the corrections restore; they are zero at every key. All weights change with
 * time.
 */
import type { FrameBuffers } from '../wire/protocol.ts';

export interface PrincipalTargets {
  /** The first key, the other keys, then the corrections, each added to the first key. */
  shapes: FrameBuffers[];
  /** One row per time: weights of all shapes except the first. */
  weights: Float32Array;
  /** Number of corrections among the shapes. */
  corrections: number;
  /** Largest distance of a vertex at the times. */
  error: number;
}

/** Residuals of frames in their leading components: `WasmFiles.principalOffsets`. */
export interface Offsets {
  count: number;
  /** The components, count x 3 x vertices. */
  offsets: Float32Array;
  /** The weights, frames x count. */
  weights: Float32Array;
  largest: number;
}

/** Weights of all keys except the first at t; `period`: period of a loop, which returns to the first key. */
export function keyWeights(keyTimes: readonly number[], period: number | null, t: number): number[] {
  const weights = new Array<number>(keyTimes.length).fill(0);
  const first = keyTimes[0]!;
  const at = period === null ? t : first + ((((t - first) % period) + period) % period);
  const next = keyTimes.findIndex((key) => key > at);
  if (at <= first) weights[0] = 1;
  else if (next < 0 && period === null) weights[keyTimes.length - 1] = 1;
  else {
    const after = next < 0 ? keyTimes.length - 1 : next - 1;
    const start = keyTimes[after]!;
    const end = next < 0 ? first + period! : keyTimes[next]!;
    const share = (at - start) / (end - start);
    weights[after] = 1 - share;
    if (next >= 0) weights[next] = share;
  }
  return weights.slice(1);
}

/** Residual of `values` after subtracting the keys blended with these weights. */
function beyond(values: Float32Array, keys: readonly Float32Array[], weights: readonly number[]): Float32Array {
  const [base] = keys;
  const rest = values.map((value, i) => value - base![i]!);
  weights.forEach((weight, k) => {
    const key = keys[k + 1]!;
    if (weight !== 0) for (let i = 0; i < rest.length; i += 1) rest[i]! -= weight * (key[i]! - base![i]!);
  });
  return rest;
}

/** Normals of the corrections: the least-squares fit to the target normals, independent for each correction. */
function normalOffsets(rest: readonly Float32Array[], { count, weights }: Offsets): Float32Array[] {
  return Array.from({ length: count }, (_, k) => {
    const offset = new Float32Array(rest[0]!.length);
    let squares = 0;
    rest.forEach((row, i) => {
      const weight = weights[i * count + k]!;
      squares += weight * weight;
      for (let c = 0; c < row.length; c += 1) offset[c]! += weight * row[c]!;
    });
    return offset.map((value) => value / squares);
  });
}

const plus = (a: Float32Array, b: Float32Array): Float32Array => a.map((value, i) => value + b[i]!);

interface TargetsInput {
  keys: readonly FrameBuffers[];
  keyTimes: readonly number[];
  period: number | null;
  frames: readonly FrameBuffers[];
  times: readonly number[];
  reduce(rows: Float32Array[]): Promise<Offsets>;
}

export async function principalTargets({
  keys,
  keyTimes,
  period,
  frames,
  times,
  reduce,
}: TargetsInput): Promise<PrincipalTargets> {
  const hats = times.map((t) => keyWeights(keyTimes, period, t));
  const rest = (part: keyof FrameBuffers): Float32Array[] =>
    frames.map((frame, i) =>
      beyond(
        frame[part],
        keys.map((key) => key[part]),
        hats[i]!,
      ),
    );
  const offsets = await reduce(rest('positions'));
  const { count, largest } = offsets;
  const normals = count > 0 ? normalOffsets(rest('normals'), offsets) : [];
  const size = keys[0]!.positions.length;
  const corrections = Array.from({ length: count }, (_, k) => ({
    positions: plus(keys[0]!.positions, offsets.offsets.subarray(k * size, (k + 1) * size)),
    normals: plus(keys[0]!.normals, normals[k]!),
  }));
  const weights = hats.flatMap((row, i) => [...row, ...offsets.weights.subarray(i * count, (i + 1) * count)]);
  return {
    shapes: [...keys, ...corrections],
    weights: Float32Array.from(weights),
    corrections: count,
    error: largest,
  };
}
