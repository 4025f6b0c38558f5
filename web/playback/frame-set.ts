/** The frames at one time, one per running sequence, shown together or not at all. */
import type { Motion } from '../engine/api/api.ts';
import type { Frame, Method } from '../engine/api/types.ts';

/** One of the motions shown side by side. */
export interface Variant {
  method: Method;
  /** Number of faces of the ghost mesh; 0 without one. */
  ghost: number;
  /** The method as published, without holding, pins and kept lengths. */
  plain?: true;
}

/** A variant with its motion. */
export interface RunningMotion extends Variant {
  readonly sequence: Motion;
}

export interface FrameSet {
  t: number;
  /** Weights of a blend of the keys that is shown instead of the motions' shapes at t. */
  blend: readonly number[] | null;
  frames: readonly Frame[];
  sequences: readonly RunningMotion[];
  /** Milliseconds of the slowest frame. */
  ms: number;
  release(): void;
}

/** Collects the frames; null if a newer request replaced one. Throws a sequence's error after all have answered. */
export async function gather(
  sequences: readonly RunningMotion[],
  t: number,
  blend: FrameSet['blend'],
  ask: (sequence: Motion) => Promise<Frame | null>,
): Promise<FrameSet | null> {
  const outcomes = await Promise.allSettled(sequences.map(({ sequence }) => ask(sequence)));
  const frames = outcomes.flatMap((outcome) =>
    outcome.status === 'fulfilled' && outcome.value ? [outcome.value] : [],
  );
  const ms = frames.reduce((most, frame) => Math.max(most, frame.ms), 0);
  const release = (): void => frames.forEach((frame) => frame.release());
  const set: FrameSet = { t, blend, frames, sequences, ms, release };
  if (frames.length === sequences.length) return set;
  set.release();
  const failure = outcomes.find((outcome) => outcome.status === 'rejected');
  if (failure) throw failure.reason;
  return null;
}
