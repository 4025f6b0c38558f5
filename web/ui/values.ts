/** A plot's numbers as a table, and buttons that save the plot and all numbers. */
import { h } from './dom.ts';
import { download } from './download.ts';

export interface NumbersTable {
  names: string[];
  /** All rows, for a file. */
  rows: number[][];
  /** The rows shown in the page. */
  brief: number[][];
}

/** `word`: formats a number. */
export function valuesTable(
  title: string,
  { names, brief }: NumbersTable,
  word: (value: number) => string,
): HTMLTableElement {
  return h(
    'table',
    { class: 'numbers' },
    h('caption', { class: 'visually-hidden' }, title),
    h('thead', {}, h('tr', {}, ...names.map((name) => h('th', { scope: 'col' }, name)))),
    h('tbody', {}, ...brief.map((row) => h('tr', {}, ...row.map((value) => h('td', {}, word(value)))))),
  );
}

/** Scroll container of the table. */
export function valuesFrame(title: string): HTMLElement {
  return h('div', { class: 'values-frame', tabindex: 0, role: 'region', 'aria-label': `${title}, values` });
}

/** `makers`: by file extension. `id` is used in test ids and file names. */
export function saveButtons(
  id: string,
  title: string,
  makers: Readonly<Record<string, () => Promise<Blob> | Blob>>,
  onError: (error: unknown) => void,
): HTMLElement {
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
  return h('div', { class: 'files' }, ...Object.entries(makers).map(([kind, make]) => save(kind, make)));
}
