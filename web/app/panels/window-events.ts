/** What the window tells the whole page. */

/** Wherever a pointer goes down and up again. */
export function listenToPointer(onHold: (down: boolean) => void): void {
  window.addEventListener('pointerdown', () => onHold(true), { capture: true });
  for (const end of ['pointerup', 'pointercancel'] as const) {
    window.addEventListener(end, () => onHold(false), { capture: true });
  }
}

/** The browser asks before the page is left where that would lose something. */
export function listenToLeaving(loses: () => boolean): void {
  window.addEventListener('beforeunload', (event) => {
    if (loses()) event.preventDefault();
  });
}

export function listenToNetwork(onOffline: (offline: boolean) => void): void {
  window.addEventListener('offline', () => onOffline(true));
  window.addEventListener('online', () => onOffline(false));
}

export function reducedMotion(): boolean {
  return window.matchMedia('(prefers-reduced-motion: reduce)').matches;
}
