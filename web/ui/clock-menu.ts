/** Time settings: whole frames, playing range, and timeline zoom. */
import { button, checkbox, fieldRow, numberField, setIdle } from './controls.ts';
import type { KeysInfo } from '../engine/api/types.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setField, setText } from './dom.ts';
import type { IconName } from './icons.ts';
import { popover } from './popover.ts';
import type { Range, TimeScale } from '../model/time-scale.ts';
import { length } from '../model/time-scale.ts';
import { MAX_FPS, MIN_FPS, formatMoment, loopRange, ownRate, playRange } from '../model/frames.ts';
import { MAX_ZOOM, windowOf } from '../model/time-window.ts';

export interface ClockMenuProps extends TimeScale {
  time: number;
  fps: number | null;
  between: Range | null;
  window: Range | null;
  /** The open files, which may have a frame rate. */
  info: KeysInfo | null;
  disabled: boolean;
}

export interface ClockMenuEvents {
  onFps(fps: number | null): void;
  onLoopEnd(end: 'start' | 'end', t: number): void;
  onBetween(between: Range | null): void;
  /** Zooms about the playhead. */
  onZoom(factor: number): void;
  onWindow(window: Range | null): void;
}

const USUAL_FPS = 24;
const ZOOM_STEP = 2;

export function createClockMenu(events: ClockMenuEvents): Component<ClockMenuProps> & { toggle(): void } {
  const parts = [createFrames(events), createLoop(events), createZoom(events)];
  const panel = h(
    'div',
    { class: 'card popover', id: 'clock', 'data-testid': 'clock', hidden: true },
    ...parts.map((part) => part.element),
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
    for (const part of parts) part.update(props);
    const { fps, between, range, window, disabled } = props;
    toggle.disabled = disabled;
    setAttribute(toggle, 'data-on', fps !== null || loopRange(between, range) !== null || window !== null);
  });
  return { element, toggle: flip, update: draw };
}

/** Whole frames, and the frame rate. */
function createFrames({ onFps }: ClockMenuEvents): Component<ClockMenuProps> {
  let last = USUAL_FPS;
  let shown: KeysInfo | null = null;
  const snap = checkbox('Snap to frames', 'whole-frames', (on) => onFps(on ? last : null));
  const rate = numberField({
    label: 'Frames per second',
    testId: 'fps',
    min: MIN_FPS,
    max: MAX_FPS,
    onInput: (value) => onFps(value),
  });
  const hint = h('p', { class: 'hint' });
  const row = fieldRow(snap.element, h('span', { class: 'spacer' }), rate, h('span', { class: 'unit' }, 'fps'));
  return {
    element: h('div', { class: 'group' }, row, hint),
    update({ fps, info, disabled }) {
      if (info && info !== shown) last = ownRate(info) ?? USUAL_FPS;
      shown = info;
      if (fps !== null) last = fps;
      snap.update(fps !== null, disabled);
      setField(rate, String(Number(last.toFixed(3))));
      rate.disabled = fps === null;
      setText(
        hint,
        fps === null
          ? 'Plays as smoothly as the screen allows.'
          : 'Playback, the slider and exports snap to these frames; the time is shown as a frame number.',
      );
    },
  };
}

/** The playing range. */
function createLoop({ onLoopEnd, onBetween }: ClockMenuEvents): Component<ClockMenuProps> {
  let shown: ClockMenuProps | null = null;
  const seconds = (value: number): number => (shown?.fps ? value / shown.fps : value);
  const from = numberField({
    label: 'Playback start, in seconds or frames',
    testId: 'loop-from',
    onInput: (value) => onLoopEnd('start', seconds(value)),
  });
  const to = numberField({
    label: 'Playback end, in seconds or frames',
    testId: 'loop-to',
    onInput: (value) => onLoopEnd('end', seconds(value)),
  });
  const reset = button({
    label: 'Play the whole range',
    testId: 'loop-reset',
    icon: 'reset',
    shortcut: 'P',
    onClick: () => onBetween(null),
  });
  const here = (end: 'start' | 'end', text: string, shortcut: string): HTMLButtonElement =>
    button({
      label: text,
      testId: `loop-${end}-here`,
      text,
      shortcut,
      onClick: () => onLoopEnd(end, shown?.time ?? 0),
    });
  return {
    element: h(
      'div',
      { class: 'group' },
      fieldRow('Play', from, to, reset),
      h('div', { class: 'button-row' }, here('start', 'Set in', 'Ctrl+Home'), here('end', 'Set out', 'Ctrl+End')),
    ),
    update(props) {
      shown = props;
      const { range, between, fps } = props;
      const [start, end] = playRange(between, range);
      setField(from, formatMoment(start, range, fps));
      setField(to, formatMoment(end, range, fps));
      setIdle(reset, loopRange(between, range) === null);
    },
  };
}

/** The zoom of the timeline. */
function createZoom({ onZoom, onWindow }: ClockMenuEvents): Component<ClockMenuProps> {
  const zoomBy = (factor: number, testId: string, icon: IconName, shortcut: string, label: string): HTMLButtonElement =>
    button({ label, testId, icon, shortcut, kind: 'plain', onClick: () => onZoom(factor) });
  const nearer = zoomBy(ZOOM_STEP, 'zoom-in', 'plus', '+', 'Zoom in on the timeline');
  const farther = zoomBy(1 / ZOOM_STEP, 'zoom-out', 'minus', '-', 'Zoom out of the timeline');
  const whole = button({
    label: 'Show the whole timeline',
    testId: 'zoom-fit',
    text: 'Fit',
    shortcut: '0',
    onClick: () => onWindow(null),
  });
  const zoom = h('span', { class: 'label', 'data-testid': 'zoom' });
  return {
    element: fieldRow(zoom, farther, nearer, whole),
    update(props) {
      const times = length(props.whole) / length(windowOf(props.window, props));
      setText(zoom, `Zoom ${times < 9.95 ? Number(times.toFixed(1)) : Math.round(times)}×`);
      farther.disabled = whole.disabled = props.window === null;
      nearer.disabled = times >= MAX_ZOOM * (1 - 1e-9);
    },
  };
}
