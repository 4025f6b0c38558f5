/** Keyboard control of the camera. */
import type { Viewer } from './viewer.ts';

const TURN = Math.PI / 36;
const SHIFT = 0.06;
const ZOOM = 1.1;

/**
 * In the focused viewport, arrows rotate the view, Shift with arrows pans it, and plus and minus zoom, unless the view
 * is fixed.
 */
export function listenToCamera(viewer: Viewer, viewport: HTMLElement, turnable = (): boolean => true): void {
  viewport.addEventListener('keydown', (event) => {
    if (!turnable() || event.ctrlKey || event.metaKey || event.altKey) return;
    const move = (right: number, up: number): void => {
      if (event.shiftKey) viewer.pan(right * SHIFT, up * SHIFT);
      else viewer.orbit(right * TURN, up * TURN);
    };
    const actions: Record<string, () => void> = {
      ArrowLeft: () => move(-1, 0),
      ArrowRight: () => move(1, 0),
      ArrowUp: () => move(0, 1),
      ArrowDown: () => move(0, -1),
      '+': () => viewer.zoom(1 / ZOOM),
      '=': () => viewer.zoom(1 / ZOOM),
      '-': () => viewer.zoom(ZOOM),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
