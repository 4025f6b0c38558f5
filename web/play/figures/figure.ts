/** Frame of a figure: plot, title, a sentence on the last change, numbers and files. */
import { csvOf, pngOf, svgOf } from '../../plots/plot-files.ts';
import type { Heading } from '../../plots/plot-files.ts';
import { h, setText } from '../../ui/dom.ts';
import { saveButtons, valuesFrame, valuesTable } from '../../ui/values.ts';
import type { NumbersTable } from '../../ui/values.ts';
import { axesOf, unitsOf } from '../captions.ts';
import type { FigureId } from '../captions.ts';
import type { Shown } from '../derived.ts';
import type { Panel } from '../panels.ts';
import { number } from './words.ts';

/** A part of a figure that displays the shown state. */
export interface Part<E extends Element> {
  element: E;
  update(shown: Shown): void;
}

export interface FigureOptions {
  /** The figure's id in test ids and file names. */
  id: FigureId;
  title: string;
  body: Part<HTMLElement | SVGSVGElement>;
  /** Controls between title and plot. */
  tools?: Panel;
  /** Returns one or two sentences. */
  notice(shown: Shown): string;
  numbers(shown: Shown): NumbersTable;
  onError(error: unknown): void;
}

export function createFigure({ id, title, body, tools, notice, numbers, onError }: FigureOptions): Part<HTMLElement> {
  let shown: Shown | null = null;
  const known = (): NumbersTable => (shown ? numbers(shown) : { names: [], rows: [], brief: [] });
  const picture = body.element instanceof SVGSVGElement ? body.element : null;
  const unit = h('span', { class: 'unit' });
  const heading = (): Heading => ({ title, unit: unit.textContent ?? '', ...(shown && axesOf(shown.state, id)) });
  const noticed = h('p', { class: 'notice', 'data-testid': `${id}-notice` });
  const frame = valuesFrame(title);
  const fill = (): void => frame.replaceChildren(valuesTable(title, known(), number));
  const values = h('details', { class: 'values', 'data-testid': `${id}-values` }, h('summary', {}, 'Values'), frame);
  values.addEventListener('toggle', () => values.open && fill());
  const files = saveButtons(
    id,
    title,
    {
      ...(picture && {
        svg: () => new Blob([svgOf(picture, heading())], { type: 'image/svg+xml' }),
        png: () => pngOf(picture, heading()),
      }),
      csv() {
        const { names, rows } = known();
        return new Blob([csvOf(names, rows)], { type: 'text/csv' });
      },
    },
    onError,
  );
  return {
    element: h(
      'figure',
      { class: `play-figure figure-${id}`, 'data-testid': `figure-${id}` },
      h('figcaption', {}, h('h2', {}, title), unit, tools?.element),
      body.element,
      noticed,
      h('div', { class: 'after' }, values, files),
    ),
    update(next) {
      shown = next;
      body.update(next);
      tools?.update(next.state);
      setText(unit, unitsOf(next.state)[id]);
      setText(noticed, notice(next));
      if (values.open) fill();
    },
  };
}
