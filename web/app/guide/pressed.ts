/** A control of the page that a page of the guide presses for its reader. */

/**
 * Presses it as soon as it is there, unless it is a tick that is set. Returns what ends the waiting, and takes a tick
 * back.
 */
export function pressed(testId: string): () => void {
  let tick: HTMLInputElement | null = null;
  const press = (): boolean => {
    const control = document.querySelector<HTMLElement>(`[data-testid="${testId}"]`);
    if (!control) return false;
    const box = control instanceof HTMLInputElement ? control : null;
    if (box?.checked) return true;
    tick = box;
    control.click();
    return true;
  };
  // Parts of the panels are loaded after the shape.
  const waiting = new MutationObserver(() => press() && waiting.disconnect());
  if (!press()) waiting.observe(document.body, { childList: true, subtree: true });
  return () => {
    waiting.disconnect();
    if (tick?.checked) tick.click();
  };
}
