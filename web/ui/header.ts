/** The top bar: name, sample, buttons, theme. */
import type { Component } from './dom.ts';
import { h, memo } from './dom.ts';
import { createGallery } from './gallery.ts';
import type { GalleryEvents, OwnItem, SampleItem } from './gallery.ts';
import { createThemeButton } from './theme-button.ts';
import { rovingTabindex } from './roving-tabindex.ts';
import type { Theme } from './theme.ts';

export interface HeaderProps {
  samples: readonly SampleItem[];
  /** Id of the loaded sample; null if the user's files are loaded. */
  sample: string | null;
  /** Projects of the user that can be opened again. */
  own: readonly OwnItem[];
  /** Id of the loaded project, otherwise null. */
  project: string | null;
  theme: Theme;
}

export interface HeaderEvents extends GalleryEvents {
  onTheme(): void;
}

/** Buttons after the gallery, in the history, and at the end. */
export interface HeaderButtons {
  start: readonly HTMLElement[];
  history: readonly HTMLElement[];
  end: readonly HTMLElement[];
}

export function createHeader({ start, history, end }: HeaderButtons, events: HeaderEvents): Component<HeaderProps> {
  const gallery = createGallery(events);
  const theme = createThemeButton(() => events.onTheme(), 'D');
  const element = h(
    'header',
    { class: 'app-header' },
    h('h1', { class: 'wordmark' }, 'shape', h('span', {}, 'spline')),
    gallery.element,
    ...start,
    h('div', { class: 'history' }, ...history),
    h('div', { class: 'spacer' }),
    ...end,
    theme.element,
  );
  // The gallery's contents have their own tab stops.
  rovingTabindex(element, 'button:not(.gallery *)');
  const draw = memo(({ samples, sample, own, project, theme: shown }: HeaderProps) => {
    gallery.update({ samples, sample, own, project });
    theme.update(shown);
  });
  return { element, update: draw };
}
