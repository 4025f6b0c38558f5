/** Commands on time and playing. */
import { loopRange, withEnd } from '../../model/frames.ts';
import { keyboardStep } from '../../model/keyboard-step.ts';
import type { LoopMode, Play } from '../../model/state.ts';
import { SPEEDS } from '../../model/state.ts';
import { clampTime, formatTime, length, neighbourKey, timeScale } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { including, windowOf, zoomed } from '../../model/time-window.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';
import { changeView } from './context.ts';

const LOOPS: readonly LoopMode[] = ['bounce', 'loop', 'once'];

export const TIME = {
  togglePlay: {
    keys: [' '],
    shown: 'Space',
    does: 'Play or pause',
    run(context) {
      const { playing } = context.session.store.get().play;
      play(context, { playing: !playing });
      if (playing) used(context);
    },
  },
  step: { shown: '←  →', does: 'Step one frame, or 1 % of the range; Shift: ten times as far', run: step },
  goToEnd: { shown: 'Home  End', does: 'First or last key; press again for the end of the extrapolation', run: step },
  previousKey: { keys: ['['], shown: '[', does: 'Previous key', run: (context) => jumpKey(context, -1) },
  nextKey: { keys: [']'], shown: ']', does: 'Next key', run: (context) => jumpKey(context, 1) },
  nextLoop: {
    keys: ['l'],
    shown: 'L',
    does: 'Back and forth, loop, or once',
    run(context) {
      const { loop } = context.session.store.get().play;
      play(context, { loop: LOOPS[(LOOPS.indexOf(loop) + 1) % LOOPS.length]! });
    },
  },
  slower: { keys: [','], shown: ',', does: 'Slower', run: (context) => stepSpeed(context, -1) },
  faster: { keys: ['.'], shown: '.', does: 'Faster', run: (context) => stepSpeed(context, 1) },
  startHere: {
    keys: ['ctrl+home'],
    shown: 'Ctrl+Home',
    does: 'Start playback here',
    run: (context) => loopEnd(context, 'start', null),
  },
  endHere: {
    keys: ['ctrl+end'],
    shown: 'Ctrl+End',
    does: 'End playback here',
    run: (context) => loopEnd(context, 'end', null),
  },
  playAll: { keys: ['p'], shown: 'P', does: 'Play the whole range', run: (context) => between(context, null) },
  zoomIn: {
    keys: ['+', '='],
    shown: '+',
    does: 'Zoom in on the timeline; the mouse wheel zooms around the pointer',
    run: (context) => zoomTime(context, 2),
  },
  zoomOut: { keys: ['-'], shown: '-', does: 'Zoom out of the timeline', run: (context) => zoomTime(context, 0.5) },
  zoomToAll: { keys: ['0'], shown: '0', does: 'The whole timeline', run: (context) => window(context, null) },
  toggleClock: {
    keys: ['t'],
    shown: 'T',
    does: 'Frames, loop and zoom',
    run: ({ overlays }) => overlays.toggleClock(),
  },
  seek: { run: seek },
  /** Goes to a typed time and brings it into the timeline's view. */
  goTo: {
    run(context, t: number) {
      const { store, range } = context.session;
      const { doc, view } = store.get();
      const reached = clampTime(t, range());
      const scale = timeScale(range(), doc.keys.length);
      window(context, including(windowOf(view.window, scale), scale, reached));
      if (reached !== t)
        context.feedback.say(`The timeline ${t < reached ? 'starts' : 'ends'} at ${formatTime(reached, range())} s.`);
      seek(context, t);
    },
  },
  /** Reports the time t under the mouse on the timeline, or null when the mouse leaves. */
  peek: { run: ({ display }, t: number | null) => display.timePictures.want(t) },
  loop: { run: (context, loop: LoopMode) => play(context, { loop }) },
  speed: { run: (context, speed: number) => play(context, { speed }) },
  fps: { run: (context, fps: number | null) => play(context, { fps }) },
  between: { run: between },
  loopEnd: { run: loopEnd },
  window: { run: window },
  zoomTime: { run: zoomTime },
} satisfies Actions;

/** The user has moved through time, so the welcome can close. */
function used({ viewState }: Pick<Context, 'viewState'>): void {
  viewState.change({ welcome: false });
}

export function play({ session: { store } }: Context, change: Partial<Play>): void {
  store.set({ play: { ...store.get().play, ...change } });
}

export function seek(context: Pick<Context, 'session' | 'viewState'>, t: number): void {
  const { store, range } = context.session;
  if (!Number.isFinite(t)) return;
  store.set({ time: clampTime(t, range()), play: { ...store.get().play, playing: false } });
  used(context);
}

/** Handles arrow, Home, End and page keys; returns false for any other key. */
function step(context: Context, event: KeyboardEvent): boolean {
  const { store, range } = context.session;
  const { doc, time, play: clock } = store.get();
  const reached = keyboardStep(event, time, timeScale(range(), doc.keys.length), clock.fps);
  if (reached !== null) seek(context, reached);
  return reached !== null;
}

export function jumpKey(context: Context, direction: 1 | -1): void {
  const { store, range } = context.session;
  const { doc, time } = store.get();
  const times = doc.keys.map((key) => key.time);
  seek(context, neighbourKey(time, times, direction, range()));
}

function stepSpeed(context: Context, by: 1 | -1): void {
  const speed = SPEEDS[SPEEDS.indexOf(context.session.store.get().play.speed) + by];
  if (speed) play(context, { speed });
}

export function between(context: Context, stretch: Range | null): void {
  play(context, { between: stretch && [stretch[0], stretch[1]] });
}

function window(context: Context, part: Range | null): void {
  changeView(context, { window: part && [part[0], part[1]] });
}

/** Sets the start or end of playing; null means the current time. */
function loopEnd(context: Context, end: 'start' | 'end', t: number | null): void {
  const { store, range } = context.session;
  const { play: clock, time } = store.get();
  const whole = range();
  const least = clock.fps === null ? 0.001 * length(whole) : 1 / clock.fps;
  between(context, withEnd(loopRange(clock.between, whole), whole, end, t ?? time, least));
}

/** Zooms the timeline about the playhead, or about its middle if the playhead is out of view. */
function zoomTime(context: Context, factor: number): void {
  const { store, range } = context.session;
  const { doc, time: t, view } = store.get();
  const scale = timeScale(range(), doc.keys.length);
  const part = windowOf(view.window, scale);
  window(context, zoomed(part, scale, factor, t >= part[0] && t <= part[1] ? t : (part[0] + part[1]) / 2));
}
