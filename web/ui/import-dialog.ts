/**
 * Import options, shown after opening a file with animations: the Motion panel's choices, running work and offers in
 * one dialog. The view and the time remain usable; any other press closes the dialog.
 */
import { button } from './controls.ts';
import { h, setHidden, setStyle } from './dom.ts';

/** Elements that stay usable while the dialog is open, to see the effect of a choice. */
const GOES_ON = '.picture, .divider, .view-bar, .transport, .overlay-top, .toast, .opening';

export interface ImportDialog {
  element: HTMLElement;
  update(shown: boolean): void;
}

export interface ImportDialogParts {
  /** Container of the dialog. */
  element: HTMLElement;
  /** Panel with the choices. */
  choices: HTMLElement;
  /** Messages that otherwise appear over the shape: running work, and offers. */
  over: readonly HTMLElement[];
  /** Element that gets the focus when the dialog closes. */
  next: HTMLElement;
  onClose(): void;
  /** Escape was pressed in the dialog. */
  onEscape(): void;
}

export function createImportDialog(parts: ImportDialogParts): ImportDialog {
  const { element, choices, over, next, onClose, onEscape } = parts;
  const panel = choices.parentElement!;
  const messages = over[0]!.parentElement!;
  const place = h('div', { 'aria-hidden': 'true' });
  const close = button({ label: 'Close', testId: 'opening-close', icon: 'close', shortcut: 'Esc', onClick: onClose });
  const done = button({ label: 'Done', testId: 'opening-done', text: 'Done', onClick: onClose });
  const end = h('div', { class: 'opening-end' }, done);
  element.append(close, end);

  const open = (): void => {
    // Keeps the position of the content below in the panel.
    setStyle(place, 'height', `${choices.offsetHeight}px`);
    panel.replaceChild(place, choices);
    end.before(choices, ...over);
  };
  const shut = (): void => {
    const had = element.contains(document.activeElement);
    panel.replaceChild(choices, place);
    messages.append(...over);
    if (had) next.focus({ preventScroll: true });
  };

  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || event.defaultPrevented) return;
    event.preventDefault();
    event.stopPropagation();
    onEscape();
  });
  // Handles the click instead of the press, because the pressed element must not move before the click.
  document.addEventListener('click', (event) => {
    if (!element.hidden && !(event.target as Element).closest(GOES_ON)) onClose();
  });
  // The dialog must not cover the focused element. Focus by a press is handled by the click listener above.
  document.addEventListener('keyup', () => {
    if (!element.hidden && document.activeElement?.closest('.side .panel')) onClose();
  });
  return {
    element,
    update(shown) {
      if (shown === !element.hidden) return;
      if (shown) open();
      setHidden(element, !shown);
      if (!shown) shut();
    },
  };
}
