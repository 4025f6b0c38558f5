/** The top bar: name, sample, open, undo and redo, export, link, help, theme. */
import { button, tooltip } from './controls.ts';
import type { Component, Fields } from './dom.ts';
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
  const history = createHistory(events);
  const exporting = button({
    label: 'Export',
    testId: 'export',
    icon: 'download',
    text: 'Export',
    shortcut: 'E',
    kind: 'primary',
    onClick: () => events.onExport(),
  });
  const keeping = createKeeping(events);
  const help = button({ label: 'Help', testId: 'help', icon: 'help', shortcut: '?', onClick: () => events.onHelp() });
  const theme = createThemeButton(() => events.onTheme(), 'D');
  const element = h(
    'header',
    { class: 'app-header' },
    h('h1', { class: 'wordmark' }, 'shape', h('span', {}, 'spline')),
    gallery.element,
    open,
    history.element,
    h('div', { class: 'spacer' }),
    exporting,
    ...keeping.elements,
    help,
    theme.element,
  );
  const draw = memo((props: HeaderProps) => {
    const { samples, sample, own, project } = props;
    gallery.update({ samples, sample, own, project });
    history.update(props);
    exporting.disabled = !props.canExport;
    keeping.update(props);
    theme.update(props.theme);
  });
  return { element, update: draw };
}

function createHistory({ onUndo, onRedo }: HeaderEvents): Component<HeaderProps> {
  const undo = button({ label: 'Undo', testId: 'undo', icon: 'undo', shortcut: 'Ctrl+Z', onClick: () => onUndo() });
  const redo = button({
    label: 'Redo',
    testId: 'redo',
    icon: 'redo',
    shortcut: 'Ctrl+Shift+Z',
    onClick: () => onRedo(),
  });
  return {
    element: h('div', { class: 'history' }, undo, redo),
    update(props) {
      describe(undo, 'Undo', props.undo, 'Ctrl+Z');
      describe(redo, 'Redo', props.redo, 'Ctrl+Shift+Z');
    },
  };
}

/** What is open can come back by its link; files of the user cannot, and are remembered instead. */
function createKeeping({ onLink, onRemember }: HeaderEvents): Fields<HeaderProps> {
  const link = button({ label: 'Copy a link to this view', testId: 'link', icon: 'link', onClick: () => onLink() });
  const remember = button({
    label: 'Remember these files on this computer',
    testId: 'remember',
    icon: 'bookmark',
    onClick: () => onRemember(),
  });
  return {
    elements: [link, remember],
    update({ project, remembered }) {
      setHidden(link, project !== null);
      setHidden(remember, project === null);
      setAttribute(remember, 'aria-pressed', String(remembered));
      setAttribute(
        remember,
        'title',
        remembered
          ? 'These files are remembered in this browser, on this computer only; click to forget them'
          : 'Remember these files in this browser for the next visit; they stay on this computer',
      );
    },
  };
}

function describe(control: HTMLButtonElement, verb: string, what: string | null, shortcut: string): void {
  control.disabled = what === null;
  const words = what ? `${verb}: ${what}` : `Nothing to ${verb.toLowerCase()}`;
  setAttribute(control, 'aria-label', words);
  setAttribute(control, 'title', tooltip(words, shortcut));
}
