/**
 * Presentation: full-screen view of the shape, alone or beside one plot, in large type. The screen follows the state as
 * far as the browser allows.
 */
import type { Presented } from '../../model/state.ts';
import { button } from '../../ui/controls.ts';
import { h } from '../../ui/dom.ts';

export interface PresentationParts {
  /** Hides everything else; null shows the whole page. */
  show(what: Presented | null): void;
  presented(): Presented | null;
  present(what: Presented | null): void;
  say(text: string): void;
}

export interface Presentation {
  /** The close button for users without a keyboard. */
  element: HTMLElement;
  update(what: Presented | null): void;
}

/** The close button stays visible for this time after a mouse movement. */
const AWAKE_MS = 2000;

export function createPresentation({ presented, present, show, say }: PresentationParts): Presentation {
  let before: Presented | null = null;
  /** The element that had the focus, to return the focus later. */
  let left: HTMLElement | null = null;
  let timer = 0;
  /** The presentation is in full screen. */
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
    // Removes the focus, so the presenter's arrow keys step through time.
    left = document.activeElement as HTMLElement | null;
    left?.blur();
    // Without a user gesture, as after opening a link, the browser refuses full screen. The presentation then fills the
    // window.
    if (navigator.userActivation?.isActive ?? true)
      document.documentElement.requestFullscreen?.().catch(() => undefined);
  };
  const leave = (): void => {
    // The end of full screen is reported later, when other content may be presented.
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
