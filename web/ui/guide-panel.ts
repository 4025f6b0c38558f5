/** A page of the guide beside the app: a text, a task, a sentence to remember, and navigation. */
import { button } from './controls.ts';
import { h, say, setHidden, setText } from './dom.ts';

/** A formula in MathML and in words. */
export interface Formula {
  math: string;
  words: string;
}

export interface GuidePanelProps {
  /** Position such as "Tour, 3 of 10". */
  place: string;
  title: string;
  text: string;
  task: string;
  sentence: string;
  formula: Formula | null;
  more: string | null;
  beside: { label: string; href: string } | null;
  /** All pages of the same kind in order, and the index of this one. */
  pages: readonly { label: string; title: string; link: string }[];
  current: number;
}

export interface GuidePanel {
  element: HTMLElement;
  show(props: GuidePanelProps): void;
  /** Numbers at the current time; '' for none. */
  setLive(text: string): void;
  /** Moves keyboard focus to its title. */
  focus(): void;
  /** Follows the link to the previous or next page, if any. */
  turn(to: 'previous' | 'next'): void;
}

export function createGuidePanel(onClose: () => void): GuidePanel {
  const place = h('p', { class: 'guide-place' });
  const title = h('h2', { tabindex: -1 });
  const body = h('div', { class: 'guide-body' });
  // Not read out, because it changes constantly; the page is read out when it opens.
  const live = h('p', { class: 'guide-live', 'aria-live': 'off', 'data-testid': 'guide-live' });
  const previous = h('a', { class: 'button', rel: 'prev', 'data-testid': 'guide-previous' });
  const next = h('a', { class: 'button primary', rel: 'next', 'data-testid': 'guide-next' });
  const pages = h('nav', { class: 'guide-pages', 'aria-label': 'Pages' });
  const close = button({
    label: 'Leave and return to the previous shape',
    testId: 'guide-close',
    icon: 'close',
    shortcut: 'Esc',
    onClick: onClose,
  });
  const element = h(
    'section',
    { class: 'guide', 'aria-label': 'Guide', 'data-testid': 'guide' },
    h('header', {}, place, close),
    pages,
    h('div', { class: 'guide-scroll' }, h('div', { class: 'guide-told', 'aria-live': 'polite' }, title, body)),
    h('footer', {}, previous, next),
  );

  const turn = (link: HTMLAnchorElement, to: GuidePanelProps['pages'][number] | undefined, words: string): void => {
    const focused = document.activeElement === link;
    setHidden(link, to === undefined);
    if (!to && focused) title.focus();
    if (!to) return;
    link.href = `#${to.link}`;
    setText(link, words);
    link.title = to.title;
  };
  let shown: GuidePanelProps | null = null;
  const pointFrom = (current: number): void => {
    turn(previous, shown?.pages[current - 1], 'Back');
    turn(next, shown?.pages[current + 1], 'Next');
  };
  let asked: string | null = null;
  // A second press before the page has turned moves on by another page.
  element.querySelector('footer')!.addEventListener('click', (event) => {
    if (!(event.target instanceof HTMLAnchorElement) || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    asked = event.target.hash;
    location.hash = asked;
    pointFrom(shown?.pages.findIndex(({ link }) => `#${link}` === asked) ?? 0);
  });
  return {
    element,
    show(props) {
      shown = props;
      setText(place, props.place);
      setText(title, props.title);
      body.replaceChildren(...bodyOf(props, live));
      setText(live, '');
      setHidden(live, true);
      pages.replaceChildren(
        ...props.pages.map(({ label, title: name, link }, index) =>
          h('a', { href: `#${link}`, title: name, 'aria-current': index === props.current && 'page' }, label),
        ),
      );
      if (asked !== location.hash || asked === `#${props.pages[props.current]!.link}`) asked = null;
      if (asked === null) pointFrom(props.current);
      element.querySelector('.guide-scroll')!.scrollTop = 0;
    },
    setLive(text) {
      say(live, text);
    },
    focus: () => title.focus(),
    turn(to) {
      const link = { previous, next }[to];
      if (!link.hidden) link.click();
    },
  };
}

function bodyOf({ text, task, sentence, formula, more, beside }: GuidePanelProps, live: HTMLElement): HTMLElement[] {
  const parts: HTMLElement[] = [h('p', {}, text), h('p', { class: 'guide-task' }, task), live];
  if (beside)
    parts.push(
      h(
        'p',
        { class: 'guide-beside' },
        h('a', { href: beside.href, target: '_blank', rel: 'noopener', 'data-testid': 'guide-beside' }, beside.label),
      ),
    );
  parts.push(h('p', { class: 'guide-sentence' }, sentence));
  if (formula) parts.push(h('figure', { class: 'formula' }, math(formula), h('figcaption', {}, formula.words)));
  if (more) parts.push(h('details', {}, h('summary', {}, 'More'), h('p', {}, more)));
  return parts;
}

/** Browsers and screen readers read MathML directly. */
function math({ math: text, words }: Formula): Element {
  const source = `<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">${text}</math>`;
  const element = document.importNode(new DOMParser().parseFromString(source, 'application/xml').documentElement, true);
  element.setAttribute('aria-label', words);
  return element;
}
