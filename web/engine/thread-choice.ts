/** Whether a sequence's frames are faster with two threads than with one: its first frames are made in turn with one and with two. */

/** Frames of each kind that are left out, as they run in code that is not yet optimised, and those that count. */
const WARM_UP = 2, COUNTED = 5;
/** A second thread that gains less is left to others. */
const GAIN = 0.95;

export class ThreadChoice {
  private readonly times: Record<1 | 2, number[]> = { 1: [], 2: [] };
  private chosen: 1 | 2 | null = null;

  /** For the next frame. */
  get threads(): 1 | 2 {
    return this.chosen ?? (this.times[2].length < this.times[1].length ? 2 : 1);
  }

  /** How long the frame took that was made with `threads`. */
  took(ms: number): void {
    if (this.chosen) return;
    const { times } = this;
    times[this.threads].push(ms);
    if (times[2].length === WARM_UP + COUNTED) this.chosen = median(times[2]) < GAIN * median(times[1]) ? 2 : 1;
  }
}

function median(times: number[]): number {
  return times.slice(WARM_UP).sort((a, b) => a - b)[Math.floor(COUNTED / 2)]!;
}
