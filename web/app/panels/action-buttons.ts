/** Buttons made from the table of commands. */
import { button, tooltip } from '../../ui/controls.ts';
import { setAttribute, setHidden } from '../../ui/dom.ts';
import type { Action, ButtonState, Place } from '../actions/action.ts';
import type { Context } from '../actions/context.ts';
import { ACTIONS } from '../actions/table.ts';
import type { Commands } from '../actions/table.ts';
import type { Connect } from './connect.ts';

/** The buttons of one page area, with current labels and states. */
export function actionButtons(place: Place, context: Context, commands: Commands, connect: Connect): HTMLElement[] {
  const entries = Object.entries(ACTIONS) as [keyof Commands, Action][];
  return entries.flatMap(([id, { button: options, shown: shortcut }]) => {
    if (options?.in !== place) return [];
    const onClick = (): void => void (commands[id] as () => unknown)();
    const element = button({ ...options, ...(shortcut ? { shortcut } : {}), onClick });
    const { now } = options;
    if (!now) return [element];
    const update = (state: ButtonState): void => show(element, state, shortcut);
    return [connect({ element, update }, () => now(context))];
  });
}

function show(element: HTMLButtonElement, state: ButtonState, shortcut: string | undefined): void {
  const { label, hint, disabled = false, hidden = false, pressed } = state;
  element.disabled = disabled;
  setHidden(element, hidden);
  if (label) setAttribute(element, 'aria-label', label);
  if (hint) setAttribute(element, 'title', tooltip(hint, shortcut));
  if (pressed !== undefined) setAttribute(element, 'aria-pressed', String(pressed));
}
