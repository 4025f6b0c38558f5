/** The motion's speed as a thin curve in the timeline's track, tinted where the motion overshoots a key. */
import type { SpeedCurve } from '../model/speed-curve.ts';
import { speedPaths } from '../model/speed-curve.ts';
import type { Range } from '../model/time-scale.ts';
import { memo, setAttribute, setHidden, svg } from './dom.ts';

export interface SpeedCurveProps {
  speedCurve: SpeedCurve | null;
  /** The range of the keys. */
  range: Range;
  /** The visible range of time. */
  part: Range;
}

const WIDTH = 1000;
const HEIGHT = 100;

export function createSpeedCurve(): { element: SVGSVGElement; update(props: SpeedCurveProps): void } {
  const area = svg('path', { class: 'speed-area' });
  const past = svg('path', { class: 'speed-past', 'data-testid': 'speed-past' });
  const line = svg('path', { class: 'speed-line', 'vector-effect': 'non-scaling-stroke' });
  const element = svg(
    'svg',
    {
      class: 'speed-curve',
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
      'data-testid': 'speed-curve',
      hidden: true,
    },
    area,
    past,
    line,
  );
  const update = memo(({ speedCurve: curve, range, part }: SpeedCurveProps) => {
    const known = curve !== null && curve.mean > 0;
    setHidden(element, !known);
    if (!known) return;
    const paths = speedPaths(curve, { range, part, width: WIDTH, height: HEIGHT });
    setAttribute(area, 'd', paths.area);
    setAttribute(past, 'd', paths.past);
    setAttribute(line, 'd', paths.line);
  });
  return { element, update };
}
