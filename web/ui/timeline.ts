/**
 * The time slider: a solid range for the keys, hatched margins for extrapolation, draggable key marks that the playhead
 * snaps to, and two handles for the playing range. It zooms around the pointer. A curve in the track shows the speed;
 * an image above it shows the shape at the time under the mouse. A ruler counts seconds or whole frames. Handles below
 * it set the end speeds, if the boundary has them.
 */
import { h, setAttribute } from './dom.ts';
import type { End } from '../model/speeds.ts';
import type { Range } from '../model/time-scale.ts';
import { clamp, clampTime, length } from '../model/time-scale.ts';
import { loopRange, snappedTime } from '../model/frames.ts';
import { panned, revealing, timeIn, windowOf, zoomed } from '../model/time-window.ts';
import type { KeyTicksEvents } from './key-ticks.ts';
import { createLoopHandles } from './loop-handles.ts';
import { createOverview } from './overview.ts';
import { drag, focusPressed, isPress, listenToGestures } from './pointer.ts';
import type { SpeedHandlesProps } from './speed-handles.ts';
import { createSpeedHandles } from './speed-handles.ts';
import { createHoverPreview } from './hover-preview.ts';
import type { TimeSliderProps } from './time-slider.ts';
import { createTimeSlider } from './time-slider.ts';

/** Pixels within which the playhead snaps to a key. */
const SNAP_PX = 7;

export interface TimelineProps extends TimeSliderProps {
  playing: boolean;
  /** The visible window; null: the whole. */
  window: Range | null;
  /** Hermite: speeds at the first and the last key; null for another boundary. */
  speeds: SpeedHandlesProps['speeds'];
  /** The largest offered end speeds. */
  maxSpeeds: SpeedHandlesProps['max'];
  towards: SpeedHandlesProps['towards'];
  /** URL of the image at the last time under the mouse; null if there is none of this motion. */
  picture: string | null;
}

export interface TimelineEvents extends KeyTicksEvents {
  onBetween(between: Range | null): void;
  onWindow(window: Range | null): void;
  onSpeed(end: End, speed: number): void;
  /** Requests an image at this time; null cancels it. */
  onPeek(t: number | null): void;
}

export interface Timeline {
  element: HTMLElement;
  /** The element with role=slider, which takes keyboard focus. */
  slider: HTMLElement;
  update(props: TimelineProps): void;
  /** The time of a drop position, rounded to whole frames if there are any; null elsewhere. */
  timeAt(point: { x: number; y: number }): number | null;
}

export function createTimeline(events: TimelineEvents): Timeline {
  let props: TimelineProps | null = null;
  const slider = createTimeSlider(events);
  const { track } = slider;
  const isOn = (): boolean => props !== null && !props.disabled;
  const shown = (): Range => windowOf(props!.window, props!);
  // Several events can arrive before the page is redrawn. Each continues from the last requested value.
  const setWindow = (window: Range | null): void => {
    if (props) props = { ...props, window };
    events.onWindow(window);
  };
  const timeAt = (x: number): number => {
    const box = track.getBoundingClientRect();
    return timeIn(clamp((x - box.left) / box.width, 0, 1), shown());
  };
  const droppedAt = ({ x, y }: { x: number; y: number }): number | null => {
    const { left, right, top, bottom } = track.getBoundingClientRect();
    if (!isOn() || x < left || x > right || y < top || y > bottom) return null;
    return snappedTime(timeAt(x), [], 0, props!.fps);
  };
  const perPixel = (): number => length(shown()) / track.clientWidth;
  const snapped = (t: number, free: boolean): number => {
    const times = props!.keys.map(({ time }) => time);
    return free ? t : snappedTime(t, times, SNAP_PX * perPixel(), props!.fps);
  };
  const pointedAt = (event: PointerEvent): number => snapped(timeAt(event.clientX), event.altKey);

  const handles = createLoopHandles(track, { onBetween: events.onBetween, snapped });
  const overview = createOverview(setWindow);
  const speedHandles = createSpeedHandles(events.onSpeed);
  const controls = [slider.element, ...handles.elements, speedHandles.element, overview.element];
  const element = h('div', { class: 'time-frame' }, ...controls);
  const preview = createHoverPreview({
    over: slider.element,
    frame: element,
    timeAt: (event) => (isOn() ? pointedAt(event) : null),
    onPeek: events.onPeek,
  });
  element.append(preview.element);

  slider.element.addEventListener('pointerdown', (event) => {
    if (!isOn() || !isPress(event)) return;
    event.preventDefault();
    focusPressed(slider.element);
    // Keys handle their own dragging.
    if ((event.target as Element).closest('.tick')) return;
    const seek = (at: PointerEvent): void => events.onSeek(pointedAt(at));
    drag(slider.element, event, { onMove: seek });
    seek(event);
  });
  listenToGestures(element, {
    onZoom: (factor, x) => {
      if (isOn()) setWindow(zoomed(shown(), props!, factor, timeAt(x)));
    },
    onPan: (pixels) => {
      if (isOn()) setWindow(panned(shown(), props!, -pixels * perPixel()));
    },
  });

  return {
    element,
    slider: slider.element,
    timeAt: droppedAt,
    update(next) {
      const last = props;
      props = next;
      const { range, whole, disabled, fps, speeds, towards, speedCurve, picture } = next;
      const part = shown();
      slider.update(next, part);
      setAttribute(element, 'data-zoomed', length(part) < length(whole));
      overview.update(next, part);
      handles.update({ range, window: part, between: loopRange(next.between, range), fps, disabled });
      speedHandles.update({ speeds, max: next.maxSpeeds, towards, range, window: part });
      preview.update({ speedCurve, range, fps, picture });
      if (last && losesPlayhead(last, next)) events.onWindow(revealing(part, next, clampTime(next.time, range)));
    },
  };
}

/** Keeps the playhead visible, unless the user has panned away during playback. */
function losesPlayhead(last: TimelineProps, next: TimelineProps): boolean {
  if (next.window === null || last.time === next.time || next.window !== last.window) return false;
  const [start, end] = windowOf(next.window, next);
  const sees = (t: number): boolean => t >= start && t <= end;
  return !sees(next.time) && (sees(last.time) || !next.playing);
}
