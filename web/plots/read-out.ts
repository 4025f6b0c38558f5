/** The values of all curves at one time of a chart: a vertical line, a dot per curve, and the numbers. */
import { make, text } from './svg-parts.ts';
import type { LineChartData } from './line-chart.ts';
import { tickLabel } from './scale.ts';

/** Area for the text, in the chart's units. */
export interface Room {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export interface ReadOut {
  element: SVGGElement;
  /** Shows the chart's time nearest to `t`; null hides it. `x` and `y` give positions in the plot, NaN outside. */
  show(data: LineChartData, t: number | null, x: (t: number) => number, y: (value?: number) => number): void;
}

const LINE = 12;
const PAD = 5;
const SAMPLE = 12;
/** With more curves than this, only the topmost are shown. */
const MAX_CURVES = 6;

export function createReadOut(room: Room): ReadOut {
  const element = make('g', { class: 'read-out', 'aria-hidden': 'true' });
  return {
    element,
    show(data, t, x, y) {
      element.replaceChildren();
      if (t === null || data.times.length === 0) return;
      const at = nearest(data.times, t);
      const time = data.times[at]!;
      const place = x(time);
      const curves = data.series.filter(({ values }) => Number.isFinite(values[at])).slice(-MAX_CURVES);
      const words = make('g', {});
      words.append(text('read-time', PAD, LINE, `${Number(time.toFixed(3))} s`));
      curves.forEach(({ label, values, style }, index) => {
        const base = LINE * (index + 2);
        words.append(
          make('line', { class: `read-line ${style}`, x1: PAD, x2: PAD + SAMPLE, y1: base - 3.5, y2: base - 3.5 }),
          text('read-value', PAD + SAMPLE + 4, base, `${label} ${tickLabel(values[at]!)}${signOf(data.unit)}`),
        );
      });
      element.append(make('line', { class: 'read-at', x1: place, x2: place, y1: room.top, y2: room.bottom }));
      for (const { values, style } of curves) {
        const height = y(values[at]);
        if (Number.isFinite(height))
          element.append(make('circle', { class: `read-dot ${style}`, cx: place, cy: height, r: 3 }));
      }
      const box = make('rect', { class: 'read-ground', rx: 3 });
      const card = make('g', {});
      card.append(box, words);
      element.append(card);
      const { width } = words.getBBox();
      const size = { width: width + 2 * PAD, height: LINE * (curves.length + 1) + PAD };
      box.setAttribute('width', String(size.width));
      box.setAttribute('height', String(size.height));
      // The text is beside the line, on the side with more room.
      const isRight = place - room.left < room.right - place;
      const from = isRight ? place + PAD : place - PAD - size.width;
      const kept = Math.min(Math.max(from, room.left), Math.max(room.right - size.width, room.left));
      card.setAttribute('transform', `translate(${kept.toFixed(2)} ${room.top})`);
    },
  };
}

function nearest(times: readonly number[], t: number): number {
  return times.reduce((best, time, index) => (Math.abs(time - t) < Math.abs(times[best]! - t) ? index : best), 0);
}

/** Unit symbol after a number. */
function signOf(unit: string): string {
  if (unit.includes('%')) return '\u00a0%';
  return unit.includes('degrees') ? '°' : '';
}
