/** What is dragged between two motions of one shape; a slider for the keyboard and for who cannot see it. */
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setStyle } from './dom.ts';
import { icon } from './icons.ts';
import { drag, focusPressed, isPress } from './pointer.ts';

/** So much of either side always stays. */
export const LEAST_SHARE = 0.02;
const STEP = 0.02;
const LONG_STEP = 0.1;

export interface DividerProps {
  /** Share of the width that is left of it; null = there is none. */
  share: number | null;
  /** What is on its left and on its right. */
  left: string;
  right: string;
}

export function createDivider(onMove: (share: number) => void): Component<DividerProps> {
  let now = 0.5;
  // Several events can come before the page is drawn again: each goes on from what the one before has asked for.
  const move = (share: number): void => {
    now = Math.min(Math.max(share, LEAST_SHARE), 1 - LEAST_SHARE);
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
      'aria-valuemin': Math.round(100 * LEAST_SHARE),
      'aria-valuemax': Math.round(100 * (1 - LEAST_SHARE)),
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

/** Where a key press takes the divider, or null when the key means something else. */
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
