/** The samples as cards that move, and the user's own files, behind a button that says what is open. */
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

/** Files of the user. */
export interface OwnItem {
  /** Of their project. */
  id: string;
  title: string;
}

export interface GalleryProps {
  samples: readonly SampleItem[];
  /** Files of the user that can be opened again. */
  own: readonly OwnItem[];
  /** Id of what is open, or null where files of the user are. */
  sample: string | null;
  /** Of the user's files that are open, else null. */
  project: string | null;
}

export interface GalleryEvents {
  onSample(id: string): void;
  onOwn(id: string): void;
}

/** Of each moment of a sample, in pixels of the file, which has them beside each other. */
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
  const cards = h('div', { class: 'gallery-cards' });
  const ownList = h('div', { class: 'gallery-own', role: 'group', 'aria-label': 'Your files' });
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
    ownList,
    cards,
  );
  const element = h('div', { class: 'sample' }, toggle, panel);
  const flip = popover(element, toggle, panel);

  const drawCards = memo(({ samples, sample }: Pick<GalleryProps, 'samples' | 'sample'>) => {
    const had = cards.contains(document.activeElement);
    cards.replaceChildren(
      ...samples.map(({ id, title, description, boundary }) =>
        h(
          'button',
          {
            type: 'button',
            class: 'sample-card',
            'data-testid': `sample-card-${id}`,
            'data-id': id,
            'aria-current': id === sample ? 'true' : null,
            onclick: () => {
              flip();
              toggle.focus();
              events.onSample(id);
            },
          },
          h(
            'span',
            { class: 'sample-picture', 'data-loops': boundary === 'periodic', 'aria-hidden': 'true' },
            // Fetched when the gallery is opened.
            h('img', { loading: 'lazy', src: `gallery/${id}.webp`, alt: '', draggable: 'false' }),
          ),
          h('strong', {}, title),
          h('span', { class: 'hint' }, description),
        ),
      ),
    );
    if (had) cards.querySelector<HTMLElement>('[aria-current]')?.focus();
  });
  let drawn = '';
  const drawOwn = (own: readonly OwnItem[], project: string | null): void => {
    const text = JSON.stringify([own, project]);
    if (text === drawn) return;
    drawn = text;
    setHidden(ownList, own.length === 0);
    ownList.replaceChildren(
      h('span', { class: 'hint' }, 'Your files'),
      ...own.map(({ id, title }) =>
        h(
          'button',
          {
            type: 'button',
            class: 'button plain',
            'data-testid': `own-${id}`,
            'aria-current': id === project ? 'true' : null,
            onclick: () => {
              flip();
              toggle.focus();
              if (id !== project) events.onOwn(id);
            },
          },
          title,
        ),
      ),
    );
  };
  return {
    element,
    update(next) {
      const { samples, sample, own, project } = next;
      drawCards({ samples, sample });
      drawOwn(own, project);
      const open = project === null ? samples.find(({ id }) => id === sample) : own.find(({ id }) => id === project);
      const words = open?.title ?? 'Samples';
      setText(name, words);
      setAttribute(toggle, 'aria-label', `Samples; open now: ${words}`);
    },
  };
}
