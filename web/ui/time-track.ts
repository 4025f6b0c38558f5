/** The timeline's track: the keys' range between its margins, the part that is not played, and the speed. */
import { loopRange } from '../model/frames.ts';
import type { SpeedCurve } from '../model/speed-curve.ts';
import type { Range } from '../model/time-scale.ts';
import { stretch } from './timeline-position.ts';
import { h, memo, setAttribute, setText } from './dom.ts';
import { createSpeedCurve } from './speed-curve.ts';

export interface TimeTrackProps {
  range: Range;
  /** The visible range of time. */
  part: Range;
  /** The playing range; null: the range of the keys. */
  between: Range | null;
  periodic: boolean;
  /** The speed curve; null if not known yet. */
  speedCurve: SpeedCurve | null;
}

export function createTimeTrack(): { element: HTMLElement; update(props: TimeTrackProps): void } {
  const before = createMargin('before');
  const after = createMargin('after');
  const keyRange = h('div', { class: 'key-range' });
  const silent = [h('div', { class: 'silent' }), h('div', { class: 'silent' })] as const;
  const lane = createSpeedCurve();
  const element = h('div', { class: 'track', 'aria-hidden': 'true' }, before.element, keyRange, after.element);
  element.append(lane.element, ...silent);

  const draw = memo(({ range, part, between, periodic }: Omit<TimeTrackProps, 'speedCurve'>) => {
    const [start, end] = loopRange(between, range) ?? part;
    stretch(before.element, [part[0], range[0]], part);
    stretch(keyRange, range, part);
    stretch(after.element, [range[1], part[1]], part);
    stretch(silent[0], [part[0], start], part);
    stretch(silent[1], [end, part[1]], part);
    before.label(periodic ? REPEATS : ['Before the first key (extrapolated)', 'Extrapolated', 'Before']);
    after.label(periodic ? REPEATS : ['Beyond the last key (extrapolated)', 'Extrapolated', 'Beyond']);
  });
  return {
    element,
    update({ speedCurve, ...props }) {
      draw(props);
      lane.update({ speedCurve, range: props.range, part: props.part });
    },
  };
}

/** Texts for a margin from longest to shortest. The style sheet shows the longest that fits. */
type MarginWords = readonly [string, string, string];
const REPEATS: MarginWords = ['Repeats', 'Repeats', 'Repeats'];

function createMargin(side: 'before' | 'after'): { element: HTMLElement; label(words: MarginWords): void } {
  const labels = ['long', 'middle', 'short'].map((size) => h('span', { class: `margin-label ${size}` }));
  const element = h('div', { class: `margin ${side}` }, ...labels);
  return {
    element,
    label(words) {
      labels.forEach((label, index) => setText(label, words[index]!));
      setAttribute(element, 'title', words[0]);
    },
  };
}
