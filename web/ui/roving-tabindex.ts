/** A row of buttons with one tab stop; arrow keys, Home and End move along the row (WAI-ARIA: roving tabindex). */

const MOVES: Readonly<Record<string, (at: number, last: number) => number>> = {
  ArrowLeft: (at, last) => (at > 0 ? at - 1 : last),
  ArrowRight: (at, last) => (at < last ? at + 1 : 0),
  Home: () => 0,
  End: (_, last) => last,
};

/** Whether the focus was last moved by the keyboard. */
let byKeyboard = false;
if (typeof document !== 'undefined') {
  document.addEventListener('keydown', ({ key }) => (byKeyboard ||= key === 'Tab'), { capture: true });
  document.addEventListener('pointerdown', () => (byKeyboard = false), { capture: true });
}

/** `chosen`: selector of the participating buttons. */
export function rovingTabindex(row: HTMLElement, chosen = 'button'): void {
  let stop: HTMLElement | null = null;
  const buttons = (): HTMLButtonElement[] =>
    [...row.querySelectorAll<HTMLButtonElement>(chosen)].filter((one) => !one.disabled && one.checkVisibility());
  const set = (wanted: HTMLElement | null): void => {
    const all = buttons();
    stop = wanted && all.includes(wanted as HTMLButtonElement) ? wanted : (all[0] ?? null);
    for (const one of row.querySelectorAll<HTMLButtonElement>(chosen)) one.tabIndex = one === stop ? 0 : -1;
  };
  row.addEventListener('focusin', ({ target }) => {
    if ((target as Element).matches(chosen)) set(target as HTMLElement);
  });
  row.addEventListener('keydown', (event) => {
    const { target, key, ctrlKey, metaKey, altKey, shiftKey } = event;
    const all = buttons();
    const at = all.indexOf(target as HTMLButtonElement);
    // If the mouse moved the focus, arrow keys step through time as elsewhere.
    if (at < 0 || ctrlKey || metaKey || altKey || shiftKey || !byKeyboard) return;
    const next = MOVES[key]?.(at, all.length - 1);
    if (next === undefined) return;
    event.preventDefault();
    all[next]!.focus();
  });
  // Buttons can appear, disappear, or be disabled, and small pages hide some. First called when the row is shown.
  const follow = (): void => set(stop);
  new MutationObserver(follow).observe(row, {
    childList: true,
    subtree: true,
    attributeFilter: ['disabled', 'hidden'],
  });
  new ResizeObserver(follow).observe(row);
}
