/** Cost of frames in the worker, measured to choose the spacing of frames ahead. */
import type { FrameSet, RunningMotion } from './frame-set.ts';

const SAMPLES = 3;
/** Several frames are needed, because a sequence's first frames are slow and the machine may be busy. */
const ENOUGH = 2;

export class FrameCost {
  private sequences: readonly RunningMotion[] = [];
  private samples: number[] = [];

  note({ sequences, ms }: Pick<FrameSet, 'sequences' | 'ms'>): void {
    this.follow(sequences);
    this.samples.push(ms);
    if (this.samples.length > SAMPLES) this.samples.shift();
  }

  /** The (lower) median of the last few frames in milliseconds; 0 if too few were measured. */
  typical(sequences: readonly RunningMotion[]): number {
    this.follow(sequences);
    const sorted = [...this.samples].sort((a, b) => a - b);
    return sorted.length < ENOUGH ? 0 : sorted[(sorted.length - 1) >> 1]!;
  }

  /** Resets the costs for other shapes and methods, but not for other motions of the same ones. */
  private follow(sequences: readonly RunningMotion[]): void {
    const before = this.sequences;
    this.sequences = sequences;
    const same =
      sequences.length === before.length &&
      sequences.every(
        ({ sequence, method }, i) => sequence.shape === before[i]!.sequence.shape && method === before[i]!.method,
      );
    if (!same) this.samples = [];
  }
}
