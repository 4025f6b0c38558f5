/** The top bar: name, sample, open, undo and redo, export, link, help, theme. */
import { button, tooltip } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden } from './dom.ts';
import { createGallery } from './gallery.ts';
import type { GalleryEvents, OwnItem, SampleItem } from './gallery.ts';
import { createThemeButton } from './theme-button.ts';
import type { Theme } from './theme.ts';

export interface HeaderProps {
  samples: readonly SampleItem[];
  /** Id of the loaded sample, or null where files of the user are loaded. */
  sample: string | null;
  /** Files of the user that can be opened again. */
  own: readonly OwnItem[];
  /** Which of them are loaded: links cannot carry them, this browser can remember them. Else null. */
  project: string | null;
  undo: string | null;
  redo: string | null;
  theme: Theme;
  canExport: boolean;
  remembered: boolean;
}

export interface HeaderEvents extends GalleryEvents {
  onOpen(): void;
  onUndo(): void;
  onRedo(): void;
  onExport(): void;
  onLink(): void;
  onRemember(): void;
  onHelp(): void;
  onTheme(): void;
}

export function createHeader(events: HeaderEvents): Component<HeaderProps> {
  const gallery = createGallery(events);
  const open = button({
    label: 'Open files',
    testId: 'open',
    icon: 'open',
    text: 'Open',
    shortcut: 'Ctrl+O',
    onClick: () => events.onOpen(),
  });
  const undo = button({
    label: 'Undo',
    testId: 'undo',
    icon: 'undo',
    shortcut: 'Ctrl+Z',
    onClick: () => events.onUndo(),
  });
  const redo = button({
    label: 'Redo',
    testId: 'redo',
    icon: 'redo',
    shortcut: 'Ctrl+Shift+Z',
    onClick: () => events.onRedo(),
  });
  const exporting = button({
    label: 'Export',
    testId: 'export',
    icon: 'download',
    text: 'Export',
    shortcut: 'E',
    kind: 'primary',
    onClick: () => events.onExport(),
  });
  const link = button({
    label: 'Copy a link to this view',
    testId: 'link',
    icon: 'link',
    onClick: () => events.onLink(),
  });
  const remember = button({
    label: 'Remember these files on this computer',
    testId: 'remember',
    icon: 'bookmark',
    onClick: () => events.onRemember(),
  });
  const help = button({ label: 'Help', testId: 'help', icon: 'help', shortcut: '?', onClick: () => events.onHelp() });
  const theme = createThemeButton(() => events.onTheme(), 'D');
  const element = h(
    'header',
    { class: 'app-header' },
    h('h1', { class: 'wordmark' }, 'shape', h('span', {}, 'spline')),
    gallery.element,
    open,
    h('div', { class: 'history' }, undo, redo),
    h('div', { class: 'spacer' }),
    exporting,
    link,
    remember,
    help,
    theme.element,
  );

  const draw = memo((props: HeaderProps) => {
    const { samples, sample, own, project } = props;
    gallery.update({ samples, sample, own, project });
    describe(undo, 'Undo', props.undo, 'Ctrl+Z');
    describe(redo, 'Redo', props.redo, 'Ctrl+Shift+Z');
    exporting.disabled = !props.canExport;
    setHidden(link, props.project !== null);
    setHidden(remember, props.project === null);
    setAttribute(remember, 'aria-pressed', String(props.remembered));
    setAttribute(
      remember,
      'title',
      props.remembered
        ? 'These files are remembered in this browser, on this computer only; click to forget them'
        : 'Remember these files in this browser for the next visit; they stay on this computer',
    );
    theme.update(props.theme);
  });
  return { element, update: draw };
}

function describe(control: HTMLButtonElement, verb: string, what: string | null, shortcut: string): void {
  control.disabled = what === null;
  const words = what ? `${verb}: ${what}` : `Nothing to ${verb.toLowerCase()}`;
  setAttribute(control, 'aria-label', words);
  setAttribute(control, 'title', tooltip(words, shortcut));
}
