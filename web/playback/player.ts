/** Playback: advances the time once per screen refresh. A whole frame is held until the next begins. */
import { frameStartTime, loopRange, playRange } from '../model/frames.ts';
import type { Play } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { tick } from './loop-clock.ts';
import type { Clock } from './look-ahead.ts';

export interface PlayerView {
  time: number;
  play: Play;
  range: Range;
  periodic: boolean;
}

/** After a pause of the whole page (a hidden tab, a long task), the motion continues from where it stopped. */
const LONGEST_STEP_MS = 100;
/** Weight of the latest refresh in the running mean. */
const NEW_SHARE = 0.1;

export class Player implements Clock {
  /** Screen refreshes since the page was opened, including those missed by a busy page. */
  tick = 0;
  private refreshMs = 1000 / 60;
  private frame = 0;
  private last = 0;
  private direction: 1 | -1 = 1;
  /** The current time before rounding to a whole frame. */
  private reached = 0;
  private shown = NaN;

  /** `onTick` is called on every refresh, `move` when the time changes. */
  constructor(
    private readonly view: () => PlayerView,
    private readonly move: (time: number, playing: boolean) => void,
    private readonly onTick: () => void = () => undefined,
  ) {}

  start(): void {
    if (this.frame !== 0) return;
    const { time, play, periodic, range, chosen } = this.stretch();
    this.direction = 1;
    this.last = performance.now();
    this.reached = time;
    this.shown = time;
    // At the end of a single play, starts again from the beginning.
    if (play.loop === 'once' && !periodic && time >= this.lastShown(range, play)) this.jump(range[0]);
    // Playback starts inside a chosen range, because running to it from outside would take time.
    else if (chosen && (time < range[0] || time > range[1])) this.jump(range[0]);
    this.frame = requestAnimationFrame(() => this.step());
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  tickSeconds(): number {
    return this.refreshMs / 1000;
  }

  timeOf(later: number): number {
    const { play, range, periodic } = this.stretch();
    const step = this.tickSeconds() * play.speed;
    let at = { time: this.reached, direction: this.direction, playing: true };
    for (let ticks = this.tick; ticks < later && at.playing; ticks += 1)
      at = tick({ ...at, step, range, loop: play.loop, periodic });
    return frameStartTime(at.time, play.fps, range[0]);
  }

  private jump(time: number): void {
    this.reached = time;
    this.shown = time;
    this.move(time, true);
  }

  /** The playing range. A part of a closed motion is not closed. */
  private stretch(): PlayerView & { chosen: boolean } {
    const view = this.view();
    const chosen = loopRange(view.play.between, view.range) !== null;
    return { ...view, range: playRange(view.play.between, view.range), periodic: view.periodic && !chosen, chosen };
  }

  private lastShown(range: Range, { fps }: Play): number {
    return frameStartTime(range[1], fps, range[0]);
  }

  private step(): void {
    const now = performance.now();
    const { time, play, range, periodic } = this.stretch();
    const passed = Math.min(now - this.last, LONGEST_STEP_MS);
    const step = (passed / 1000) * play.speed;
    this.last = now;
    this.count(passed);
    // The time was changed from outside.
    if (time !== this.shown) this.reached = time;
    const next = tick({ time: this.reached, direction: this.direction, step, range, loop: play.loop, periodic });
    this.direction = next.direction;
    this.reached = next.time;
    this.frame = next.playing ? requestAnimationFrame(() => this.step()) : 0;
    const shown = frameStartTime(next.time, play.fps, range[0]);
    const same = shown === this.shown && next.playing;
    this.shown = shown;
    if (!same) this.move(shown, next.playing);
    this.onTick();
  }

  private count(passed: number): void {
    const ticks = Math.max(Math.round(passed / this.refreshMs), 1);
    if (ticks === 1) this.refreshMs += NEW_SHARE * (passed - this.refreshMs);
    this.tick += ticks;
  }
}
