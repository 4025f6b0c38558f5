/**
 * What a file with animations asks once it is open: one sheet with the choices that otherwise stand in a panel, and
 * with the work under way and what is offered besides. The shape and its time go on; anything else that is pressed
 * sends it away.
 */
import { button } from './controls.ts';
import { h, setHidden, setStyle } from './dom.ts';

/** What is used with the sheet still there: to see what a choice does. */
const GOES_ON = '.picture, .divider, .view-bar, .transport, .overlay-top, .toast, .opening';

export interface OpeningSheet {
  element: HTMLElement;
  update(shown: boolean): void;
}

export interface OpeningSheetParts {
  /** Where it comes to stand. */
  element: HTMLElement;
  /** The choices, in their panel. */
  choices: HTMLElement;
  /** What is otherwise said over the shape, in its usual place: work under way, what waits for the user's word. */
  over: readonly HTMLElement[];
  /** Takes the keyboard when the sheet goes. */
  next: HTMLElement;
  onClose(): void;
  /** Escape was pressed in the sheet. */
  onEscape(): void;
}

export function createOpeningSheet(parts: OpeningSheetParts): OpeningSheet {
  const { element, choices, over, next, onClose, onEscape } = parts;
  const panel = choices.parentElement!;
  const messages = over[0]!.parentElement!;
  const place = h('div', { 'aria-hidden': 'true' });
  const close = button({ label: 'Close', testId: 'opening-close', icon: 'close', shortcut: 'Esc', onClick: onClose });
  const done = button({ label: 'Done', testId: 'opening-done', text: 'Done', onClick: onClose });
  const end = h('div', { class: 'opening-end' }, done);
  element.append(close, end);

  const open = (): void => {
    // What stands below in the panel stays where it is.
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
  // With the click: what is pressed must not move away before.
  document.addEventListener('click', (event) => {
    if (!element.hidden && !(event.target as Element).closest(GOES_ON)) onClose();
  });
  // What has the keyboard is not left under it. A press focuses, too, and ends with the click above.
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
