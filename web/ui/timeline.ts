/**
 * The time slider, the widest control of the page: a solid key range, hatched margins where the motion is extrapolated,
 * key ticks that the playhead snaps to and that can be dragged to other times, and two handles for what plays. It can
 * be zoomed into, about the pointer. A curve in the track is the speed of the motion, a picture over it the moment
 * under the mouse. A ruler counts seconds, or whole frames. Under it are handles for the speeds at
 * its ends, where the boundary has them.
 */
import { h, memo, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import { keyLabel } from '../model/key-names.ts';
import type { Pace } from '../model/pace.ts';
import type { End } from '../model/speeds.ts';
import type { Phase, Range, TimeScale } from '../model/time-scale.ts';
import { clamp, clampKeyTime, clampTime, length, snap } from '../model/time-scale.ts';
import { loopRange, momentWords, nearestFrameTime } from '../model/frames.ts';
import { fractionIn, panned, revealing, ruler, timeIn, windowOf, zoomed } from '../model/time-window.ts';
import { createLoopHandles } from './loop-handles.ts';
import { createOverview } from './overview.ts';
import { createPaceLane } from './pace-lane.ts';
import { drag, focusPressed, listenToGestures } from './pointer.ts';
import type { SpeedHandlesProps } from './speed-handles.ts';
import { createSpeedHandles } from './speed-handles.ts';
import { createTimePeek } from './time-peek.ts';

/** Pixels within which the playhead snaps to a key. */
const SNAP_PX = 7;
/** Pixels that a press on a tick may move and still be a click. */
const CLICK_PX = 4;
/** Keys nearer to each other than this, in pixels, are drawn small. */
const DENSE_PX = 16;
/** Pixels that the number of a key takes. */
const NUMBER_PX = 20;
/** Pixels that a number of the ruler takes. */
const RULER_PX = 72;
/** From the middle of the knob to that of a number that it would lie on. */
const COVERED_PX = 26;

export interface TimelineProps extends TimeScale {
  keys: readonly { time: number; name: string }[];
  time: number;
  playing: boolean;
  phase: Phase;
  periodic: boolean;
  disabled: boolean;
  fps: number | null;
  /** What plays; null = the range of the keys. */
  between: Range | null;
  /** What is shown; null = the whole. */
  window: Range | null;
  /** Hermite: how fast the motion leaves the first key and arrives at the last; null = another boundary. */
  speeds: SpeedHandlesProps['speeds'];
  /** The fastest on offer there. */
  mostSpeeds: SpeedHandlesProps['most'];
  towards: SpeedHandlesProps['towards'];
  /** null = not known yet. */
  pace: Pace | null;
  /** Of the last moment that was pointed at, as an address; null = none of this motion. */
  picture: string | null;
}

export interface TimelineEvents {
  onSeek(t: number): void;
  /** A key is being dragged to another time. */
  onRetime(key: number, time: number): void;
  onBetween(between: Range | null): void;
  onWindow(window: Range | null): void;
  onSpeed(end: End, speed: number): void;
  /** A picture of this moment is wanted; null: none any more. */
  onPeek(t: number | null): void;
}

export interface Timeline {
  element: HTMLElement;
  /** The element with role=slider, which takes the keyboard. */
  slider: HTMLElement;
  update(props: TimelineProps): void;
}

export function createTimeline(events: TimelineEvents): Timeline {
  let props: TimelineProps | null = null;
  const shown = (): Range => windowOf(props!.window, props!);
  // Several events can come before the page is drawn again: each goes on from what the one before has asked for.
  const setWindow = (window: Range | null): void => {
    if (props) props = { ...props, window };
    events.onWindow(window);
  };

  const before = createMargin('before');
  const after = createMargin('after');
  const keyRange = h('div', { class: 'key-range' });
  const silent = [h('div', { class: 'silent' }), h('div', { class: 'silent' })] as const;
  const pace = createPaceLane();
  const track = h('div', { class: 'track', 'aria-hidden': 'true' }, before.element, keyRange, after.element);
  track.append(pace.element, ...silent);
  const marks = h('div', { class: 'ruler', 'aria-hidden': 'true' });
  const ticks = h('div', { class: 'ticks' });
  const playhead = h('div', { class: 'playhead', 'aria-hidden': 'true' }, h('div', { class: 'knob' }));
  const slider = h(
    'div',
    {
      class: 'timeline',
      role: 'slider',
      tabindex: 0,
      'aria-label': 'Time',
      'aria-orientation': 'horizontal',
      'data-testid': 'timeline',
      title:
        'Drag through the motion, also past both ends (arrow keys step; Alt: without snapping; the wheel zooms). ' +
        'The curve is the speed of the motion; yellow below it: the motion swings past a key (overshoot)',
    },
    track,
    marks,
    ticks,
    playhead,
  );
  const handles = createLoopHandles(track, { onBetween: events.onBetween, snapped: (t, free) => snapped(t, free) });
  const overview = createOverview(setWindow);
  const speedHandles = createSpeedHandles(events.onSpeed);
  const element = h(
    'div',
    { class: 'time-frame' },
    slider,
    ...handles.elements,
    speedHandles.element,
    overview.element,
  );
  const peek = createTimePeek({
    over: slider,
    frame: element,
    timeAt: (event) => (props && !props.disabled ? snapped(timeAt(event.clientX), event.altKey) : null),
    onPeek: events.onPeek,
  });
  element.append(peek.element);

  const snapped = (t: number, free: boolean): number => {
    const { keys, fps } = props!;
    if (free) return t;
    const reach = (SNAP_PX / track.clientWidth) * length(shown());
    const key = snap(
      t,
      keys.map(({ time }) => time),
      reach,
    );
    return key !== t || fps === null ? key : nearestFrameTime(t, fps);
  };

  const timeAt = (x: number): number => {
    const box = track.getBoundingClientRect();
    return timeIn(clamp((x - box.left) / box.width, 0, 1), shown());
  };

  const seek = (event: PointerEvent): void => events.onSeek(snapped(timeAt(event.clientX), event.altKey));

  slider.addEventListener('pointerdown', (event) => {
    if (
      !props ||
      props.disabled ||
      event.button !== 0 ||
      !event.isPrimary ||
      (event.target as Element).closest('.tick')
    )
      return;
    event.preventDefault();
    focusPressed(slider);
    drag(slider, event, { onMove: seek });
    seek(event);
  });

  listenToGestures(element, {
    onZoom: (factor, x) => {
      if (props && !props.disabled) setWindow(zoomed(shown(), props, factor, timeAt(x)));
    },
    onPan: (pixels) => {
      if (props && !props.disabled) setWindow(panned(shown(), props, (-pixels / track.clientWidth) * length(shown())));
    },
  });

  const tickPressed = (index: number, event: PointerEvent): void => {
    if (!props || props.disabled || event.button !== 0 || !event.isPrimary) return;
    event.preventDefault();
    focusPressed(slider);
    const startX = event.clientX;
    let moved = false;
    const { keys, fps } = props;
    const times = keys.map((key) => key.time);
    const scale = length(shown()) / track.clientWidth;
    drag(event.currentTarget as HTMLElement, event, {
      onMove(move) {
        moved ||= Math.abs(move.clientX - startX) > CLICK_PX;
        if (!moved) return;
        const wanted = (times[index] ?? 0) + (move.clientX - startX) * scale;
        events.onRetime(
          index,
          clampKeyTime(times, index, fps === null || move.altKey ? wanted : nearestFrameTime(wanted, fps)),
        );
      },
      onEnd: () => {
        if (!moved) events.onSeek(times[index] ?? 0);
      },
    });
  };

  const drawTicks = memo(
    ({ keys, range, part, fps, width }: Pick<TimelineProps, 'keys' | 'range' | 'fps'> & Part & { width: number }) => {
      let numbered = -Infinity;
      const across = keys.length > 1 ? (keys.at(-1)!.time - keys[0]!.time) / length(part) : 0;
      setAttribute(
        ticks,
        'data-dense',
        width > 0 && (across * width) / (keys.length - 1) < DENSE_PX && keys.length > 2,
      );
      while (ticks.children.length > keys.length) ticks.lastElementChild?.remove();
      keys.forEach((key, index) => {
        const tick = (ticks.children[index] ?? ticks.appendChild(makeTick(index))) as HTMLElement;
        place(tick, key.time, part);
        setAttribute(
          tick,
          'title',
          `${keyLabel(index, key.name)}, at ${momentWords(key.time, range, fps)}: click to go there, drag to move it in time`,
        );
        setAttribute(tick, 'data-time', key.time);
        const x = fractionIn(key.time, part) * width;
        const room = x - numbered >= NUMBER_PX || width === 0;
        setAttribute(tick, 'data-unnumbered', !room);
        if (room) numbered = x;
      });
    },
  );

  const makeTick = (index: number): HTMLElement =>
    h(
      'div',
      {
        class: 'tick',
        'data-testid': `tick-${index}`,
        'aria-hidden': 'true',
        onpointerdown: (event: PointerEvent) => tickPressed(index, event),
      },
      h('span', { class: 'diamond' }),
      h('span', { class: 'tick-number' }, String(index + 1)),
    );

  const drawRange = memo(
    ({
      range,
      whole,
      part,
      between,
      periodic,
      disabled,
    }: Pick<TimelineProps, 'range' | 'whole' | 'between' | 'periodic' | 'disabled'> & Part) => {
      const low = Math.min(whole[0], part[0]);
      const high = Math.max(whole[1], part[1]);
      const loop = loopRange(between, range);
      stretch(before.element, low, range[0], part);
      stretch(keyRange, range[0], range[1], part);
      stretch(after.element, range[1], high, part);
      stretch(silent[0], loop ? low : 0, loop ? loop[0] : 0, part);
      stretch(silent[1], loop ? loop[1] : 0, loop ? high : 0, part);
      setAttribute(slider, 'aria-valuemin', round(low));
      setAttribute(slider, 'aria-valuemax', round(high));
      setAttribute(slider, 'aria-disabled', disabled ? 'true' : null);
      setAttribute(slider, 'data-periodic', periodic);
      before.label(periodic ? REPEATS : ['Before the first key (extrapolated)', 'Extrapolated', 'Before']);
      after.label(periodic ? REPEATS : ['Beyond the last key (extrapolated)', 'Extrapolated', 'Beyond']);
      setAttribute(element, 'data-zoomed', length(part) < length(whole));
      overview.update({ range, whole }, part);
    },
  );

  let markTimes: number[] = [];
  const drawRuler = memo(({ part, fps, width }: Pick<TimelineProps, 'fps'> & Part & { width: number }) => {
    const unit = fps ?? 1;
    const numbers =
      width > 0
        ? ruler([part[0] * unit, part[1] * unit], width / RULER_PX).filter((n) => fps === null || Number.isInteger(n))
        : [];
    const decimals = Math.max(Math.ceil(-Math.log10((numbers[1] ?? 1) - (numbers[0] ?? 0)) - 1e-9), 0);
    marks.replaceChildren(
      ...numbers.map((n) => {
        const mark = h('span', { class: 'mark' }, `${(n + 0).toFixed(decimals)}${fps === null ? ' s' : ''}`);
        place(mark, n / unit, part);
        return mark;
      }),
    );
    markTimes = numbers.map((n) => n / unit);
  });

  /** Half of a number beside the knob reads as none. */
  const giveWay = (t: number, part: Range): void => {
    const x = (time: number): number => fractionIn(time, part) * width;
    markTimes.forEach((time, index) =>
      setAttribute(marks.children[index]!, 'data-covered', Math.abs(x(time) - x(t)) < COVERED_PX),
    );
  };

  let width = 0;
  new ResizeObserver(() => {
    width = track.clientWidth;
    if (!props) return;
    drawRuler({ part: shown(), fps: props.fps, width });
    drawTicks({ ...props, part: shown(), width });
  }).observe(track);

  /** The playhead stays in sight wherever it goes, unless the user has panned away from a motion that plays. */
  const follow = (last: TimelineProps | null, next: TimelineProps): void => {
    if (!last || next.window === null || last.time === next.time || next.window !== last.window) return;
    const part = windowOf(next.window, next);
    const sees = (t: number): boolean => t >= part[0] && t <= part[1];
    if (!sees(next.time) && (sees(last.time) || !next.playing))
      events.onWindow(revealing(part, next, clampTime(next.time, next.range)));
  };

  return {
    element,
    slider,
    update(next) {
      const last = props;
      props = next;
      const { range, whole, keys, periodic, disabled, fps, between, window, speeds, mostSpeeds, towards, phase } = next;
      const part = windowOf(window, next);
      drawRange({ range, whole, part, between, periodic, disabled });
      drawTicks({ keys, range, part, fps, width });
      drawRuler({ part, fps, width });
      handles.update({ range, window: part, between: loopRange(between, range), fps, disabled });
      speedHandles.update({ speeds, most: mostSpeeds, towards, range, window: part });
      pace.update({ pace: next.pace, range, part });
      peek.update({ pace: next.pace, range, fps, picture: next.picture });
      if (disabled) setHidden(playhead, true);
      else place(playhead, clampTime(next.time, range), part);
      if (!disabled) giveWay(next.time, part);
      setAttribute(slider, 'data-phase', phase.kind);
      setAttribute(slider, 'aria-valuenow', round(next.time));
      setAttribute(slider, 'aria-valuetext', `${momentWords(next.time, range, fps)}, ${phase.text}`);
      follow(last, next);
    },
  };
}

/** The stretch of time that is shown. */
interface Part {
  part: Range;
}

/** From the longest to the shortest; the style sheet shows the one that fits. */
type MarginWords = readonly [string, string, string];
const REPEATS: MarginWords = ['Repeats', 'Repeats', 'Repeats'];

function createMargin(side: 'before' | 'after'): { element: HTMLElement; label(words: MarginWords): void } {
  const labels = ['long', 'middle', 'short'].map((size) => h('span', { class: `margin-label ${size}` }));
  const element = h('div', { class: `margin ${side}` }, ...labels);
  return {
    element,
    label(words) {
      labels.forEach((label, index) => setText(label, words[index]!));
      setAttribute(element, 'title', words[0]);
    },
  };
}

/** Puts an element at a moment, or hides it where the window does not reach. */
function place(element: HTMLElement, t: number, window: Range): void {
  const at = fractionIn(t, window);
  setHidden(element, at < -1e-9 || at > 1 + 1e-9);
  setStyle(element, 'left', percent(at));
}

/** Lets an element span what the window shows of a stretch of time. */
function stretch(element: HTMLElement, from: number, to: number, window: Range): void {
  const [left, right] = [clamp(fractionIn(from, window), 0, 1), clamp(fractionIn(to, window), 0, 1)];
  setHidden(element, right <= left);
  setStyle(element, 'left', percent(left));
  setStyle(element, 'width', percent(right - left));
}

function percent(fraction: number): string {
  return `${(fraction * 100).toFixed(4)}%`;
}

function round(value: number): number {
  return Number(value.toFixed(6));
}
