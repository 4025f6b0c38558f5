/** One idea: a picture with its title, what was just to be seen in it, and its numbers and files. */
import { csvOf, pngOf, svgOf } from '../../plots/plot-files.ts';
import { h, setText } from '../../ui/dom.ts';
import { download } from '../../ui/download.ts';
import { number } from './words.ts';

export interface NumbersTable {
  names: string[];
  /** All of them, for a file. */
  rows: number[][];
  /** Those that are read in the page. */
  brief: number[][];
}

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
  const notice = h('p', { class: 'notice', 'data-testid': `${id}-notice` });
  const table = h('table', { class: 'numbers' });
  const fill = (): void => {
    const { names, brief } = numbers();
    table.replaceChildren(
      h('caption', { class: 'visually-hidden' }, title),
      h('thead', {}, h('tr', {}, ...names.map((name) => h('th', { scope: 'col' }, name)))),
      h('tbody', {}, ...brief.map((row) => h('tr', {}, ...row.map((value) => h('td', {}, number(value)))))),
    );
  };
  const values = h(
    'details',
    { class: 'values', 'data-testid': `${id}-values` },
    h('summary', {}, 'Values'),
    h('div', { class: 'values-frame', tabindex: 0, role: 'region', 'aria-label': `${title}, values` }, table),
  );
  values.addEventListener('toggle', () => values.open && fill());
  const save = (kind: string, make: () => Promise<Blob> | Blob): HTMLElement =>
    h(
      'button',
      {
        type: 'button',
        class: 'save',
        'data-testid': `${id}-${kind}`,
        'aria-label': `${title} as ${kind.toUpperCase()}`,
        onclick: () =>
          void Promise.resolve()
            .then(make)
            .then((blob) => download(blob, `shapespline-${id}.${kind}`))
            .catch(onError),
      },
      kind.toUpperCase(),
    );
  const files = h(
    'div',
    { class: 'files' },
    ...(picture
      ? [save('svg', () => new Blob([svgOf(picture)], { type: 'image/svg+xml' })), save('png', () => pngOf(picture))]
      : []),
    save('csv', () => {
      const { names, rows } = numbers();
      return new Blob([csvOf(names, rows)], { type: 'text/csv' });
    }),
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
