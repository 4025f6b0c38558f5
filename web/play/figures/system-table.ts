/**
 * The J x J system with its current numbers. Each row belongs to a key, which is highlighted while the pointer is over
 * the row.
 */
import { h, setAttribute, setText } from '../../ui/dom.ts';
import type { Part } from './figure.ts';
import { number } from './words.ts';

export function createSystemTable(onLit: (key: number) => void): Part<HTMLElement> {
  const head = h('tr', {});
  const body = h('tbody', {});
  const table = h(
    'table',
    { class: 'system', 'data-testid': 'system' },
    h('caption', { class: 'visually-hidden' }, 'The linear system for the slopes at the keys'),
    h('thead', {}, head),
    body,
  );
  let size = 0;
  const build = (n: number): void => {
    size = n;
    head.replaceChildren(
      h('th', { scope: 'col' }, 'key'),
      ...Array.from({ length: n }, (_, j) => h('th', { scope: 'col' }, 'm', h('sub', {}, String(j + 1)))),
      h('td', {}),
      h('th', { scope: 'col', class: 'rhs' }, h('span', { class: 'visually-hidden' }, 'Right side')),
      h('th', { scope: 'col', class: 'solution' }, 'slope'),
    );
    body.replaceChildren(
      ...Array.from({ length: n }, (_, i) =>
        h(
          'tr',
          {
            tabindex: 0,
            'data-testid': `system-row-${i}`,
            onpointerenter: () => onLit(i),
            onpointerleave: () => onLit(-1),
            onfocus: () => onLit(i),
            onblur: () => onLit(-1),
          },
          h('th', { scope: 'row' }, String(i + 1)),
          ...Array.from({ length: n }, () => h('td', {})),
          h('td', { class: 'equals', 'aria-hidden': 'true' }, '='),
          h('td', { class: 'rhs' }),
          h('td', { class: 'solution' }),
        ),
      ),
    );
  };
  return {
    element: h('div', { class: 'system-frame', tabindex: 0, role: 'region', 'aria-label': 'The system' }, table),
    update({ derived: { system, slopes }, lit }) {
      const n = slopes.length;
      if (n !== size) build(n);
      Array.from(body.rows).forEach((row, i) => {
        setAttribute(row, 'data-lit', i === lit);
        system.matrix[i]!.forEach((entry, j) => {
          const cell = row.cells[j + 1]!;
          setText(cell, entry === 0 ? '·' : number(entry));
          setAttribute(cell, 'class', entry === 0 ? 'none' : i === j ? 'diagonal' : 'beside');
        });
        setText(row.cells[n + 2]!, number(system.rhs[i]!));
        setText(row.cells[n + 3]!, number(slopes[i]!));
      });
    },
  };
}
