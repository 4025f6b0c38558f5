/** Keyboard handling, from the table of commands. */
import type { ShortcutLine } from '../../ui/help.ts';
import type { Action } from '../actions/action.ts';
import type { Context } from '../actions/context.ts';
import { ACTIONS } from '../actions/table.ts';
import type { Commands } from '../actions/table.ts';

const TABLE = Object.entries(ACTIONS) as [keyof Commands, Action][];

/** The shortcut lines of the help. */
export const SHORTCUTS: readonly ShortcutLine[] = TABLE.flatMap(([, { shown, does }]) =>
  shown && does ? [{ keys: shown, does }] : [],
);

/** The keys of presenters' clickers. */
const PAGES: Readonly<Record<string, 1 | -1>> = { PageUp: -1, PageDown: 1 };

/**
 * Listens on the whole page. Text fields receive letters, controls receive their own keys, and open dialogs receive all
 * keys. Keys without Ctrl can be switched off, for users of speech input.
 */
export function listenToKeys({ viewState }: Context, commands: Commands): void {
  const byKey = new Map(TABLE.flatMap(([id, { keys = [] }]) => keys.map((key) => [key, id] as const)));
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.altKey || document.querySelector('dialog[open]')) return;
    const ctrl = event.ctrlKey || event.metaKey;
    if (!ctrl && (isTyping(event.target) || !viewState.page.singleKeys)) return;
    if (!ctrl && (event.key === ' ' || event.key === 'Enter') && isPressable(event.target)) return;
    const id = byKey.get(nameOf(event, ctrl));
    if (!id) return;
    event.preventDefault();
    // The import dialog covers the panels.
    if ((ACTIONS[id] as Action).edits && viewState.opened.opening) commands.asked();
    void (commands[id] as () => unknown)();
  });
}

/** Arrow keys, Home and End move through time from everywhere, including the viewport, unless a control uses them. */
export function listenToArrows(
  { session: { store }, viewState }: Context,
  viewport: HTMLElement,
  commands: Commands,
): void {
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || usesArrows(event.target)) return;
    if (!viewState.opened.info || event.target === viewport || document.querySelector('dialog[open]')) return;
    const page = store.get().view.present === null ? undefined : PAGES[event.key];
    if (page !== undefined) commands.turnPage(page);
    else if (!commands.step(event)) return;
    event.preventDefault();
  });
}

function nameOf(event: KeyboardEvent, ctrl: boolean): string {
  const key = event.key.toLowerCase();
  // Shift changes punctuation characters already, so it counts only with letters and Ctrl.
  return `${ctrl ? 'ctrl+' : ''}${ctrl && event.shiftKey ? 'shift+' : ''}${key}`;
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement)
    return !['checkbox', 'radio', 'range', 'button', 'file'].includes(target.type);
  return target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

function isPressable(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('button, summary, a, input, select') !== null;
}

/** Whether arrow keys belong to the focused control instead of the timeline. */
function usesArrows(target: EventTarget | null): boolean {
  return isTyping(target) || (target instanceof HTMLInputElement && ['radio', 'range'].includes(target.type));
}
