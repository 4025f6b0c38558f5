/** The keys on the timeline: press to go to a key, drag to change its time. */
import { momentWords, nearestFrameTime } from '../model/frames.ts';
import { keyLabel } from '../model/key-names.ts';
import type { Range } from '../model/time-scale.ts';
import { clampKeyTime, length } from '../model/time-scale.ts';
import { fractionIn } from '../model/time-window.ts';
import { positionAtTime } from './timeline-position.ts';
import { h, memo, setAttribute } from './dom.ts';
import { drag, isPress } from './pointer.ts';

/** Movement in pixels up to which a press on a tick counts as a click. */
const CLICK_PX = 4;
/** Keys closer than this, in pixels, are drawn small. */
const DENSE_PX = 16;
/** Width of a key's number in pixels. */
const NUMBER_PX = 20;

export interface KeyTicksProps {
  keys: readonly { time: number; name: string }[];
  range: Range;
  /** The visible range of time. */
  part: Range;
  fps: number | null;
  /** Width of the timeline in pixels. */
  width: number;
  disabled: boolean;
}

export interface KeyTicksEvents {
  onSeek(t: number): void;
  /** A key is being dragged to another time. */
  onRetime(key: number, time: number): void;
}

export function createKeyTicks(events: KeyTicksEvents): { element: HTMLElement; update(props: KeyTicksProps): void } {
  let props: KeyTicksProps | null = null;
  const element = h('div', { class: 'ticks' });

  const pressed = (index: number, event: PointerEvent): void => {
    if (!props || props.disabled || !isPress(event)) return;
    const startX = event.clientX;
    let moved = false;
    const { keys, fps, part, width } = props;
    const times = keys.map((key) => key.time);
    const from = times[index] ?? 0;
    drag(event.currentTarget as HTMLElement, event, {
      onMove(move) {
        moved ||= Math.abs(move.clientX - startX) > CLICK_PX;
        if (!moved) return;
        const wanted = from + ((move.clientX - startX) * length(part)) / width;
        const whole = fps === null || move.altKey ? wanted : nearestFrameTime(wanted, fps);
        events.onRetime(index, clampKeyTime(times, index, whole));
      },
      onEnd: () => {
        if (!moved) events.onSeek(from);
      },
    });
  };

  const createTick = (index: number): HTMLElement =>
    h(
      'div',
      {
        class: 'tick',
        'data-testid': `tick-${index}`,
        'aria-hidden': 'true',
        onpointerdown: (event: PointerEvent) => pressed(index, event),
      },
      h('span', { class: 'diamond' }),
      h('span', { class: 'tick-number' }, String(index + 1)),
    );

  const draw = memo((next: KeyTicksProps) => {
    props = next;
    const { keys, range, part, fps, width } = next;
    setAttribute(element, 'data-dense', areDense(next));
    while (element.children.length > keys.length) element.lastElementChild?.remove();
    let numbered = -Infinity;
    keys.forEach(({ time, name }, index) => {
      const tick = (element.children[index] ?? element.appendChild(createTick(index))) as HTMLElement;
      positionAtTime(tick, time, part);
      const words = `${keyLabel(index, name)}, at ${momentWords(time, range, fps)}`;
      setAttribute(tick, 'title', `${words}: click to go to this key, drag to change its time`);
      setAttribute(tick, 'data-time', time);
      const x = fractionIn(time, part) * width;
      const room = x - numbered >= NUMBER_PX || width === 0;
      setAttribute(tick, 'data-unnumbered', !room);
      if (room) numbered = x;
    });
  });
  return { element, update: draw };
}

function areDense({ keys, part, width }: KeyTicksProps): boolean {
  if (keys.length < 3 || width === 0) return false;
  const across = ((keys.at(-1)!.time - keys[0]!.time) / length(part)) * width;
  return across / (keys.length - 1) < DENSE_PX;
}
