/** The samples as animated cards, and the user's own files, in a menu whose button shows the open shape's name. */
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden, setText } from './dom.ts';
import { icon } from './icons.ts';
import { popover } from './popover.ts';

export interface SampleItem {
  id: string;
  title: string;
  description: string;
  boundary: string;
}

/** A project of the user. */
export interface OwnItem {
  /** Project id. */
  id: string;
  title: string;
}

export interface GalleryProps {
  samples: readonly SampleItem[];
  /** Projects of the user that can be opened again. */
  own: readonly OwnItem[];
  /** Id of the open sample; null if the user's files are open. */
  sample: string | null;
  /** Id of the user's open project, otherwise null. */
  project: string | null;
}

export interface GalleryEvents {
  onSample(id: string): void;
  onOwn(id: string): void;
}

/** Size of one frame of a sample's image, in pixels; the file has the frames side by side. */
export const PICTURE = { width: 304, height: 208 };
export const MOMENTS = 16;

export function createGallery(events: GalleryEvents): Component<GalleryProps> {
  const name = h('span', { class: 'gallery-name' });
  const toggle = h(
    'button',
    {
      type: 'button',
      class: 'button plain gallery-toggle',
      title: 'Choose a sample',
      'aria-haspopup': 'dialog',
      'data-testid': 'sample',
      onclick: () => flip(),
    },
    name,
    icon('down'),
  );
  const close = (): void => {
    flip();
    toggle.focus();
  };
  const cards = createCards((id) => {
    close();
    events.onSample(id);
  });
  const own = createOwnList((id, isOpen) => {
    close();
    if (!isOpen) events.onOwn(id);
  });
  const panel = h(
    'div',
    {
      class: 'card gallery',
      id: 'gallery',
      role: 'dialog',
      'aria-label': 'Samples',
      'data-testid': 'gallery',
      hidden: true,
    },
    own.element,
    cards.element,
  );
  const element = h('div', { class: 'sample' }, toggle, panel);
  const flip = popover(element, toggle, panel);
  return {
    element,
    update(next) {
      const { samples, sample, project } = next;
      cards.update({ samples, sample });
      own.update(next);
      const open =
        project === null ? samples.find(({ id }) => id === sample) : next.own.find(({ id }) => id === project);
      const words = open?.title ?? 'Samples';
      setText(name, words);
      setAttribute(toggle, 'aria-label', `Samples; open now: ${words}`);
    },
  };
}

type CardsProps = Pick<GalleryProps, 'samples' | 'sample'>;

function createCards(onChoose: (id: string) => void): Component<CardsProps> {
  const element = h('div', { class: 'gallery-cards' });
  const createCard = ({ id, title, description, boundary }: SampleItem, isOpen: boolean): HTMLElement =>
    h(
      'button',
      {
        type: 'button',
        class: 'sample-card',
        'data-testid': `sample-card-${id}`,
        'data-id': id,
        'aria-current': isOpen ? 'true' : null,
        onclick: () => onChoose(id),
      },
      h(
        'span',
        { class: 'sample-picture', 'data-loops': boundary === 'periodic', 'aria-hidden': 'true' },
        // Fetched when the gallery opens.
        h('img', { loading: 'lazy', src: `gallery/${id}.webp`, alt: '', draggable: 'false' }),
      ),
      h('strong', {}, title),
      h('span', { class: 'hint' }, description),
    );
  const draw = memo(({ samples, sample }: CardsProps) => {
    const had = element.contains(document.activeElement);
    element.replaceChildren(...samples.map((item) => createCard(item, item.id === sample)));
    if (had) element.querySelector<HTMLElement>('[aria-current]')?.focus();
  });
  return { element, update: draw };
}

function createOwnList(onChoose: (id: string, isOpen: boolean) => void): Component<GalleryProps> {
  const element = h('div', { class: 'gallery-own', role: 'group', 'aria-label': 'Your files' });
  const createItem = ({ id, title }: OwnItem, isOpen: boolean): HTMLElement =>
    h(
      'button',
      {
        type: 'button',
        class: 'button plain',
        'data-testid': `own-${id}`,
        'aria-current': isOpen ? 'true' : null,
        onclick: () => onChoose(id, isOpen),
      },
      title,
    );
  let drawn = '';
  return {
    element,
    update({ own, project }) {
      const text = JSON.stringify([own, project]);
      if (text === drawn) return;
      drawn = text;
      setHidden(element, own.length === 0);
      const items = own.map((item) => createItem(item, item.id === project));
      element.replaceChildren(h('span', { class: 'hint' }, 'Your files'), ...items);
    },
  };
}
