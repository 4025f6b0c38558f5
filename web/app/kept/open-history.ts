/** What was open before in this visit, to step back to and forth again like an edit. */
import type { Snapshot } from './snapshot.ts';
import { bytesOf } from './snapshot.ts';

const AT_MOST = 10;
/** Of files and poses together; what was left last stays whatever it takes. */
const AT_MOST_BYTES = 512e6;

/** To something else, back to what was open before it, or forth to what was open after it. */
export type Step = 'on' | 'back' | 'forth';

export class OpenHistory {
  private earlier: Snapshot[] = [];
  private later: Snapshot[] = [];

  /** A step was made away from `snapshot`. */
  left(snapshot: Snapshot, step: Step = 'on'): void {
    if (step === 'back') {
      this.earlier.pop();
      this.later = lasting([...this.later, snapshot]);
      return;
    }
    if (step === 'forth') this.later.pop();
    else this.later = [];
    this.earlier = lasting([...this.earlier, snapshot]);
  }

  get before(): Snapshot | null {
    return this.earlier.at(-1) ?? null;
  }

  get after(): Snapshot | null {
    return this.later.at(-1) ?? null;
  }

  forget(): void {
    this.earlier = [];
    this.later = [];
  }

  /** All of it, what was left last first. */
  get all(): Snapshot[] {
    return [...this.later, ...this.earlier].reverse();
  }
}

/** The end of the list that fits. */
function lasting(snapshots: Snapshot[]): Snapshot[] {
  const kept: Snapshot[] = [];
  let bytes = 0;
  for (const snapshot of snapshots.slice(-AT_MOST).reverse()) {
    bytes += bytesOf(snapshot);
    if (kept.length > 0 && bytes > AT_MOST_BYTES) break;
    kept.unshift(snapshot);
  }
  return kept;
}
