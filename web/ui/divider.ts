/** The divider between two motions of a shape; a slider for keyboard and screen-reader users. */
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle } from './dom.ts';
import { icon } from './icons.ts';
import { drag, focusPressed, isPress } from './pointer.ts';

/** Smallest visible share of either side. */
export const MIN_SHARE = 0.02;
const STEP = 0.02;
const LONG_STEP = 0.1;

export interface DividerProps {
  /** Share of the width to the left of the divider; null: no divider. */
  share: number | null;
  /** Names of the motions on the left and on the right. */
  left: string;
  right: string;
}

export function createDivider(onMove: (share: number) => void): Component<DividerProps> {
  let now = 0.5;
  // Several events can arrive before the page is redrawn. Each continues from the last requested value.
  const move = (share: number): void => {
    now = Math.min(Math.max(share, MIN_SHARE), 1 - MIN_SHARE);
    onMove(now);
  };
  const element = h(
    'div',
    {
      class: 'divider',
      role: 'slider',
      tabindex: 0,
      hidden: true,
      title: 'Drag to see more of either motion',
      'aria-label': 'Divider between two motions',
      'aria-valuemin': Math.round(100 * MIN_SHARE),
      'aria-valuemax': Math.round(100 * (1 - MIN_SHARE)),
      'data-testid': 'divider',
      onpointerdown: (event: PointerEvent) => {
        if (!isPress(event)) return;
        event.preventDefault();
        event.stopPropagation();
        focusPressed(element);
        const { left, width } = element.parentElement!.getBoundingClientRect();
        const grip = event.clientX - left - now * width;
        drag(element, event, { onMove: (to) => move((to.clientX - grip - left) / width) });
      },
      onkeydown: (event: KeyboardEvent) => {
        const share = steppedTo(event, now);
        if (share === null) return;
        event.preventDefault();
        event.stopPropagation();
        move(share);
      },
    },
    h('span', { class: 'divider-grip' }, icon('sides')),
  );
  return {
    element,
    update({ share, left, right }) {
      setHidden(element, share === null);
      if (share === null) return;
      now = share;
      const percent = Math.round(100 * share);
      setStyle(element, 'left', `${(100 * share).toFixed(3)}%`);
      setAttribute(element, 'aria-valuenow', percent);
      setAttribute(element, 'aria-valuetext', `${left} on the left ${percent} %, ${right} on the right`);
    },
  };
}

/** Position of the divider after a key press, or null for other keys. */
function steppedTo({ key, shiftKey, ctrlKey, altKey, metaKey }: KeyboardEvent, share: number): number | null {
  if (ctrlKey || altKey || metaKey) return null;
  const step = shiftKey ? LONG_STEP : STEP;
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return share - step;
    case 'ArrowRight':
    case 'ArrowUp':
      return share + step;
    case 'PageDown':
      return share - LONG_STEP;
    case 'PageUp':
      return share + LONG_STEP;
    case 'Home':
      return 0;
    case 'End':
      return 1;
    default:
      return null;
  }
}
