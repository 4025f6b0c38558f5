/** What a page of the guide does with parts of the panels, which are loaded after the shape. */
import type { PanelName } from '../panels/layout.ts';

/** Calls `act` with an element of the page as soon as it is there, once; returns what ends the waiting. */
export function whenThere(testId: string, act: (element: HTMLElement) => void): () => void {
  const found = (): boolean => {
    const element = document.querySelector<HTMLElement>(`[data-testid="${testId}"]`);
    if (element) act(element);
    return element !== null;
  };
  const waiting = new MutationObserver(() => {
    if (found()) waiting.disconnect();
  });
  if (!found()) waiting.observe(document.body, { childList: true, subtree: true });
  return () => waiting.disconnect();
}

/** Presses a control for the reader, unless it is a tick that is set; returns what takes a tick back. */
export function pressed(control: HTMLElement): () => void {
  const tick = control instanceof HTMLInputElement ? control : null;
  if (tick?.checked) return () => undefined;
  control.click();
  return () => {
    if (tick?.checked) tick.click();
  };
}

/** Fills in a field for the reader; returns what empties it, where the reader has entered nothing else. */
export function filled(field: HTMLElement, value: string): () => void {
  if (!(field instanceof HTMLInputElement)) return () => undefined;
  const enter = (text: string): void => {
    field.value = text;
    field.dispatchEvent(new Event('change'));
  };
  enter(value);
  return () => {
    if (field.value === value) enter('');
  };
}

const TOUCHES = ['pointerdown', 'wheel', 'keydown'] as const;

/**
 * Calls `show` now and whenever a panel has another size, as its plots are loaded after the shape, until the reader's
 * hand is on the options; returns what ends it.
 */
export function untilTouched(panel: PanelName, show: () => void): () => void {
  const element = document.querySelector<HTMLElement>(`[data-testid="panel-${panel}"]`);
  const side = element?.closest<HTMLElement>('.side');
  if (!element || !side) return () => undefined;
  const watching = new ResizeObserver(show);
  const end = (): void => {
    watching.disconnect();
    for (const touch of TOUCHES) side.removeEventListener(touch, end);
  };
  for (const touch of TOUCHES) side.addEventListener(touch, end, { passive: true });
  watching.observe(element);
  show();
  return end;
}
