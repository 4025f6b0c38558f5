/** The numbers under the timeline: seconds, or whole frames. */
import type { Range } from '../model/time-scale.ts';
import { fractionIn, rulerMarks } from '../model/time-window.ts';
import { positionAtTime } from './timeline-position.ts';
import { h, memo, setAttribute } from './dom.ts';

/** Width of a number in pixels. */
const NUMBER_PX = 72;
/** A number closer than this to the knob's centre, in pixels, is hidden. */
const COVERED_PX = 26;

export interface TimeRulerProps {
  part: Range;
  fps: number | null;
  /** Width of the ruler, in pixels. */
  width: number;
}

/** `knob`: position of the playhead; null if not visible. */
export function createTimeRuler(): { element: HTMLElement; update(props: TimeRulerProps, knob: number | null): void } {
  const element = h('div', { class: 'ruler', 'aria-hidden': 'true' });
  let times: number[] = [];
  const draw = memo(({ part, fps, width }: TimeRulerProps) => {
    const marks = width > 0 ? rulerMarks(part, fps, width / NUMBER_PX) : [];
    times = marks.map(({ time }) => time);
    element.replaceChildren(
      ...marks.map(({ time, text }) => {
        const mark = h('span', { class: 'mark' }, text);
        positionAtTime(mark, time, part);
        return mark;
      }),
    );
  });
  return {
    element,
    update(props, knob) {
      draw(props);
      if (knob === null) return;
      const x = (time: number): number => fractionIn(time, props.part) * props.width;
      // Hide a number that the playhead's knob partly covers.
      times.forEach((time, index) =>
        setAttribute(element.children[index]!, 'data-covered', Math.abs(x(time) - x(knob)) < COVERED_PX),
      );
    },
  };
}
