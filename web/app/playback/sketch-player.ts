/**
 * What moves while large files are opened: approximate shapes instead of what is open, which rests meanwhile. They are
 * drawn so seldom, and no more when the work is nearly done, that the exact one is not there much later for it.
 */
import type { SketchFrame } from '../../engine/api/api.ts';
import type { Opening } from '../session/workspace.ts';

export interface SketchParts {
  /** `shadow`: of the shape on the floor, too. */
  show(opening: Opening, frame: SketchFrame, shadow: boolean): void;
  /** What is open is shown again. */
  end(): void;
  /** Resolves once the graphics card has drawn what is shown. */
  finished(): Promise<void>;
  /** Resolves when what is open asks for no processor any more; until `resume`. */
  rest(): Promise<void>;
  resume(): void;
  /** The share of the work that is done. */
  fraction(): number;
  /** Whether one is on the screen. */
  onChange(shown: boolean): void;
}

/** Milliseconds of a drawing that takes a processor from the work. */
const SLOW_MS = 30;
/** What comes later would be in the way of the exact shape. */
const LATE = 0.85;

export class SketchPlayer {
  /** What approximate shapes are awaited of, or shown. */
  private opening: Opening | null = null;
  private newest: SketchFrame | null = null;
  private running = false;
  private shown: { opening: Opening; t: number } | null = null;
  /** By the last of them; not known before the first. */
  private tookMs = Infinity;
  private rested: Promise<void> = Promise.resolve();

  constructor(private readonly parts: SketchParts) {}

  /** The time on the screen; null where what is open is shown. */
  get time(): number | null {
    return this.shown?.t ?? null;
  }

  /** What is open rests from here on. */
  await(opening: Opening): void {
    this.opening = opening;
    this.tookMs = Infinity;
    this.rested = this.parts.rest();
  }

  take(opening: Opening, frame: SketchFrame): void {
    if (opening !== this.opening) return;
    if (!this.newest && !this.shown) performance.mark('shapespline sketched');
    this.newest = frame;
    if (!this.running) void this.run(opening);
  }

  /** The time that was reached before this was opened, if anything of it was shown. */
  reached(info: Opening['info']): number | null {
    return this.shown?.opening.info === info ? this.shown.t : null;
  }

  /** What was sketched is open now. */
  settle(): void {
    this.leave(() => undefined);
  }

  /** What is open is shown again, be it that nothing else was opened, or that it is asked for. */
  end(): void {
    this.leave(this.parts.end);
  }

  private leave(hide: () => void): void {
    const { opening, shown } = this;
    if (!opening) return;
    this.opening = this.newest = this.shown = null;
    if (shown) hide();
    this.parts.resume();
    if (shown) this.parts.onChange(false);
  }

  private async run(opening: Opening): Promise<void> {
    this.running = true;
    await this.rested;
    while (this.opening === opening && this.newest && this.parts.fraction() < LATE) {
      const tookMs = await this.draw(opening, this.newest, this.tookMs < SLOW_MS);
      // As long again: half of the time is the work's.
      if (tookMs > SLOW_MS) await new Promise((resolve) => setTimeout(resolve, tookMs));
      if (this.opening === opening) this.tookMs = tookMs;
    }
    this.running = false;
    // Something else is opened meanwhile.
    if (this.opening && this.opening !== opening && this.newest) void this.run(this.opening);
  }

  /** Resolves to how long it took. */
  private async draw(opening: Opening, frame: SketchFrame, shadow: boolean): Promise<number> {
    const isFirst = this.shown === null;
    const from = performance.now();
    this.newest = null;
    this.parts.show(opening, frame, shadow);
    this.shown = { opening, t: frame.t };
    if (isFirst) this.parts.onChange(true);
    await this.parts.finished();
    if (isFirst) performance.mark('shapespline moves');
    return performance.now() - from;
  }
}
