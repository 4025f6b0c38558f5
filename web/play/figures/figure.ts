/** One idea: a picture with its title, what was just to be seen in it, and its numbers and files. */
import { csvOf, pngOf, svgOf } from '../../plots/plot-files.ts';
import type { Heading } from '../../plots/plot-files.ts';
import { h, setText } from '../../ui/dom.ts';
import { saveButtons, valuesFrame, valuesTable } from '../../ui/values.ts';
import type { NumbersTable } from '../../ui/values.ts';
import { number } from './words.ts';

export interface FigureOptions {
  /** Names it in test ids and files. */
  id: string;
  title: string;
  body: HTMLElement | SVGSVGElement;
  /** Between the title and the picture. */
  tools?: HTMLElement;
  picture?: SVGSVGElement;
  numbers(): NumbersTable;
  onError(error: unknown): void;
}

export interface Figure {
  element: HTMLElement;
  /** `unit`: beside the title. `notice`: one or two sentences. */
  update(unit: string, notice: string): void;
}

export function createFigure({ id, title, body, tools, picture, numbers, onError }: FigureOptions): Figure {
  const unit = h('span', { class: 'unit' });
  const heading = (): Heading => ({ title, unit: unit.textContent ?? '' });
  const notice = h('p', { class: 'notice', 'data-testid': `${id}-notice` });
  const frame = valuesFrame(title);
  const fill = (): void => frame.replaceChildren(valuesTable(title, numbers(), number));
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
        const { names, rows } = numbers();
        return new Blob([csvOf(names, rows)], { type: 'text/csv' });
      },
    },
    onError,
  );
  return {
    element: h(
      'figure',
      { class: `play-figure figure-${id}`, 'data-testid': `figure-${id}` },
      h('figcaption', {}, h('h2', {}, title), unit, tools),
      body,
      notice,
      h('div', { class: 'after' }, values, files),
    ),
    update(units, sentence) {
      setText(unit, units);
      setText(notice, sentence);
      if (values.open) fill();
    },
  };
}
