/** The keys of the keyboard and what they do: one table for the handler and the help. */
import type { ShortcutLine } from '../../ui/help.ts';

export interface Shortcut {
  /** `event.key`, lower case; with 'ctrl+' and 'shift+' before it where they are needed. */
  keys: readonly string[];
  /** As the help shows it; keys are separated by two spaces. */
  shown: string;
  does: string;
  run(): void;
}

export function shortcutLines(shortcuts: readonly Shortcut[]): ShortcutLine[] {
  return shortcuts.filter(({ shown }) => shown !== '').map(({ shown, does }) => ({ keys: shown, does }));
}

/**
 * Listens on the whole page. Fields keep their letters, controls keep the keys that work them, and open dialogs keep
 * everything. `singleKeys` tells whether keys without Ctrl are wanted: some people speak to their computer.
 */
export function listen(shortcuts: readonly Shortcut[], singleKeys: () => boolean): () => void {
  const byKey = new Map(shortcuts.flatMap((shortcut) => shortcut.keys.map((key) => [key, shortcut] as const)));
  const handler = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.altKey || document.querySelector('dialog[open]')) return;
    const ctrl = event.ctrlKey || event.metaKey;
    if (!ctrl && (isTyping(event.target) || !singleKeys())) return;
    if (!ctrl && (event.key === ' ' || event.key === 'Enter') && isPressable(event.target)) return;
    const shortcut = byKey.get(nameOf(event, ctrl));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.run();
  };
  window.addEventListener('keydown', handler);
  return () => window.removeEventListener('keydown', handler);
}

function nameOf(event: KeyboardEvent, ctrl: boolean): string {
  const key = event.key.toLowerCase();
  // Shift makes other characters of punctuation already; it only counts with letters and Ctrl.
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
export function usesArrows(target: EventTarget | null): boolean {
  return isTyping(target) || (target instanceof HTMLInputElement && ['radio', 'range'].includes(target.type));
}
