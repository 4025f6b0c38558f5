/** Content opened earlier in this visit. Undo and redo step through it as through edits. */
import type { Snapshot } from './snapshot.ts';
import { bytesOf } from './snapshot.ts';

const MAX_SNAPSHOTS = 10;
/** Limit for files and poses together; the last content stays at any size. */
const MAX_BYTES = 512e6;

/** To new content ('on'), to the previous content ('back'), or to the next content ('forth'). */
export type Step = 'on' | 'back' | 'forth';

export class OpenHistory {
  private earlier: Snapshot[] = [];
  private later: Snapshot[] = [];

  /** Records a step away from `snapshot`. */
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

  /** All snapshots, most recent first. */
  get all(): Snapshot[] {
    return [...this.later, ...this.earlier].reverse();
  }
}

/** The end of the list that fits into memory. */
function lasting(snapshots: Snapshot[]): Snapshot[] {
  const kept: Snapshot[] = [];
  let bytes = 0;
  for (const snapshot of snapshots.slice(-MAX_SNAPSHOTS).reverse()) {
    bytes += bytesOf(snapshot);
    if (kept.length > 0 && bytes > MAX_BYTES) break;
    kept.unshift(snapshot);
  }
  return kept;
}
