/**
 * The time slider, the widest control of the page: a solid key range, hatched margins where the motion is extrapolated,
 * key ticks that the playhead snaps to and that can be dragged to other times, and the time as a number.
 */
import { h, memo, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import type { Phase, Range } from '../model/time-scale.ts';
import { clampKeyTime, clampTime, formatTime, length, limits, snap, toFraction, toTime } from '../model/time-scale.ts';

/** Pixels within which the playhead snaps to a key. */
const SNAP_PX = 7;
/** Pixels that a press on a tick may move and still be a click. */
const CLICK_PX = 4;

export interface TimelineProps {
  range: Range;
  keys: readonly { time: number; name: string }[];
  time: number;
  phase: Phase;
  periodic: boolean;
  disabled: boolean;
}

export interface TimelineEvents {
  onSeek(t: number): void;
  /** A key is being dragged to another time. */
  onRetime(key: number, time: number): void;
}

export interface Timeline {
  element: HTMLElement;
  /** The element with role=slider, which takes the keyboard. */
  slider: HTMLElement;
  update(props: TimelineProps): void;
}

export function createTimeline(events: TimelineEvents): Timeline {
  let props: TimelineProps | null = null;

  const before = createMargin('before');
  const after = createMargin('after');
  const track = h('div', { class: 'track', 'aria-hidden': 'true' }, before.element, h('div', { class: 'key-range' }), after.element);
  const ticks = h('div', { class: 'ticks' });
  const playhead = h('div', { class: 'playhead', 'aria-hidden': 'true' }, h('div', { class: 'knob' }));
  const slider = h('div', {
    class: 'timeline', role: 'slider', tabindex: 0, 'aria-label': 'Time', 'aria-orientation': 'horizontal', 'data-testid': 'timeline',
    title: 'Drag through the motion, also past both ends (arrow keys; hold Alt not to snap)',
  }, track, ticks, playhead);

  const timeAt = (event: PointerEvent, free: boolean): number => {
    const { range, keys } = props!;
    const box = track.getBoundingClientRect();
    const t = toTime((event.clientX - box.left) / box.width, range);
    const reach = free ? 0 : (SNAP_PX / box.width) * (limits(range)[1] - limits(range)[0]);
    return snap(t, keys.map((key) => key.time), reach);
  };

  slider.addEventListener('pointerdown', (event) => {
    if (!props || props.disabled || event.button !== 0 || (event.target as Element).closest('.tick')) return;
    event.preventDefault();
    slider.focus({ preventScroll: true });
    drag(slider, event, (move) => events.onSeek(timeAt(move, move.altKey)));
    events.onSeek(timeAt(event, event.altKey));
  });

  const tickPressed = (index: number, event: PointerEvent): void => {
    if (!props || props.disabled || event.button !== 0) return;
    event.preventDefault();
    slider.focus({ preventScroll: true });
    const startX = event.clientX;
    let moved = false;
    const { range, keys } = props;
    const times = keys.map((key) => key.time);
    const box = track.getBoundingClientRect();
    const scale = (limits(range)[1] - limits(range)[0]) / box.width;
    drag(event.currentTarget as HTMLElement, event, (move) => {
      moved ||= Math.abs(move.clientX - startX) > CLICK_PX;
      if (!moved) return;
      const wanted = (times[index] ?? 0) + (move.clientX - startX) * scale;
      events.onRetime(index, clampKeyTime(times, index, wanted));
    }, () => { if (!moved) events.onSeek(times[index] ?? 0); });
  };

  const drawTicks = memo(({ keys, range }: Pick<TimelineProps, 'keys' | 'range'>) => {
    while (ticks.children.length > keys.length) ticks.lastElementChild?.remove();
    keys.forEach((key, index) => {
      const tick = (ticks.children[index] ?? ticks.appendChild(makeTick(index))) as HTMLElement;
      setStyle(tick, 'left', percent(toFraction(key.time, range)));
      setAttribute(tick, 'title', `Key ${index + 1}, ${key.name}, at ${formatTime(key.time, range)}: click to go there, drag to move it in time`);
      setAttribute(tick, 'data-time', key.time);
    });
  });

  const makeTick = (index: number): HTMLElement => h('div', {
    class: 'tick', 'data-testid': `tick-${index}`, 'aria-hidden': 'true',
    onpointerdown: (event: PointerEvent) => tickPressed(index, event),
  }, h('span', { class: 'diamond' }), h('span', { class: 'tick-number' }, String(index + 1)));

  const drawRange = memo(({ range, periodic, disabled }: Pick<TimelineProps, 'range' | 'periodic' | 'disabled'>) => {
    const [low, high] = limits(range);
    setAttribute(slider, 'aria-valuemin', round(low));
    setAttribute(slider, 'aria-valuemax', round(high));
    setAttribute(slider, 'aria-disabled', disabled ? 'true' : null);
    setAttribute(slider, 'data-periodic', periodic);
    before.label(periodic ? REPEATS : ['Before the first key (extrapolated)', 'Extrapolated', 'Before']);
    after.label(periodic ? REPEATS : ['Beyond the last key (extrapolated)', 'Extrapolated', 'Beyond']);
  });

  return {
    element: slider,
    slider,
    update(next) {
      props = next;
      drawRange({ range: next.range, periodic: next.periodic, disabled: next.disabled });
      drawTicks({ keys: next.keys, range: next.range });
      setHidden(playhead, next.disabled);
      setStyle(playhead, 'left', percent(toFraction(clampTime(next.time, next.range), next.range)));
      setAttribute(slider, 'data-phase', next.phase.kind);
      setAttribute(slider, 'aria-valuenow', round(next.time));
      setAttribute(slider, 'aria-valuetext', `${formatTime(next.time, next.range)}, ${next.phase.text}`);
    },
  };
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

function percent(fraction: number): string {
  return `${(fraction * 100).toFixed(4)}%`;
}

function round(value: number): number {
  return Number(value.toFixed(6));
}

/** Follows one pointer from its press to its release. */
function drag(element: HTMLElement, start: PointerEvent, onMove: (event: PointerEvent) => void, onEnd?: () => void): void {
  element.setPointerCapture(start.pointerId);
  const move = (event: PointerEvent): void => { if (event.pointerId === start.pointerId) onMove(event); };
  const end = (event: PointerEvent): void => {
    if (event.pointerId !== start.pointerId) return;
    element.removeEventListener('pointermove', move);
    element.removeEventListener('pointerup', end);
    element.removeEventListener('pointercancel', end);
    onEnd?.();
  };
  element.addEventListener('pointermove', move);
  element.addEventListener('pointerup', end);
  element.addEventListener('pointercancel', end);
}

/** Where a key press takes the playhead, or null when the key means something else. */
export function keyboardStep(event: KeyboardEvent, time: number, range: Range): number | null {
  const step = (event.shiftKey ? 0.1 : 0.01) * length(range);
  const [low, high] = limits(range);
  switch (event.key) {
    case 'ArrowLeft': case 'ArrowDown': return clampTime(time - step, range);
    case 'ArrowRight': case 'ArrowUp': return clampTime(time + step, range);
    case 'PageDown': return clampTime(time - 0.1 * length(range), range);
    case 'PageUp': return clampTime(time + 0.1 * length(range), range);
    case 'Home': return time <= range[0] ? low : range[0];
    case 'End': return time >= range[1] ? high : range[1];
    default: return null;
  }
}
