/** The keys as handles: dragged, or moved with the arrow keys. */
import { make, text } from '../../plots/svg-parts.ts';
import type { PlayState } from '../state.ts';
import type { Axes } from './plot.ts';
import { LEFT, RIGHT } from './plot.ts';
import { number } from './words.ts';

export interface KeyHandleEvents {
  onSelect(key: number): void;
  /** `along`: the time, in two dimensions the second coordinate. */
  onMove(key: number, to: { along: number; value: number }): void;
  onAdd(): void;
  onRemove(key: number): void;
  /** A key is being dragged, or no longer. */
  onHold(holding: boolean): void;
}

export interface KeyHandles {
  element: SVGGElement;
  update(
    state: PlayState,
    times: readonly number[],
    points: readonly (readonly [number, number])[],
    axes: Axes,
    lit: number,
  ): void;
}

interface Shown {
  state: PlayState;
  times: readonly number[];
  axes: Axes;
}

/** Of what is shown in either direction: the step of an arrow key. */
const STEP = 1 / 100;

export function createKeyHandles(picture: SVGSVGElement, events: KeyHandleEvents): KeyHandles {
  const element = make('g', {});
  const handles: SVGGElement[] = [];
  let shown: Shown | null = null;
  /** Where key presses have moved a key before it is drawn there: the next one goes on from it. */
  let pressed: { key: number; along: number; value: number } | null = null;

  const where = (key: number): { along: number; value: number } => {
    const { state, times } = shown!;
    return { along: state.plane ? state.keys[key]!.across : times[key]!, value: state.keys[key]!.value };
  };
  const press = (key: number, event: KeyboardEvent): void => {
    if (event.key === 'Delete' || event.key === 'Backspace') {
      event.preventDefault();
      events.onRemove(key);
      return;
    }
    const by = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] }[event.key];
    if (!by || !shown) return;
    event.preventDefault();
    const scale = STEP * (event.shiftKey ? 10 : 1);
    const [sideways, up] = [shown.axes.x.domain, shown.axes.y.domain].map(([low, high]) => (high - low) * scale);
    const { along, value } = pressed?.key === key ? pressed : where(key);
    pressed = { key, along: along + by[0]! * sideways!, value: value + by[1]! * up! };
    events.onMove(key, pressed);
  };
  const drag = (key: number, start: PointerEvent): void => {
    if (start.button !== 0 || !shown) return;
    start.preventDefault();
    const handle = handles[key]!;
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(start.pointerId);
    events.onSelect(key);
    events.onHold(true);
    const from = where(key);
    const { x, y } = shown.axes;
    const perPixel = picture.viewBox.baseVal.width / picture.getBoundingClientRect().width;
    const span = picture.viewBox.baseVal.width - LEFT - RIGHT;
    const along = ((x.domain[1] - x.domain[0]) / span) * perPixel;
    const value = ((y.domain[1] - y.domain[0]) / (y(y.domain[0]) - y(y.domain[1]))) * perPixel;
    const move = (at: PointerEvent): void =>
      events.onMove(key, {
        along: from.along + (at.clientX - start.clientX) * along,
        value: from.value - (at.clientY - start.clientY) * value,
      });
    const end = (): void => {
      handle.removeEventListener('pointermove', move);
      for (const name of ENDS) handle.removeEventListener(name, end);
      events.onHold(false);
    };
    handle.addEventListener('pointermove', move);
    for (const name of ENDS) handle.addEventListener(name, end);
  };
  const create = (key: number): SVGGElement => {
    const handle = make('g', { class: 'key-handle', role: 'slider', tabindex: 0, 'data-testid': `key-${key}` });
    handle.append(
      make('circle', { class: 'key-reach', r: 20 }),
      make('circle', { class: 'key', r: 7 }),
      text('key-number', 0, -14, String(key + 1)),
    );
    handle.addEventListener('pointerdown', (event) => drag(key, event));
    handle.addEventListener('focus', () => events.onSelect(key));
    handle.addEventListener('keydown', (event) => press(key, event));
    return handle;
  };

  return {
    element,
    update(state, times, points, axes, lit) {
      pressed = null;
      shown = { state, times, axes };
      while (handles.length < points.length) element.append(handles[handles.push(create(handles.length)) - 1]!);
      while (handles.length > points.length) handles.pop()!.remove();
      points.forEach(([x, y], key) => {
        const handle = handles[key]!;
        const { value, across } = state.keys[key]!;
        const [low, high] = axes.y.domain;
        handle.setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
        handle.classList.toggle('selected', key === state.selected);
        handle.classList.toggle('lit', key === lit);
        const along = state.plane ? `and ${number(across)} across` : `at time ${number(times[key]!)}`;
        for (const [name, said] of Object.entries({
          'aria-label': `Key ${key + 1}`,
          'aria-orientation': 'vertical',
          'aria-valuemin': Math.min(low, value).toPrecision(4),
          'aria-valuemax': Math.max(high, value).toPrecision(4),
          'aria-valuenow': value.toPrecision(4),
          'aria-valuetext': `value ${number(value)} ${along}`,
        }))
          handle.setAttribute(name, said);
      });
    },
  };
}

const ENDS = ['pointerup', 'pointercancel'] as const;
