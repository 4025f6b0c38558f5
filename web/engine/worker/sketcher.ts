/** What moves while a sequence is made: shapes of its sketch at the pace of a clock, as far as they cost little. */
import type { SketchPlan } from '../wire/protocol.ts';

/** So many times as long as the last one took, the work goes on before the next; and milliseconds, at least. */
const [SHARE, LEAST_MS] = [15, 30];

export type OnSketch = (t: number, positions: Float32Array) => void;

/** The moment that is played so many seconds after the first one, between the first key and the last. */
export function sketchTime(
  { time, speed, bounce }: SketchPlan,
  [first, last]: [number, number],
  seconds: number,
): number {
  const length = last - first;
  const way = Math.max(time - first, 0) + seconds * speed;
  const round = way % (bounce ? 2 * length : length);
  return first + Math.min(round, 2 * length - round);
}

export class Sketcher {
  private begun = NaN;
  private next = -Infinity;

  /** `make`: null as long as there is none. `range`: times of the first key and the last. */
  constructor(
    private readonly plan: SketchPlan,
    private readonly range: [number, number],
    private readonly make: (t: number) => Float32Array | null,
    private readonly onSketch: OnSketch,
  ) {}

  /** To be called often: makes the next one if it is time for it. Never throws: what is made does not depend on it. */
  tick(): void {
    const from = performance.now();
    if (from < this.next) return;
    try {
      const t = sketchTime(this.plan, this.range, Number.isNaN(this.begun) ? 0 : (from - this.begun) / 1000);
      const made = this.make(t);
      if (!made) return;
      if (Number.isNaN(this.begun)) this.begun = from;
      this.onSketch(t, made);
      this.next = performance.now() + Math.max(SHARE * (performance.now() - from), LEAST_MS);
    } catch {
      this.next = Infinity;
    }
  }
}
