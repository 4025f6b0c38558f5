/** Actions of guide pages on panel controls, which are loaded after the shape. */
import type { PanelName } from '../panels/layout.ts';

/** Calls `act` once, as soon as the element exists; returns a function that stops waiting. */
export function waitForElement(id: string, act: (element: HTMLElement) => void): () => void {
  const found = (): boolean => {
    const element = document.getElementById(id);
    if (element) act(element);
    return element !== null;
  };
  const waiting = new MutationObserver(() => {
    if (found()) waiting.disconnect();
  });
  if (!found()) waiting.observe(document.body, { childList: true, subtree: true });
  return () => waiting.disconnect();
}

/** Presses a button, or a check box by its label unless it is ticked; returns a function that clears the tick. */
export function pressed(control: HTMLElement): () => void {
  const tick = control.querySelector('input');
  if (tick?.checked) return () => undefined;
  control.click();
  return () => {
    if (tick?.checked) tick.click();
  };
}

/** Fills in a field; returns a function that empties it unless the reader has changed it. */
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
 * Calls `show` now and after each size change of a panel, because plots load after the shape. Stops when the reader
 * uses the options or calls the returned function.
 */
export function untilTouched(panel: PanelName, show: () => void): () => void {
  const element = document.getElementById(`panel-${panel}`);
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
