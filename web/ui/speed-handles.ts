/**
 * The Hermite speeds as handles at the ends of the curve, under the first and the last key of the timeline: the longer
 * the handle, the faster the motion leaves the first key or arrives at the last. Dragged, or moved with the arrow keys.
 */
import { h, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import type { Range } from '../model/time-scale.ts';
import { length } from '../model/time-scale.ts';
import type { End, Speeds } from '../model/speeds.ts';
import { DEFAULT_SPEED, MAX_SPEED, formatSpeed, offeredSpeed, steppedSpeed } from '../model/speeds.ts';
import type { Towards } from '../model/state.ts';
import { fractionIn } from '../model/time-window.ts';
import { drag, focusPressed } from './pointer.ts';

/** Pixels of a handle at speed 1, where there is room. */
const UNIT_PX = 40;
/** Pixels that the number beside a handle takes, and that words take where the style sheet shows them. */
const NUMBER_PX = 56;
const WORDS_PX = 112;
const ROOM_FOR_WORDS_PX = 480;
/** Where a shape gives the tangent. */
const SHAPED: Record<End, string> = {
  start: 'the first key to the shape of its tangent',
  end: 'the shape of its tangent to the last key',
};
/** Steps that Shift makes of one. */
const LARGE = 10;

export const SPEED_WORDS: Record<End, { label: string; verb: string; neighbour: string }> = {
  start: { label: 'Start speed', verb: 'leaves at', neighbour: 'the first key to the second' },
  end: { label: 'End speed', verb: 'arrives at', neighbour: 'the second to last key to the last' },
};

export interface SpeedHandlesProps {
  /** null = the boundary has no speeds. */
  speeds: Speeds | null;
  /** The fastest on offer. */
  most: Speeds;
  /** What the ends lead towards; null = as speeds. */
  towards: Readonly<Record<End, Towards>> | null;
  /** Times of the first and the last key. */
  range: Range;
  window: Range;
}

export interface SpeedHandles {
  element: HTMLElement;
  update(props: SpeedHandlesProps): void;
}

export function createSpeedHandles(onSpeed: (end: End, speed: number) => void): SpeedHandles {
  let props: SpeedHandlesProps | null = null;
  let width = 0;
  const speedOf = (end: End): number => props?.speeds?.[end] ?? DEFAULT_SPEED;
  const mostOf = (end: End): number => props?.most[end] ?? MAX_SPEED;
  // Several events can come before the page is drawn again: each goes on from what the one before has asked for.
  const set = (end: End, speed: number): void => {
    if (props?.speeds) props = { ...props, speeds: { ...props.speeds, [end]: speed } };
    onSpeed(end, speed);
  };

  // Both handles at their longest share the room between the keys, and are as long.
  const unit = (end: End): number => {
    const room = props ? ((length(props.range) / length(props.window)) * width) / (2 * MAX_SPEED + 1) : UNIT_PX;
    return (Math.min(UNIT_PX, room) * MAX_SPEED) / mostOf(end);
  };

  const pressed = (end: End, event: PointerEvent): void => {
    if (event.button !== 0 || !event.isPrimary) return;
    event.preventDefault();
    focusPressed(event.currentTarget as HTMLElement);
    const [from, pixels] = [speedOf(end), (end === 'start' ? 1 : -1) * unit(end)];
    drag(event.currentTarget as HTMLElement, event, {
      onMove: (moved) => set(end, offeredSpeed(from + (moved.clientX - event.clientX) / pixels, mostOf(end))),
    });
  };

  const typed = (end: End, event: KeyboardEvent): void => {
    const speed = typedSpeed(event, speedOf(end), end, mostOf(end));
    if (speed === null) return;
    event.preventDefault();
    set(end, speed);
  };

  const handles = (['start', 'end'] as const).map((end) => {
    const { label, verb, neighbour } = SPEED_WORDS[end];
    const value = h('strong', { 'data-testid': `${end}-speed-value` });
    const grip = h('div', {
      class: 'grip',
      role: 'slider',
      tabindex: 0,
      'data-testid': `${end}-speed-handle`,
      'aria-label': label,
      'aria-orientation': 'horizontal',
      'aria-valuemin': 0,
      title: `${label}, relative to the straight speed from ${neighbour}. Drag it, or use the arrow keys; double-click for ${formatSpeed(DEFAULT_SPEED)}`,
      onpointerdown: (event: PointerEvent) => pressed(end, event),
      onkeydown: (event: KeyboardEvent) => typed(end, event),
      ondblclick: () => set(end, DEFAULT_SPEED),
    });
    const words = h('span', { class: 'words', 'aria-hidden': 'true' }, h('span', { class: 'verb' }, `${verb} `), value);
    return { end, grip, value, element: h('div', { class: `speed-handle ${end}` }, grip, words) };
  });
  const element = h(
    'div',
    { class: 'speed-lane', 'data-testid': 'speed-lane', hidden: true },
    ...handles.map((handle) => handle.element),
  );

  const draw = (): void => {
    if (!props) return;
    const { speeds, most, towards, range, window } = props;
    setHidden(element, speeds === null);
    if (!speeds) return;
    for (const { end, grip, value, element: handle } of handles) {
      const speed = speeds[end];
      const at = fractionIn(end === 'start' ? range[0] : range[1], window);
      const room = (end === 'start' ? at : 1 - at) * width;
      setHidden(handle, at < -1e-9 || at > 1 + 1e-9);
      setStyle(handle, 'left', `${(at * 100).toFixed(4)}%`);
      setStyle(handle, '--reach', `${(Math.min(Math.max(speed, 0), most[end]) * unit(end)).toFixed(2)}px`);
      setAttribute(handle, 'data-inside', room < (width < ROOM_FOR_WORDS_PX ? NUMBER_PX : WORDS_PX));
      setAttribute(grip, 'aria-valuemax', most[end]);
      setAttribute(grip, 'aria-valuenow', Number(speed.toFixed(6)));
      setAttribute(
        grip,
        'aria-valuetext',
        `${Number(speed.toFixed(2))} times the straight speed from ${towards?.[end] === 'shape' ? SHAPED[end] : SPEED_WORDS[end].neighbour}`,
      );
      setText(value, formatSpeed(speed));
    }
  };
  new ResizeObserver(() => {
    width = element.clientWidth;
    draw();
  }).observe(element);

  return {
    element,
    update(next) {
      props = next;
      draw();
    },
  };
}

/**
 * Left and right move the handle as it lies, up and down make it faster and slower; null where the key means nothing
 * here.
 */
export function typedSpeed(event: KeyboardEvent, speed: number, end: End, most: number): number | null {
  const step = event.shiftKey ? LARGE : 1;
  const inward = end === 'start' ? step : -step;
  const stepped = (steps: number): number => steppedSpeed(speed, steps, most);
  switch (event.key) {
    case 'ArrowRight':
      return stepped(inward);
    case 'ArrowLeft':
      return stepped(-inward);
    case 'ArrowUp':
      return stepped(step);
    case 'ArrowDown':
      return stepped(-step);
    case 'PageUp':
      return stepped(LARGE);
    case 'PageDown':
      return stepped(-LARGE);
    case 'Home':
      return 0;
    case 'End':
      return most;
    case 'Delete':
    case 'Backspace':
      return DEFAULT_SPEED;
    default:
      return null;
  }
}
