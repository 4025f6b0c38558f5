/** Cost of frames in the worker, measured to space the frames ahead. */
import type { FrameSet, RunningMotion } from './frame-set.ts';

const SAMPLES = 3;
/** The first frames of a sequence are slow, and the machine may be busy, so a single one is not representative. */
const ENOUGH = 2;

export class FrameCost {
  private sequences: readonly RunningMotion[] = [];
  private samples: number[] = [];

  note({ sequences, ms }: Pick<FrameSet, 'sequences' | 'ms'>): void {
    this.follow(sequences);
    this.samples.push(ms);
    if (this.samples.length > SAMPLES) this.samples.shift();
  }

  /** Milliseconds, of the last few frames the (lower) median; 0 where too few were measured yet. */
  typical(sequences: readonly RunningMotion[]): number {
    this.follow(sequences);
    const sorted = [...this.samples].sort((a, b) => a - b);
    return sorted.length < ENOUGH ? 0 : sorted[(sorted.length - 1) >> 1]!;
  }

  /** Other shapes and methods have other costs; other motions of the same ones have not. */
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
