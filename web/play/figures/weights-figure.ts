/** The weights of the keys over time: the curve at t is the sum of w_k(t) times key k. */
import { clamp } from '../../model/time-scale.ts';
import { make, text } from '../../plots/svg-parts.ts';
import { extent, padded } from '../../plots/scale.ts';
import type { Shown } from '../derived.ts';
import { valueAt } from '../splines/curve.ts';
import { marksOf, shownSpan } from './curve-figure.ts';
import type { Part } from './figure.ts';
import { curveLines, pieces } from './lines.ts';
import { axesOf, createPicture, listenToTime, timeAxes } from './plot.ts';
import type { Axes, Box } from './plot.ts';
import { number } from './words.ts';

export function createWeightsFigure(onTime: (time: number) => void): Part<SVGSVGElement> {
  const picture = createPicture('weights-figure', (width) => clamp(width * 0.24, 130, 180), draw);
  const { element, update } = picture;
  element.setAttribute('role', 'img');
  listenToTime(picture, onTime);

  function draw(shown: Shown, box: Box): Axes {
    const { state, derived, lit } = shown;
    const span = shownSpan(derived);
    const { weights } = derived;
    const values = weights.flatMap((weight) =>
      pieces([weight], 0, derived.range[1]).flatMap((piece) => piece.map(([, [w]]) => w!)),
    );
    const axes = axesOf(box, span, padded(extent([0, 1, ...values]), 0.1));
    const { x, y } = axes;
    const main = lit < 0 ? state.selected : lit;
    // The highlighted weight is drawn last, over the others.
    const order = weights.map((_, k) => k).sort((a, b) => Number(a === main) - Number(b === main));
    element.replaceChildren(
      ...timeAxes(box, axes, { ...marksOf(shown), selected: main }),
      ...picture.framed(
        order.map((k) => {
          const group = make('g', { class: k === main ? 'weight lit' : 'weight' });
          group.append(
            ...curveLines(state.ends, [weights[k]!], 0, span, ([w], t) => [x(t), y(w!)]),
            make('circle', {
              class: 'now-mark',
              cx: x(state.time),
              cy: y(valueAt(weights[k]!, state.time)),
              r: k === main ? 4.5 : 3,
            }),
          );
          return group;
        }),
      ),
      ...weights.map((_, k) =>
        text(k === main ? 'weight-name lit' : 'weight-name', x(derived.times[k]!), y(1) - 7, `w${k + 1}`),
      ),
    );
    const sum = weights.map((weight, k) => `${number(valueAt(weight, state.time))} times key ${k + 1}`).join(', ');
    element.setAttribute('aria-label', `Weights of the keys over time. At time ${number(state.time)}: ${sum}`);
    return axes;
  }

  return { element, update };
}
