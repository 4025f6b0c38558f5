/** The motion's speed as a thin curve in the timeline's track; tinted where the motion overshoots a key. */
import type { Pace } from '../model/pace.ts';
import { pacePaths } from '../model/pace.ts';
import type { Range } from '../model/time-scale.ts';
import { memo, setAttribute, setHidden, svg } from './dom.ts';

export interface PaceLaneProps {
  pace: Pace | null;
  /** The range that the keys define. */
  range: Range;
  /** The stretch of time that is shown. */
  part: Range;
}

const WIDTH = 1000;
const HEIGHT = 100;

export function createPaceLane(): { element: SVGSVGElement; update(props: PaceLaneProps): void } {
  const area = svg('path', { class: 'pace-area' });
  const past = svg('path', { class: 'pace-past', 'data-testid': 'pace-past' });
  const line = svg('path', { class: 'pace-line', 'vector-effect': 'non-scaling-stroke' });
  const element = svg(
    'svg',
    {
      class: 'pace',
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
      'data-testid': 'pace',
      hidden: true,
    },
    area,
    past,
    line,
  );
  const update = memo(({ pace, range, part }: PaceLaneProps) => {
    const known = pace !== null && pace.mean > 0;
    setHidden(element, !known);
    if (!known) return;
    const paths = pacePaths(pace, { range, part, width: WIDTH, height: HEIGHT });
    setAttribute(area, 'd', paths.area);
    setAttribute(past, 'd', paths.past);
    setAttribute(line, 'd', paths.line);
  });
  return { element, update };
}
