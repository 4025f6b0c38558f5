/** Overlays of the viewport: running work, errors, and the welcome sentence. */
import { button } from './controls.ts';
import { h, memo, setAttribute, setHidden, setStyle, setText } from './dom.ts';
import { icon } from './icons.ts';

export interface Working {
  stage: string;
  /** Completed share in [0, 1]. */
  fraction: number;
}

/** Texts of the engine's stages for users. */
const STAGE_WORDS: Readonly<Record<string, string>> = {
  reading: 'Reading',
  welding: 'Joining seams',
  simplifying: 'Making the ghost mesh',
  encoding: 'Comparing the poses',
  ordering: 'Preparing the motion',
  factorising: 'Preparing the motion',
};

/** The stage, a bar, and a cancel button. The open shape, or the first key of the next one, stays visible behind it. */
export function createProgress(onCancel: () => void): {
  element: HTMLElement;
  update(working: Working | null): void;
} {
  const stage = h('span', { class: 'stage', 'data-testid': 'stage' });
  const bar = h('div', { class: 'bar' });
  const meter = h(
    'div',
    { class: 'meter', role: 'progressbar', 'aria-label': 'Progress', 'aria-valuemin': 0, 'aria-valuemax': 100 },
    bar,
  );
  const cancel = button({ label: 'Cancel', testId: 'cancel', text: 'Cancel', shortcut: 'Esc', onClick: onCancel });
  const element = h(
    'div',
    { class: 'card progress', 'data-testid': 'progress', hidden: true },
    h('div', { class: 'progress-text', role: 'status' }, stage, meter),
    cancel,
  );
  return {
    element,
    update(working) {
      setHidden(element, working === null);
      if (!working) return;
      setText(stage, STAGE_WORDS[working.stage] ?? working.stage);
      setAttribute(meter, 'aria-valuenow', Math.round(working.fraction * 100));
      setStyle(bar, 'width', `${(working.fraction * 100).toFixed(1)}%`);
    },
  };
}

/** A button that brings the shape back into view. */
export function createFitHint(onFit: () => void): { element: HTMLElement; update(shown: boolean): void } {
  const element = h(
    'div',
    { class: 'card progress', role: 'status', 'data-testid': 'out-of-view', hidden: true },
    h('span', {}, 'The shape is out of view.'),
    button({ label: 'Fit the view to the shape', testId: 'fit-hint', text: 'Fit', onClick: onFit }),
  );
  return { element, update: (shown) => setHidden(element, !shown) };
}

export interface ErrorMessage {
  /** One sentence: the problem, its location, and the remedy. */
  message: string;
  /** Details for experts. */
  details: string;
  /** Reloading the page may help. */
  retry?: boolean;
}

export function createErrorMessage(
  onClose: () => void,
  onRetry: () => void,
): {
  element: HTMLElement;
  update(error: ErrorMessage | null): void;
} {
  const message = h('p', { class: 'message', 'data-testid': 'error-message' });
  const details = h('p', { class: 'expert' });
  const more = h('details', {}, h('summary', {}, 'Details'), details);
  const retry = button({
    label: 'Try again: reload the page',
    testId: 'error-retry',
    text: 'Try again',
    onClick: onRetry,
  });
  const element = h(
    'div',
    { class: 'card error-message', role: 'alert', 'data-testid': 'error', hidden: true },
    icon('warning'),
    h('div', {}, message, more, retry),
    button({ label: 'Close this message', testId: 'error-close', icon: 'close', shortcut: 'Esc', onClick: onClose }),
  );
  const draw = memo(({ error }: { error: ErrorMessage | null }) => {
    setHidden(element, error === null);
    if (!error) return;
    setText(message, error.message);
    setText(details, error.details);
    setHidden(more, error.details === '');
    setHidden(retry, error.retry !== true);
  });
  return { element, update: (error) => draw({ error }) };
}

export interface Offer {
  message: string;
  /** Label of the action; absent for a plain message. */
  action?: string;
  onAccept?(): void;
  /** Alternative actions. */
  others?: readonly { action: string; onAccept(): void }[];
  /** Called when the user dismisses the offer. */
  onDecline?(): void;
}

/** An offer that waits for the user and disappears when accepted or dismissed. */
export function createOffer(testId: string): { element: HTMLElement; offer(offer: Offer | null): void } {
  let current: Offer | null = null;
  const show = (now: Offer | null): void => {
    current = now;
    setHidden(element, now === null);
  };
  const accept = (): void => {
    const taken = current;
    show(null);
    taken?.onAccept?.();
  };
  const message = h('p', { class: 'message' });
  const action = button({ label: 'Accept', testId: `${testId}-accept`, text: 'Accept', onClick: accept });
  const others = h('div', { class: 'offer-others', hidden: true });
  const showOthers = (offered: Offer['others'] = []): void => {
    const buttons = offered.map(({ action, onAccept }, index) =>
      button({
        label: action,
        testId: `${testId}-other-${index}`,
        text: action,
        onClick: () => {
          show(null);
          onAccept();
        },
      }),
    );
    others.replaceChildren(...buttons);
    setHidden(others, offered.length === 0);
  };
  const decline = (): void => {
    const declined = current;
    show(null);
    declined?.onDecline?.();
  };
  const later = button({ label: 'Not now', testId: `${testId}-later`, icon: 'close', onClick: decline });
  const element = h(
    'div',
    { class: 'card offer', role: 'status', 'data-testid': testId, hidden: true },
    message,
    action,
    others,
    later,
  );
  return {
    element,
    offer(now) {
      if (now) {
        setText(message, now.message);
        setHidden(action, now.action === undefined);
        setText(action, now.action ?? '');
        setAttribute(action, 'aria-label', now.action ?? '');
        showOthers(now.others);
      }
      show(now);
    },
  };
}

const WELCOME = ['Poses in, motion out.', 'Drag the slider, even past both ends, or drop poses of your own mesh here.'];
const WELCOME_SPLIT = ['Morph targets collapse between poses. Here the shape keeps its volume.', 'Drag the divider.'];

export interface WelcomeProps {
  wanted: boolean;
  /** The welcome is hidden because another message needs its position. */
  isCovered: boolean;
  /** A divider compares two motions. */
  split: boolean;
}

/** Describes the page in one sentence until the user acts. */
export function createWelcome(onPick: () => void): {
  element: HTMLElement;
  update(props: WelcomeProps): void;
} {
  const claim = h('strong', {});
  const rest = h('span', {});
  const element = h(
    'div',
    { class: 'welcome', 'data-testid': 'welcome', hidden: true },
    h('p', {}, claim, ' ', rest),
    h('a', { class: 'button', href: '#tour=1', 'data-testid': 'welcome-tour' }, 'Take the tour'),
    button({ label: 'Choose files', testId: 'welcome-open', text: 'Choose files', icon: 'open', onClick: onPick }),
  );
  return {
    element,
    update({ wanted, isCovered, split }) {
      const [bold, plain] = split ? WELCOME_SPLIT : WELCOME;
      setText(claim, bold);
      setText(rest, plain);
      setHidden(element, !wanted);
      setAttribute(element, 'data-gives-way', isCovered);
    },
  };
}

/**
 * Milliseconds that a message stays, without and with a button, and the minimum before the next message replaces it.
 */
const [SHOWN_MS, OFFERED_MS, READING_MS] = [4000, 8000, 2000];

/** A follow-up action for the message. */
export interface ToastAction {
  label: string;
  testId: string;
  run(): void;
}

export interface Toast {
  element: HTMLElement;
  say(text: string, action?: ToastAction): void;
  /** Removes an action that no longer applies. */
  withdraw(): void;
  clear(): void;
}

/** Short message that disappears by itself, read out by screen readers. */
export function createToast(): Toast {
  const words = h('span', { role: 'status', 'aria-live': 'polite', 'data-testid': 'toast' });
  const element = h('div', { class: 'toast', popover: 'manual' }, words);
  const waiting: { text: string; action?: ToastAction | undefined }[] = [];
  let timer = 0;
  let readBy = 0;
  const show = (text: string, action?: ToastAction): void => {
    setAttribute(element, 'data-shown', text !== '');
    // The text stays while the message fades.
    if (text !== '') words.textContent = text;
    element.replaceChildren(words, ...(action ? [actionButton(action)] : []));
  };
  const actionButton = ({ label, testId, run }: ToastAction): HTMLElement =>
    button({
      label,
      testId,
      text: label,
      onClick: () => {
        window.clearTimeout(timer);
        show('');
        run();
      },
    });
  const withdraw = (): void => {
    for (const said of waiting) said.action = undefined;
    element.replaceChildren(words);
  };
  const next = (): void => {
    const said = waiting.shift();
    if (!said) return show('');
    // Reopens the message above any dialog that opened meanwhile.
    element.hidePopover();
    element.showPopover();
    show(said.text, said.action);
    readBy = performance.now() + READING_MS;
    const shownMs = said.action ? OFFERED_MS : SHOWN_MS;
    timer = window.setTimeout(next, waiting.length > 0 ? READING_MS : shownMs);
  };
  return {
    element,
    say(text, action) {
      waiting.push({ text, action });
      window.clearTimeout(timer);
      const left = readBy - performance.now();
      if (left > 0) timer = window.setTimeout(next, left);
      else next();
    },
    withdraw,
    clear() {
      window.clearTimeout(timer);
      waiting.length = 0;
      readBy = 0;
      words.textContent = '';
      show('');
    },
  };
}
