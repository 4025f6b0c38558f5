/** Switches for the curves, each with a bar of its total bending relative to the largest. */
import { svg, h, setAttribute, setHidden, setStyle, setText } from '../../ui/dom.ts';
import type { Derived } from '../derived.ts';
import type { Layer, PlayState } from '../state.ts';
import { LAYERS } from '../state.ts';
import type { Part } from './figure.ts';
import { LAYER_WORDS, number } from './words.ts';

export function createLayerList(onShow: (layer: Layer, on: boolean) => void): Part<HTMLElement> {
  const rows = LAYERS.map((layer) => createRow(layer, onShow));
  return {
    element: h(
      'ul',
      { class: 'layers' },
      h('li', { class: 'layers-head', 'aria-hidden': 'true' }, h('span', {}, 'Curve'), h('span', {}, 'total bending')),
      ...rows.map(({ element }) => element),
    ),
    update({ state, derived }) {
      const finite = LAYERS.map((layer) => derived.bending[layer]).filter(Number.isFinite);
      const most = Math.max(...finite, 1e-12);
      for (const row of rows) row.update(state, derived, most);
    },
  };
}

function createRow(layer: Layer, onShow: (layer: Layer, on: boolean) => void) {
  const { name, what } = LAYER_WORDS[layer];
  const input = h('input', {
    type: 'checkbox',
    'data-testid': `layer-${layer}`,
    onchange: () => onShow(layer, input.checked),
  });
  const bar = h('span', { class: `bend-bar ${layer}`, 'aria-hidden': 'true' });
  const value = h('span', { class: 'bend-value', 'data-testid': `bending-${layer}` });
  const said = h('span', { class: 'visually-hidden' });
  const swatch = svg(
    'svg',
    { class: 'swatch plot', viewBox: '0 0 26 10', 'aria-hidden': 'true' },
    layer === 'samples'
      ? svg('g', {}, ...[4, 13, 22].map((cx) => svg('circle', { class: 'sample', cx, cy: 5, r: 2.6 })))
      : svg('line', { class: `curve ${layer}`, x1: 1, x2: 25, y1: 5, y2: 5 }),
  );
  const element = h(
    'li',
    { class: 'layer' },
    h('label', { class: 'check', title: what }, input, swatch, h('span', { class: 'layer-name' }, name), said),
    h('span', { class: 'bend-row' }, bar, value),
    h('p', { class: 'layer-what' }, what),
  );
  return {
    element,
    update(state: PlayState, derived: Derived, most: number): void {
      const on = state.layers.includes(layer);
      const bending = derived.bending[layer];
      input.checked = on;
      setAttribute(element, 'data-on', on);
      setText(value, number(bending));
      setText(
        said,
        `, total bending ${bending === Infinity ? 'infinite' : Number.isNaN(bending) ? 'unknown' : number(bending)}`,
      );
      setStyle(bar, '--share', String(Number.isFinite(bending) ? bending / most : bending > 0 ? 1 : 0));
      setAttribute(bar, 'data-endless', bending === Infinity);
      setHidden(element.querySelector<HTMLElement>('.layer-what')!, !on);
    },
  };
}
