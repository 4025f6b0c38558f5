/** Asks for shapes and puts them on the screen: one at a time, always the newest moment, all views together. */
import type { Frame } from '../engine/types.ts';
import type { Lane } from './lanes.ts';

export interface PumpTarget {
  lanes(): readonly Lane[];
  /** Copies the frames to the screen; they are released afterwards. */
  show(t: number, frames: readonly Frame[], lanes: readonly Lane[]): void | Promise<void>;
  /** Resolves when what was shown has been drawn. */
  drawn(): Promise<void>;
  onError(error: unknown): void;
}

interface Waiting {
  resolve(): void;
  ticket: number;
}

export class Pump {
  private wanted = 0;
  private ticket = 0;
  private shown = 0;
  private running: Promise<void> | null = null;
  private waiting: Waiting[] = [];

  constructor(private readonly target: PumpTarget) {}

  get busy(): boolean {
    return this.running !== null;
  }

  /** Resolves when this moment, or a newer one that overtook it, has been drawn. */
  request(t: number): Promise<void> {
    this.wanted = t;
    this.ticket += 1;
    const { ticket } = this;
    const done = new Promise<void>((resolve) => this.waiting.push({ resolve, ticket }));
    this.running ??= this.run();
    return done;
  }

  /** Resolves when what has been asked for so far is drawn: a motion that plays asks for more and more. */
  idle(): Promise<void> {
    if (!this.running) return Promise.resolve();
    return new Promise((resolve) => this.waiting.push({ resolve, ticket: this.ticket }));
  }

  private async run(): Promise<void> {
    // Whoever waits for a frame may ask for the next one at once: that the work has ended must be known by then.
    await Promise.resolve();
    while (this.shown < this.ticket) {
      const { ticket, wanted } = this;
      try {
        // A sequence that was exchanged meanwhile answers no more: the same moment is asked of its successor.
        if (!await this.frame(wanted) && ticket === this.ticket && this.target.lanes().length > 0) continue;
      } catch (error) {
        this.target.onError(error);
      }
      this.shown = ticket;
      this.waiting = this.waiting.filter(({ resolve, ticket: mine }) => {
        if (mine <= ticket) resolve();
        return mine > ticket;
      });
    }
    this.running = null;
  }

  private async frame(t: number): Promise<boolean> {
    const lanes = this.target.lanes();
    const outcomes = await Promise.allSettled(lanes.map((lane) => lane.sequence.evaluate(t)));
    const frames = outcomes.flatMap((outcome) => (outcome.status === 'fulfilled' && outcome.value ? [outcome.value] : []));
    try {
      if (lanes !== this.target.lanes()) return false;
      const failure = outcomes.find((outcome) => outcome.status === 'rejected');
      if (failure) throw failure.reason;
      if (frames.length < lanes.length) return false;
      await this.target.show(t, frames, lanes);
    } finally {
      for (const frame of frames) frame.release();
    }
    await this.target.drawn();
    return true;
  }
}
