/** The slider part of the timeline: track with keys, ruler, and playhead. */
import { momentWords } from '../model/frames.ts';
import type { Phase, Range, TimeScale } from '../model/time-scale.ts';
import { clampTime } from '../model/time-scale.ts';
import { positionAtTime } from './timeline-position.ts';
import { h, setAttribute } from './dom.ts';
import type { KeyTicksEvents, KeyTicksProps } from './key-ticks.ts';
import { createKeyTicks } from './key-ticks.ts';
import { createTimeRuler } from './time-ruler.ts';
import type { TimeTrackProps } from './time-track.ts';
import { createTimeTrack } from './time-track.ts';

export interface TimeSliderProps
  extends TimeScale,
    Omit<TimeTrackProps, 'part'>,
    Omit<KeyTicksProps, 'part' | 'width'> {
  time: number;
  phase: Phase;
}

export interface TimeSlider {
  element: HTMLElement;
  /** The track, over the range of the window. */
  track: HTMLElement;
  /** `part`: the visible range of time. */
  update(props: TimeSliderProps, part: Range): void;
}

export function createTimeSlider(events: KeyTicksEvents): TimeSlider {
  let shown: [TimeSliderProps, Range] | null = null;
  let width = 0;
  const track = createTimeTrack();
  const ruler = createTimeRuler();
  const ticks = createKeyTicks(events);
  const playhead = h('div', { class: 'playhead', 'aria-hidden': 'true' }, h('div', { class: 'knob' }));
  const element = h(
    'div',
    {
      class: 'timeline',
      role: 'slider',
      tabindex: 0,
      'aria-label': 'Time',
      'aria-orientation': 'horizontal',
      'data-testid': 'timeline',
      title:
        'Drag to change the time, even past both ends (arrow keys step; Alt: without snapping; the wheel zooms). ' +
        'The curve shows the speed of the motion; yellow below it marks overshoot',
    },
    track.element,
    ruler.element,
    ticks.element,
    playhead,
  );

  const update = (props: TimeSliderProps, part: Range): void => {
    shown = [props, part];
    const { range, whole, keys, time, phase, periodic, disabled, fps, between, speedCurve } = props;
    track.update({ range, part, between, periodic, speedCurve });
    ticks.update({ keys, range, part, fps, width, disabled });
    ruler.update({ part, fps, width }, disabled ? null : time);
    positionAtTime(playhead, disabled ? null : clampTime(time, range), part);
    setAttribute(element, 'aria-valuemin', round(Math.min(whole[0], part[0])));
    setAttribute(element, 'aria-valuemax', round(Math.max(whole[1], part[1])));
    setAttribute(element, 'aria-valuenow', round(time));
    setAttribute(element, 'aria-valuetext', `${momentWords(time, range, fps)}, ${phase.text}`);
    setAttribute(element, 'aria-disabled', disabled ? 'true' : null);
    setAttribute(element, 'data-periodic', periodic);
    setAttribute(element, 'data-phase', phase.kind);
  };
  new ResizeObserver(() => {
    width = track.element.clientWidth;
    if (shown) update(...shown);
  }).observe(track.element);
  return { element, track: track.element, update };
}

function round(value: number): number {
  return Number(value.toFixed(6));
}
