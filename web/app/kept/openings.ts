/** What was open before in this visit, to step back to and forth again like an edit. */
import type { Work } from './work.ts';
import { bytesOf } from './work.ts';

const AT_MOST = 10;
/** Of files and poses together; what was left last stays whatever it takes. */
const AT_MOST_BYTES = 512e6;

/** To something else, back to what was open before it, or forth to what was open after it. */
export type Step = 'on' | 'back' | 'forth';

export class Openings {
  private earlier: Work[] = [];
  private later: Work[] = [];

  /** A step was made away from `work`. */
  left(work: Work, step: Step = 'on'): void {
    if (step === 'back') {
      this.earlier.pop();
      this.later = lasting([...this.later, work]);
      return;
    }
    if (step === 'forth') this.later.pop();
    else this.later = [];
    this.earlier = lasting([...this.earlier, work]);
  }

  get before(): Work | null {
    return this.earlier.at(-1) ?? null;
  }

  get after(): Work | null {
    return this.later.at(-1) ?? null;
  }

  forget(): void {
    this.earlier = [];
    this.later = [];
  }

  /** All of it, what was left last first. */
  get all(): Work[] {
    return [...this.later, ...this.earlier].reverse();
  }
}

/** The end of the list that fits. */
function lasting(works: Work[]): Work[] {
  const kept: Work[] = [];
  let bytes = 0;
  for (const work of works.slice(-AT_MOST).reverse()) {
    bytes += bytesOf(work);
    if (kept.length > 0 && bytes > AT_MOST_BYTES) break;
    kept.unshift(work);
  }
  return kept;
}
