/** The first or second derivative of every shown curve, with its jumps at keys. */
import { clamp } from '../../model/time-scale.ts';
import { make } from '../../plots/svg-parts.ts';
import { extent, padded } from '../../plots/scale.ts';
import type { Derived, Shown } from '../derived.ts';
import { valueAt } from '../splines/curve.ts';
import type { Layer } from '../state.ts';
import { marksOf, shownSpan } from './curve-figure.ts';
import type { Part } from './figure.ts';
import { curveLines, pieces } from './lines.ts';
import { BOTTOM, TOP, axesOf, createPicture, listenToTime, timeAxes } from './plot.ts';
import type { Axes, Box } from './plot.ts';
import { LAYER_WORDS, number } from './words.ts';

const NAMES = { 1: 'Slope, the first derivative', 2: 'Bend, the second derivative' } as const;

export function createRateFigure(derivative: 1 | 2, onTime: (time: number) => void): Part<SVGSVGElement> {
  const picture = createPicture('rate-figure', (width) => clamp(width * 0.2, 110, 150), draw);
  const { element, update } = picture;
  element.setAttribute('role', 'img');
  listenToTime(picture, onTime);

  function draw(shown: Shown, box: Box): Axes {
    const { derived } = shown;
    const layers = shown.state.layers.filter((layer) => layer !== 'samples');
    const span = shownSpan(derived);
    const lengthOf = (numbers: readonly number[]): number =>
      numbers.length > 1 ? Math.hypot(...numbers) : numbers[0]!;
    const values = layers.flatMap((layer) =>
      pieces(derived.curves[layer], derivative, span[1]).flatMap((piece) =>
        piece.map(([, numbers]) => lengthOf(numbers)),
      ),
    );
    const axes = axesOf(box, span, padded(extent([0, ...values]), 0.12, 0.5));
    const { x, y } = axes;
    element.replaceChildren(
      ...timeAxes(box, axes, marksOf(shown)),
      ...picture.framed(
        layers.flatMap((layer) =>
          curveLines(layer, derived.curves[layer], derivative, span, (numbers, t) => [x(t), y(lengthOf(numbers))]),
        ),
      ),
      ...(derivative === 2 && layers.includes('linear') ? spikes(derived, axes, box) : []),
    );
    element.setAttribute('aria-label', describe(layers, derived, derivative));
    return axes;
  }

  return { element, update };
}

function describe(layers: readonly Layer[], derived: Derived, derivative: 1 | 2): string {
  const said = layers.map((layer) => {
    const jump = largestJump(derived, layer, derivative);
    const { name } = LAYER_WORDS[layer];
    if (derivative === 2 && layer === 'linear') return `${name}: an infinite spike at every corner`;
    return `${name}: ${jump > 1e-6 ? `jumps by up to ${number(jump)} at a key` : 'is continuous at every key'}`;
  });
  return `${NAMES[derivative]}. ${said.join('; ')}`;
}

/** Largest jump of a derivative at an inner key; in two dimensions, its length. */
export function largestJump({ curves, times }: Derived, layer: Layer, derivative: 1 | 2): number {
  if (layer === 'samples') return 0;
  const closest = 1e-9 * (times.at(-1)! - times[0]!);
  return Math.max(
    0,
    ...times
      .slice(1, -1)
      .map((t) =>
        Math.hypot(
          ...curves[layer].map(
            (curve) => valueAt(curve, t + closest, derivative) - valueAt(curve, t - closest, derivative),
          ),
        ),
      ),
  );
}

/** A corner has an infinite second derivative, drawn as an arrow that points up or down like the slope's jump. */
function spikes({ curves, times }: Derived, { x, y }: Axes, { height }: Box): SVGElement[] {
  const [curve] = curves.linear;
  return times.slice(1, -1).flatMap((t, i) => {
    const turn = valueAt(curve!, t, 1) - valueAt(curve!, times[i]!, 1);
    if (Math.abs(turn) < 1e-9) return [];
    const up = curves.linear.length > 1 || turn > 0;
    const tip = up ? TOP + 1 : height - BOTTOM - 1;
    const back = up ? 7 : -7;
    const d = `M${x(t).toFixed(1)} ${y(0).toFixed(1)}V${tip}m-4 ${back}l4 ${-back}l4 ${back}`;
    return [make('path', { class: 'curve linear spike', d })];
  });
}
