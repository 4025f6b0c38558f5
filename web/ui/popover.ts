/** A panel that a button opens over the page. Escape, another press of the button, or a press elsewhere closes it. */
import { setAttribute } from './dom.ts';

/** `home` contains both the button and the panel. Returns functions that open and close the panel. */
export function popover(
  home: HTMLElement,
  toggle: HTMLButtonElement,
  panel: HTMLElement,
  onOpen: (open: boolean) => void = () => undefined,
): () => void {
  setAttribute(toggle, 'aria-expanded', 'false');
  setAttribute(toggle, 'aria-controls', panel.id);
  const flip = (): void => {
    panel.hidden = !panel.hidden;
    setAttribute(toggle, 'aria-expanded', String(!panel.hidden));
    onOpen(!panel.hidden);
    if (!panel.hidden) panel.querySelector<HTMLElement>('[aria-current], input')?.focus();
  };
  home.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || panel.hidden) return;
    event.stopPropagation();
    flip();
    toggle.focus();
  });
  document.addEventListener('pointerdown', (event) => {
    if (!panel.hidden && !home.contains(event.target as Node)) flip();
  });
  return flip;
}
