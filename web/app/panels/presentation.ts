/**
 * Presentation: the shape alone, or beside one plot, in large type over the whole screen. The state says what is
 * presented; the screen follows, as far as the browser lets it.
 */
import type { Presented } from '../../model/state.ts';
import { button } from '../../ui/controls.ts';
import { h } from '../../ui/dom.ts';

export interface PresentationParts {
  /** Leaves nothing but this on the page; null: all of it. */
  show(what: Presented | null): void;
  presented(): Presented | null;
  present(what: Presented | null): void;
  say(text: string): void;
}

export interface Presentation {
  /** The way out for users without a keyboard. */
  element: HTMLElement;
  update(what: Presented | null): void;
}

/** The way out is seen for so long after the mouse has moved. */
const AWAKE_MS = 2000;

export function createPresentation({ presented, present, show, say }: PresentationParts): Presentation {
  let before: Presented | null = null;
  /** What had the focus; who works with keys goes on there. */
  let left: HTMLElement | null = null;
  let timer = 0;
  /** What is presented fills the screen. */
  let fills = false;
  const element = h(
    'div',
    { class: 'leave-presentation' },
    button({
      label: 'Leave the presentation',
      testId: 'leave-presentation',
      icon: 'close',
      shortcut: 'Esc',
      kind: 'plain',
      onClick: () => present(null),
    }),
  );

  const enter = (): void => {
    say('Space plays, [ and ] go to the keys, C compares, A shows a plot, Esc leaves.');
    // Keys are the teacher's from here on: the arrows step through time.
    left = document.activeElement as HTMLElement | null;
    left?.blur();
    // Without the user's word, as from a link, the browser refuses; the presentation fills the window then.
    if (navigator.userActivation?.isActive ?? true)
      document.documentElement.requestFullscreen?.().catch(() => undefined);
  };
  const leave = (): void => {
    // Its end is reported later, when other content may be presented.
    fills = false;
    if (document.fullscreenElement) document.exitFullscreen().catch(() => undefined);
    if (left?.checkVisibility()) left.focus({ preventScroll: true });
    left = null;
  };

  document.addEventListener('fullscreenchange', () => {
    if (document.fullscreenElement) fills = true;
    else if (fills && presented() !== null) present(null);
  });
  window.addEventListener('pointermove', () => {
    if (presented() === null) return;
    element.dataset['awake'] = '';
    window.clearTimeout(timer);
    timer = window.setTimeout(() => delete element.dataset['awake'], AWAKE_MS);
  });

  return {
    element,
    update(what) {
      if (what === before) return;
      show(what);
      if (before === null) enter();
      if (what === null) leave();
      before = what;
    },
  };
}
