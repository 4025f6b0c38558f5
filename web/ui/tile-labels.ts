/** The names of the views, over the shape. */
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle, setText } from './dom.ts';

export interface TileLabel {
  title: string;
  /** Measures in percent of the first key's; empty if unknown. */
  detail: string;
  /** The volume alone, in whole percent. */
  volume: string;
  x: number;
  y: number;
  width: number;
}

export interface TileLabelsProps {
  labels: readonly TileLabel[];
  /** A divider separates two motions. */
  split: boolean;
  /** The views show film strips. */
  strip: boolean;
}

/** If the divider is closer to an edge than this, there is no room for text. */
const NARROW_PX = 120;

/** The method's name and measures over each of several views; beside a divider, the volume in large digits. */
export function createTileLabels(): Component<TileLabelsProps> {
  const element = h('div', { class: 'tile-labels' });
  return {
    element,
    update({ labels, split, strip }) {
      setAttribute(element, 'data-split', split);
      setAttribute(element, 'data-strip', strip);
      while (element.children.length > labels.length) element.lastElementChild?.remove();
      labels.forEach((label, index) => {
        const tile = (element.children[index] ??
          element.appendChild(
            h(
              'div',
              { class: 'tile-label', 'data-testid': `tile-${index}` },
              h('strong', {}),
              h('span', { class: 'measures' }, h('span', {}), h('span', { class: 'of' }, ' of the first key')),
              h('span', { class: 'volume' }, h('b', {}), h('span', { class: 'whose' }, ' of its volume')),
            ),
          )) as HTMLElement;
        setStyle(tile, 'left', `${label.x}px`);
        setStyle(tile, 'top', `${label.y}px`);
        setStyle(tile, 'width', `${label.width}px`);
        setAttribute(tile, 'data-edge', label.x > 0);
        setAttribute(tile, 'data-below', label.y > 0);
        setText(tile.firstElementChild!, label.title);
        setAttribute(tile, 'data-narrow', label.width < NARROW_PX);
        const [, measures, volume] = tile.children as unknown as [Element, HTMLElement, HTMLElement];
        setHidden(measures, split || label.detail === '');
        setHidden(volume, !split || label.detail === '');
        setText(measures.firstElementChild!, label.detail);
        setText(volume.firstElementChild!, label.volume);
      });
    },
  };
}
