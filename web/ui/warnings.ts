/**
 * The warnings as sentences, each with a button that shows its location. Not modal: the shape stays visible and can be
 * rotated.
 */
import { button } from './controls.ts';
import { h, memo, setAttribute, setHidden } from './dom.ts';
import { icon } from './icons.ts';

export interface WarningItem {
  code: string;
  message: string;
  /** Whether a location or a time can be shown. */
  shows: boolean;
}

export interface WarningsProps {
  items: readonly WarningItem[];
  /** The warning whose location is marked on the shape. */
  shown: number | null;
}

export interface WarningsList {
  element: HTMLElement;
  /** `from`: the pressed element, which gets the focus back. */
  toggle(from: HTMLElement): void;
  update(props: WarningsProps): void;
}

/** onShow receives null to remove the mark. */
export function createWarnings(onShow: (index: number | null) => void): WarningsList {
  let opener: HTMLElement | null = null;
  const list = h('ul', { class: 'warning-list' });
  const closer = button({
    label: 'Close',
    testId: 'warnings-close',
    icon: 'close',
    shortcut: 'Esc',
    onClick: () => close(),
  });
  const element = h(
    'div',
    { class: 'card warnings', role: 'dialog', 'data-testid': 'warnings', 'aria-label': 'Warnings', hidden: true },
    h('header', {}, h('h2', {}, 'Warnings'), closer),
    list,
  );
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });

  const close = (): void => {
    if (element.hidden) return;
    element.hidden = true;
    onShow(null);
    opener?.focus();
  };

  const drawItems = memo(({ items }: Pick<WarningsProps, 'items'>) => {
    list.replaceChildren(
      ...items.map((item, index) =>
        h('li', { 'data-code': item.code }, icon('warning'), h('p', {}, item.message), item.shows && showButton(index)),
      ),
    );
    if (items.length === 0) close();
  });

  const showButton = (index: number): HTMLButtonElement => {
    const show = button({
      label: 'Show it',
      testId: `warning-${index}-show`,
      text: 'Show',
      onClick: () => onShow(show.getAttribute('aria-pressed') === 'true' ? null : index),
    });
    setAttribute(show, 'aria-pressed', 'false');
    return show;
  };

  return {
    element,
    toggle(from) {
      if (!element.hidden) return close();
      opener = from;
      setHidden(element, false);
      closer.focus();
    },
    update({ items, shown }) {
      drawItems({ items });
      const pressed = `warning-${shown}-show`;
      for (const show of list.querySelectorAll('button'))
        setAttribute(show, 'aria-pressed', String(show.dataset['testid'] === pressed));
    },
  };
}
