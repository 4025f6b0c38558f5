/** A control of the page that a page of the guide presses for its reader. */

/** Presses it, unless it is a tick that is set; returns what takes a tick back. */
export function pressed(testId: string): () => void {
  const control = document.querySelector<HTMLElement>(`[data-testid="${testId}"]`);
  const tick = control instanceof HTMLInputElement ? control : null;
  if (!control || tick?.checked) return () => undefined;
  control.click();
  return () => {
    if (tick?.checked) tick.click();
  };
}
