/** Two handles over the timeline for the playing range, dragged or moved with the arrow keys. */
import { positionAtTime } from './timeline-position.ts';
import type { Fields } from './dom.ts';
import { h, setAttribute } from './dom.ts';
import type { Range } from '../model/time-scale.ts';
import { length } from '../model/time-scale.ts';
import { momentWords, playRange, steppedFrameTime, withEnd } from '../model/frames.ts';
import { fractionIn, timeIn } from '../model/time-window.ts';
import { drag } from './pointer.ts';

export interface LoopHandlesProps {
  range: Range;
  window: Range;
  between: Range | null;
  fps: number | null;
  disabled: boolean;
}

export interface LoopHandlesEvents {
  /** null restores the range of the keys. */
  onBetween(between: Range | null): void;
  /** The time to snap to near t. */
  snapped(t: number, free: boolean): number;
}

type End = 'start' | 'end';
const LABELS: Record<End, string> = { start: 'Playback start', end: 'Playback end' };

export type LoopHandles = Fields<LoopHandlesProps>;

export function createLoopHandles(track: HTMLElement, events: LoopHandlesEvents): LoopHandles {
  let props: LoopHandlesProps | null = null;
  const gap = (): number => (props!.fps === null ? 0.001 * length(props!.range) : 1 / props!.fps);
  // Several events can arrive before the page is redrawn. Each continues from the last requested value.
  const move = (end: End, t: number): void => {
    const between = withEnd(props!.between, props!.range, end, t, gap());
    props = { ...props!, between };
    events.onBetween(between);
  };

  const pressed = (end: End, event: PointerEvent): void => {
    if (!props || props.disabled || event.button !== 0) return;
    event.preventDefault();
    event.stopPropagation();
    const box = track.getBoundingClientRect();
    const grip = event.clientX - (box.left + fractionIn(ends(props)[end], props.window) * box.width);
    drag(event.currentTarget as HTMLElement, event, {
      onMove: (moved) =>
        move(end, events.snapped(timeIn((moved.clientX - grip - box.left) / box.width, props!.window), moved.altKey)),
    });
  };

  const typed = (end: End, event: KeyboardEvent): void => {
    if (!props) return;
    const { range, fps } = props;
    const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (steps !== undefined) {
      const by = steps * (event.shiftKey ? 10 : 1);
      const now = ends(props)[end];
      move(end, fps === null ? now + 0.01 * by * length(range) : steppedFrameTime(now, fps, by));
    } else if (event.key === 'Home' || event.key === 'End') {
      move(end, event.key === 'Home' ? range[0] : range[1]);
    } else if (event.key === 'Delete' || event.key === 'Backspace') {
      events.onBetween(null);
    } else {
      return;
    }
    event.preventDefault();
  };

  const handles = (['start', 'end'] as const).map((end) =>
    h('div', {
      class: `loop-handle ${end}`,
      'data-testid': `loop-${end}`,
      'aria-label': LABELS[end],
      'aria-orientation': 'horizontal',
      title: `${LABELS[end]}: drag it (Alt: without snapping); double-click to play the whole range`,
      onpointerdown: (event: PointerEvent) => pressed(end, event),
      onkeydown: (event: KeyboardEvent) => typed(end, event),
      ondblclick: () => events.onBetween(null),
    }),
  );

  return {
    elements: handles,
    update(next) {
      props = next;
      const { range, window, between, fps, disabled } = next;
      const places = ends(next);
      handles.forEach((handle, index) => {
        const t = places[index === 0 ? 'start' : 'end'];
        positionAtTime(handle, disabled ? null : t, window);
        setAttribute(handle, 'data-set', between !== null);
        // Before they are set, they are only a convenience for the mouse. The menu has equivalent fields.
        setAttribute(handle, 'role', between ? 'slider' : 'presentation');
        setAttribute(handle, 'tabindex', between ? 0 : null);
        setAttribute(handle, 'aria-hidden', between ? null : 'true');
        setAttribute(handle, 'aria-valuemin', between ? Number(window[0].toFixed(6)) : null);
        setAttribute(handle, 'aria-valuemax', between ? Number(window[1].toFixed(6)) : null);
        setAttribute(handle, 'aria-valuenow', between ? Number(t.toFixed(6)) : null);
        setAttribute(handle, 'aria-valuetext', between ? momentWords(t, range, fps) : null);
      });
    },
  };
}

function ends({ between, range }: LoopHandlesProps): Record<End, number> {
  const [start, end] = playRange(between, range);
  return { start, end };
}
