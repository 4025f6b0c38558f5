/** Overview below a zoomed timeline: shows the window's position in the whole; dragging moves the window. */
import { h, setHidden, setStyle } from './dom.ts';
import type { Range, TimeScale } from '../model/time-scale.ts';
import { length } from '../model/time-scale.ts';
import { panned } from '../model/time-window.ts';
import { drag } from './pointer.ts';

export interface Overview {
  element: HTMLElement;
  update(scale: TimeScale, window: Range): void;
}

export function createOverview(onWindow: (window: Range | null) => void): Overview {
  let scale: TimeScale = { range: [0, 1], whole: [0, 1] };
  let shown: Range = [0, 1];
  const thumb = h('div', { class: 'overview-thumb' });
  const element = h(
    'div',
    {
      class: 'overview',
      'aria-hidden': 'true',
      'data-testid': 'overview',
      title: 'The visible part of the timeline; drag to move it',
      hidden: true,
      onpointerdown: (event: PointerEvent) => {
        if (event.button !== 0) return;
        event.preventDefault();
        const start = shown;
        const perPixel = length(scale.whole) / element.clientWidth;
        drag(element, event, {
          onMove: (move) => onWindow(panned(start, scale, (move.clientX - event.clientX) * perPixel)),
        });
      },
    },
    thumb,
  );
  return {
    element,
    update(next, window) {
      scale = next;
      shown = window;
      const { whole } = scale;
      setHidden(element, length(window) >= length(whole) * (1 - 1e-9));
      setStyle(thumb, 'left', `${(100 * (window[0] - whole[0])) / length(whole)}%`);
      setStyle(thumb, 'width', `${(100 * length(window)) / length(whole)}%`);
    },
  };
}
