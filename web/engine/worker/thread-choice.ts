/**
 * Alternates one and two threads and keeps the faster. Compares again from time to time, because the machine's load
 * changes, and immediately if two threads become slower than one.
 */

/** Frames of each kind in a comparison; frames before the first comparison, whose code is not yet optimised. */
const COUNTED = 5,
  WARM_UP = 2;
/** Smallest gain that justifies a second thread. */
const GAIN = 0.95;
/**
 * Frames between two comparisons. Doubles each time that one thread wins, because comparison frames with two threads
 * are slower.
 */
const APART = 200;

export class ThreadChoice {
  private times: Record<1 | 2, number[]> = { 1: [], 2: [] };
  private left = WARM_UP;
  private winner: 1 | 2 = 1;
  /** Milliseconds per frame with one thread in the last comparison. */
  private alone = Infinity;
  private apart = APART;
  /** Frames until the next comparison. */
  private until = 0;
  /** Number of consecutive frames slower than with one thread. */
  private slow = 0;

  /** Result of the last comparison; 1 before the first. */
  get chosen(): 1 | 2 {
    return this.winner;
  }

  /** Threads for the next frame. */
  get threads(): 1 | 2 {
    if (this.until > 0) return this.winner;
    return this.times[2].length < this.times[1].length ? 2 : 1;
  }

  /** Records the time of a frame made with `threads`. */
  took(ms: number): void {
    if (this.until > 0) return this.rest(ms);
    this.times[this.threads].push(ms);
    if (this.times[2].length === this.left + COUNTED) this.compare();
  }

  private rest(ms: number): void {
    this.slow = this.winner === 2 && ms > this.alone ? this.slow + 1 : 0;
    this.until = this.slow === COUNTED ? 0 : this.until - 1;
  }

  private compare(): void {
    const [one, two] = [this.times[1], this.times[2]].map((times) => median(times.slice(this.left))) as [
      number,
      number,
    ];
    this.winner = two < GAIN * one ? 2 : 1;
    this.alone = one;
    this.apart = this.winner === 2 ? APART : 2 * this.apart;
    this.until = this.apart;
    this.times = { 1: [], 2: [] };
    this.left = this.slow = 0;
  }
}

function median(times: number[]): number {
  return times.sort((a, b) => a - b)[Math.floor(times.length / 2)]!;
}
