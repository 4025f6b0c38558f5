/** The samples as cards that move, and the user's own files, behind a button that says what is open. */
import { h, memo, setAttribute, setHidden, setText } from './dom.ts';
import { icon } from './icons.ts';
import { popover } from './popover.ts';

export interface SampleItem {
  id: string;
  title: string;
  description: string;
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
  /** Pictures of each in motion, as far as they are made. */
  previews: ReadonlyMap<string, readonly HTMLCanvasElement[]>;
  /** Whether they may move. */
  moving: boolean;
}

export interface GalleryEvents {
  onSample(id: string): void;
  onOwn(id: string): void;
  /** The cards are seen or no longer seen. */
  onGallery(open: boolean): void;
}

const PICTURE_MS = 110;

export function createGallery(events: GalleryEvents): { element: HTMLElement; update(props: GalleryProps): void } {
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
  let props: GalleryProps | null = null;
  let timer = 0;
  let step = 0;

  const draw = (): void => {
    if (props) for (const card of cards.children) drawCard(card, props.previews, step);
  };
  const flip = popover(element, toggle, panel, (open) => {
    window.clearInterval(timer);
    events.onGallery(open);
    if (!open) return;
    draw();
    timer = window.setInterval(() => {
      if (!props?.moving) return;
      step += 1;
      draw();
    }, PICTURE_MS);
  });

  const drawCards = memo(({ samples, sample }: Pick<GalleryProps, 'samples' | 'sample'>) => {
    const had = cards.contains(document.activeElement);
    cards.replaceChildren(
      ...samples.map(({ id, title, description }) =>
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
          h('canvas', { width: 1, height: 1, 'aria-hidden': 'true' }),
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
  // What is drawn of a card follows its pictures, also where nothing may move.
  const drawPictures = memo((_: Pick<GalleryProps, 'previews' | 'samples' | 'sample'>) => {
    if (!panel.hidden) draw();
  });

  return {
    element,
    update(next) {
      props = next;
      const { samples, sample, own, project, previews } = next;
      drawCards({ samples, sample });
      drawOwn(own, project);
      drawPictures({ previews, samples, sample });
      const open = project === null ? samples.find(({ id }) => id === sample) : own.find(({ id }) => id === project);
      const words = open?.title ?? 'Samples';
      setText(name, words);
      setAttribute(toggle, 'aria-label', `Samples; open now: ${words}`);
    },
  };
}

function drawCard(card: Element, previews: GalleryProps['previews'], step: number): void {
  const pictures = previews.get(card.getAttribute('data-id') ?? '');
  const picture = pictures?.[step % pictures.length];
  const canvas = card.querySelector('canvas');
  if (!picture || !canvas) return;
  if (canvas.width !== picture.width) Object.assign(canvas, { width: picture.width, height: picture.height });
  const context = canvas.getContext('2d');
  context?.clearRect(0, 0, canvas.width, canvas.height);
  context?.drawImage(picture, 0, 0);
  setAttribute(card, 'data-picture', step % pictures!.length);
}
