/**
 * The Hermite speeds as handles below the first and last key of the timeline. A longer handle means a faster start or
 * end of the motion. Drag handles or move them with the arrow keys.
 */
import { positionAtTime } from './timeline-position.ts';
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import type { Range } from '../model/time-scale.ts';
import { clamp, length } from '../model/time-scale.ts';
import type { End, Speeds } from '../model/speeds.ts';
import { DEFAULT_SPEED, MAX_SPEED, formatSpeed, offeredSpeed, steppedSpeed } from '../model/speeds.ts';
import type { Towards } from '../model/state.ts';
import { fractionIn } from '../model/time-window.ts';
import { drag, focusPressed, isPress } from './pointer.ts';

/** Length of a handle at speed 1 in pixels, if there is room. */
const UNIT_PX = 40;
/** Width in pixels of the number beside a handle, and of the text if the style sheet shows it. */
const NUMBER_PX = 56;
const WORDS_PX = 112;
const ROOM_FOR_WORDS_PX = 480;
/** Text for a tangent given by a pose. */
const SHAPED: Record<End, string> = {
  start: 'the first key to the start tangent pose',
  end: 'the end tangent pose to the last key',
};
/** Number of steps with Shift. */
const LARGE = 10;

export const SPEED_WORDS: Record<End, { label: string; verb: string; neighbour: string }> = {
  start: { label: 'Start speed', verb: 'leaves at', neighbour: 'the first key to the second' },
  end: { label: 'End speed', verb: 'arrives at', neighbour: 'the second to last key to the last' },
};

export interface SpeedHandlesProps {
  /** End speeds; null if the boundary has none. */
  speeds: Speeds | null;
  /** The largest offered speeds. */
  max: Speeds;
  /** Targets of the end tangents; null if the boundary has no speeds. */
  towards: Readonly<Record<End, Towards>> | null;
  /** Times of the first and the last key. */
  range: Range;
  window: Range;
}

export type SpeedHandles = Component<SpeedHandlesProps>;

export function createSpeedHandles(onSpeed: (end: End, speed: number) => void): SpeedHandles {
  let props: SpeedHandlesProps | null = null;
  const handles = (['start', 'end'] as const).map((end) => createSpeedHandle(end, (speed) => onSpeed(end, speed)));
  const element = h(
    'div',
    { class: 'speed-lane', 'data-testid': 'speed-lane', hidden: true },
    ...handles.map((handle) => handle.element),
  );
  let width = 0;
  const draw = (): void => {
    if (!props) return;
    const { speeds } = props;
    setHidden(element, speeds === null);
    if (speeds) for (const handle of handles) handle.update({ ...props, speeds, width });
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

interface SpeedHandleProps extends SpeedHandlesProps {
  speeds: Speeds;
  /** Width of the timeline, in pixels. */
  width: number;
}

/** Pixels per unit of speed. At their longest, the handles are equally long and do not meet. */
function unitOf(end: End, { max, range, window, width }: SpeedHandleProps): number {
  const room = ((length(range) / length(window)) * width) / (2 * MAX_SPEED + 1);
  return (Math.min(UNIT_PX, room) * MAX_SPEED) / max[end];
}

function createSpeedHandle(end: End, onSpeed: (speed: number) => void): Component<SpeedHandleProps> {
  let props: SpeedHandleProps | null = null;
  // Several events can arrive before the page is redrawn. Each continues from the last requested value.
  const set = (speed: number): void => {
    if (props) props = { ...props, speeds: { ...props.speeds, [end]: speed } };
    onSpeed(speed);
  };
  const pressed = (event: PointerEvent): void => {
    if (!props || !isPress(event)) return;
    event.preventDefault();
    focusPressed(grip);
    const [from, max] = [props.speeds[end], props.max[end]];
    const pixels = (end === 'start' ? 1 : -1) * unitOf(end, props);
    drag(grip, event, {
      onMove: (moved) => set(offeredSpeed(from + (moved.clientX - event.clientX) / pixels, max)),
    });
  };
  const typed = (event: KeyboardEvent): void => {
    const speed = props && typedSpeed(event, props.speeds[end], end, props.max[end]);
    if (speed === null) return;
    event.preventDefault();
    set(speed);
  };

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
    title: `${label}, relative to the constant speed from ${neighbour}. Drag it, or use the arrow keys; double-click for ${formatSpeed(DEFAULT_SPEED)}`,
    onpointerdown: pressed,
    onkeydown: typed,
    ondblclick: () => set(DEFAULT_SPEED),
  });
  const words = h('span', { class: 'words', 'aria-hidden': 'true' }, h('span', { class: 'verb' }, `${verb} `), value);
  const element = h('div', { class: `speed-handle ${end}` }, grip, words);
  return {
    element,
    update(next) {
      props = next;
      const { speeds, max, towards, range, window, width } = next;
      const speed = speeds[end];
      const t = end === 'start' ? range[0] : range[1];
      const at = fractionIn(t, window);
      const room = (end === 'start' ? at : 1 - at) * width;
      positionAtTime(element, t, window);
      setStyle(element, '--reach', `${(clamp(speed, 0, max[end]) * unitOf(end, next)).toFixed(2)}px`);
      setAttribute(element, 'data-inside', room < (width < ROOM_FOR_WORDS_PX ? NUMBER_PX : WORDS_PX));
      setAttribute(grip, 'aria-valuemax', max[end]);
      setAttribute(grip, 'aria-valuenow', Number(speed.toFixed(6)));
      const from = towards?.[end] === 'shape' ? SHAPED[end] : neighbour;
      setAttribute(grip, 'aria-valuetext', `${Number(speed.toFixed(2))} times the constant speed from ${from}`);
      setText(value, formatSpeed(speed));
    },
  };
}

/**
 * Left and right move the handle in its direction, up and down increase and decrease the speed; null for other keys.
 */
export function typedSpeed(event: KeyboardEvent, speed: number, end: End, max: number): number | null {
  const step = event.shiftKey ? LARGE : 1;
  const inward = end === 'start' ? step : -step;
  const stepped = (steps: number): number => steppedSpeed(speed, steps, max);
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
      return max;
    case 'Delete':
    case 'Backspace':
      return DEFAULT_SPEED;
    default:
      return null;
  }
}
