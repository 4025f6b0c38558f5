/** The shapes of one moment, one for each lane: shown together or not at all. */
import type { Sequence } from '../../engine/api/api.ts';
import type { Frame } from '../../engine/api/types.ts';
import type { Lane } from '../session/sequence-set.ts';

export interface Shapes {
  t: number;
  frames: readonly Frame[];
  lanes: readonly Lane[];
  /** Not exact: the cheap shapes of Sequence.preview. */
  about: boolean;
  /** Milliseconds of the slowest. */
  ms: number;
  release(): void;
}

/** Null where a sequence was overtaken by another request; throws what a sequence throws, when all have answered. */
export async function gather(
  lanes: readonly Lane[], t: number, about: boolean, ask: (sequence: Sequence) => Promise<Frame | null>,
): Promise<Shapes | null> {
  const outcomes = await Promise.allSettled(lanes.map(({ sequence }) => ask(sequence)));
  const frames = outcomes.flatMap((outcome) => (outcome.status === 'fulfilled' && outcome.value ? [outcome.value] : []));
  const ms = frames.reduce((most, frame) => Math.max(most, frame.ms), 0);
  const shapes: Shapes = { t, frames, lanes, about, ms, release: () => frames.forEach((frame) => frame.release()) };
  if (frames.length === lanes.length) return shapes;
  shapes.release();
  const failure = outcomes.find((outcome) => outcome.status === 'rejected');
  if (failure) throw failure.reason;
  return null;
}
