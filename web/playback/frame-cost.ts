/** What frames cost in the worker, measured once for all who adapt to it: the choice of previews and the look-ahead. */
import type { FrameSet } from './frame-set.ts';

const SAMPLES = 3;
/** The first frames of a sequence are slow, and the machine may be busy with something else: one alone tells little. */
const ENOUGH = 2;

export class FrameCost {
  private exact: number[] = [];
  private previews: number[] = [];
  private prepared = false;

  note({ preview, ms }: Pick<FrameSet, 'preview' | 'ms'>): void {
    const samples = preview ? this.previews : this.exact;
    // The first preview makes what all of them need, and says nothing of what they cost.
    if (!preview || this.prepared) samples.push(ms);
    if (samples.length > SAMPLES) samples.shift();
    this.prepared ||= preview;
  }

  /** Whether what previews need was made. */
  get hasPreviews(): boolean {
    return this.prepared;
  }

  /** Whether enough exact frames were measured to judge them. */
  get knowsExact(): boolean {
    return this.exact.length >= ENOUGH;
  }

  /** Milliseconds, of the last few frames the least; 0 where nothing was measured yet. */
  least(preview: boolean): number {
    const samples = this.of(preview);
    return samples.length > 0 ? Math.min(...samples) : 0;
  }

  /** Milliseconds, of the last few frames the (lower) median; 0 where too few were measured yet. */
  typical(preview: boolean): number {
    const sorted = [...this.of(preview)].sort((a, b) => a - b);
    return sorted.length < ENOUGH ? 0 : sorted[(sorted.length - 1) >> 1]!;
  }

  private of(preview: boolean): readonly number[] {
    return preview ? this.previews : this.exact;
  }
}
