/** What an animator sets about the time: whole frames, where playing starts and ends, how near the timeline is seen. */
import { button, checkbox, numberField } from './controls.ts';
import { h, memo, setAttribute, setField, setText } from './dom.ts';
import { popover } from './popover.ts';
import type { Range, TimeScale } from '../model/time-scale.ts';
import { length } from '../model/time-scale.ts';
import { MAX_FPS, MIN_FPS, formatMoment, loopRange, playRange } from '../model/frames.ts';
import { MAX_ZOOM, windowOf } from '../model/time-window.ts';

export interface ClockMenuProps extends TimeScale {
  time: number;
  fps: number | null;
  between: Range | null;
  window: Range | null;
  disabled: boolean;
}

export interface ClockMenuEvents {
  onFps(fps: number | null): void;
  onLoopEnd(end: 'start' | 'end', t: number): void;
  onBetween(between: Range | null): void;
  /** About the playhead. */
  onZoom(factor: number): void;
  onWindow(window: Range | null): void;
}

const USUAL_FPS = 24;
const ZOOM_STEP = 2;

export function createClockMenu(events: ClockMenuEvents): {
  element: HTMLElement;
  toggle(): void;
  update(props: ClockMenuProps): void;
} {
  let shown: ClockMenuProps | null = null;
  let lastFps = USUAL_FPS;
  const seconds = (value: number): number => (shown?.fps ? value / shown.fps : value);

  const frames = checkbox('Snap to frames', 'whole-frames', (on) => events.onFps(on ? lastFps : null));
  const fps = numberField({
    label: 'Frames per second',
    testId: 'fps',
    min: MIN_FPS,
    max: MAX_FPS,
    onInput: (value) => events.onFps(value),
  });
  const fpsHint = h('p', { class: 'hint' });
  const from = numberField({
    label: 'Playback start, in seconds or frames',
    testId: 'loop-from',
    onInput: (value) => events.onLoopEnd('start', seconds(value)),
  });
  const to = numberField({
    label: 'Playback end, in seconds or frames',
    testId: 'loop-to',
    onInput: (value) => events.onLoopEnd('end', seconds(value)),
  });
  const reset = button({
    label: 'Play the whole range',
    testId: 'loop-reset',
    icon: 'reset',
    shortcut: 'P',
    onClick: () => events.onBetween(null),
  });
  const here = (end: 'start' | 'end', text: string, key: string): HTMLButtonElement =>
    button({
      label: text,
      testId: `loop-${end}-here`,
      text,
      shortcut: key,
      onClick: () => events.onLoopEnd(end, shown?.time ?? 0),
    });
  const nearer = button({
    label: 'Zoom into the timeline',
    testId: 'zoom-in',
    icon: 'plus',
    shortcut: '+',
    kind: 'plain',
    onClick: () => events.onZoom(ZOOM_STEP),
  });
  const farther = button({
    label: 'Zoom out of the timeline',
    testId: 'zoom-out',
    icon: 'minus',
    shortcut: '-',
    kind: 'plain',
    onClick: () => events.onZoom(1 / ZOOM_STEP),
  });
  const whole = button({
    label: 'Show the whole timeline',
    testId: 'zoom-fit',
    text: 'Fit',
    shortcut: '0',
    onClick: () => events.onWindow(null),
  });
  const zoom = h('span', { class: 'label', 'data-testid': 'zoom' });

  const panel = h(
    'div',
    { class: 'card popover', id: 'clock', 'data-testid': 'clock', hidden: true },
    h(
      'div',
      { class: 'group' },
      h(
        'div',
        { class: 'field row' },
        frames.element,
        h('span', { class: 'spacer' }),
        fps,
        h('span', { class: 'unit' }, 'fps'),
      ),
      fpsHint,
    ),
    h(
      'div',
      { class: 'group' },
      h('div', { class: 'field row' }, h('span', { class: 'label' }, 'Play'), from, to, reset),
      h('div', { class: 'button-row' }, here('start', 'Set in', 'Ctrl+Home'), here('end', 'Set out', 'Ctrl+End')),
    ),
    h('div', { class: 'field row' }, zoom, farther, nearer, whole),
  );
  const toggle = button({
    label: 'Frames, loop and zoom',
    testId: 'clock-toggle',
    icon: 'clock',
    shortcut: 'T',
    onClick: () => flip(),
  });
  const element = h('div', { class: 'clock-menu' }, panel, toggle);
  const flip = popover(element, toggle, panel);

  const draw = memo((props: ClockMenuProps) => {
    shown = props;
    const { range, between, window, disabled } = props;
    if (props.fps !== null) lastFps = props.fps;
    frames.update(props.fps !== null, disabled);
    setField(fps, String(Number(lastFps.toFixed(3))));
    fps.disabled = props.fps === null;
    setText(
      fpsHint,
      props.fps === null
        ? 'Plays as smoothly as the screen allows.'
        : 'Playback, the slider and exports snap to these frames; the time is shown as a frame number.',
    );
    const [start, end] = playRange(between, range);
    setField(from, formatMoment(start, range, props.fps));
    setField(to, formatMoment(end, range, props.fps));
    const looped = loopRange(between, range) !== null;
    reset.disabled = !looped;
    setAttribute(reset, 'data-idle', !looped);
    const times = length(props.whole) / length(windowOf(window, props));
    setText(zoom, `Zoom ${times < 9.95 ? Number(times.toFixed(1)) : Math.round(times)}×`);
    farther.disabled = whole.disabled = window === null;
    nearer.disabled = times >= MAX_ZOOM * (1 - 1e-9);
    toggle.disabled = disabled;
    setAttribute(toggle, 'data-on', props.fps !== null || looped || window !== null);
  });
  return { element, toggle: flip, update: draw };
}
