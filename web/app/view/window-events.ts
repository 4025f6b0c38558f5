/** Window events for the whole page. */

/** Reports every pointer press and release on the page. */
export function listenToPointer(onHold: (down: boolean) => void): void {
  window.addEventListener('pointerdown', () => onHold(true), { capture: true });
  for (const end of ['pointerup', 'pointercancel'] as const) {
    window.addEventListener(end, () => onHold(false), { capture: true });
  }
}

/** Asks for confirmation if closing the page would lose work. A phone only hides the page. */
export function listenToLeaving(loses: () => boolean, onLeaving: () => void): void {
  window.addEventListener('beforeunload', (event) => {
    onLeaving();
    if (loses()) event.preventDefault();
  });
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) onLeaving();
  });
}

export function listenToNetwork(onOffline: (offline: boolean) => void): void {
  window.addEventListener('offline', () => onOffline(true));
  window.addEventListener('online', () => onOffline(false));
}

export function reducedMotion(): boolean {
  return window.matchMedia('(prefers-reduced-motion: reduce)').matches;
}

/** A pointer that moves further, in CSS pixels, is dragging. */
const CLICK_PX = 4;

/** Clicks without dragging: positions from the element's top left corner, in CSS pixels. */
export function listenToClicks(element: HTMLElement, onClick: (x: number, y: number) => void): void {
  let down: { x: number; y: number } | null = null;
  element.addEventListener('pointerdown', ({ button, isPrimary, clientX: x, clientY: y }) => {
    down = button === 0 && isPrimary ? { x, y } : null;
  });
  element.addEventListener('pointerup', ({ clientX, clientY, isPrimary }) => {
    if (!down || !isPrimary || Math.hypot(clientX - down.x, clientY - down.y) > CLICK_PX) return;
    const box = element.getBoundingClientRect();
    onClick(clientX - box.left, clientY - box.top);
  });
}

/** Delays picking until the pointer rests, because picking in a million faces takes a fifth of a second. */
const REST_MS = 60;

/** Reports where the pointer rests, in CSS pixels from the element's corner. */
export function listenToHover(element: HTMLElement, onHover: (x: number, y: number) => void): void {
  let timer = 0;
  element.addEventListener('pointermove', ({ clientX, clientY }) => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => {
      const box = element.getBoundingClientRect();
      onHover(clientX - box.left, clientY - box.top);
    }, REST_MS);
  });
}
