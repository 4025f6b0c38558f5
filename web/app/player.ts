/** Plays: once a screen refresh it moves the time on by what has passed. */
import type { Play } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { tick } from './clock.ts';

export interface PlayerView {
  time: number;
  play: Play;
  range: Range;
  periodic: boolean;
}

/** After a pause of the whole page (a hidden tab, a long task) the motion goes on where it was. */
const LONGEST_STEP_MS = 100;

export class Player {
  private frame = 0;
  private last = 0;
  private direction: 1 | -1 = 1;

  constructor(private readonly view: () => PlayerView, private readonly move: (time: number, playing: boolean) => void) {}

  start(): void {
    if (this.frame !== 0) return;
    const { time, play, range, periodic } = this.view();
    this.direction = 1;
    this.last = performance.now();
    // Played once and at its end: from the start again.
    if (play.loop === 'once' && !periodic && time >= range[1]) this.move(range[0], true);
    this.frame = requestAnimationFrame(() => this.step());
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private step(): void {
    const now = performance.now();
    const { time, play, range, periodic } = this.view();
    const step = (Math.min(now - this.last, LONGEST_STEP_MS) / 1000) * play.speed;
    this.last = now;
    const next = tick({ time, direction: this.direction, step, range, loop: play.loop, periodic });
    this.direction = next.direction;
    this.frame = next.playing ? requestAnimationFrame(() => this.step()) : 0;
    this.move(next.time, next.playing);
  }
}
