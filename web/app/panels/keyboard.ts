/** Which key does what; the help lists the same table. */
import { clampTime, timeScale } from '../../model/time-scale.ts';
import { keyboardStep } from '../../model/keyboard-step.ts';
import type { Commands } from './commands.ts';
import type { Range } from '../../model/time-scale.ts';
import type { Store } from '../session/store.ts';
import type { Shortcut } from './shortcuts.ts';
import { usesArrows } from './shortcuts.ts';

export interface KeyboardTargets {
  openFiles(): void;
  openExport(): void;
  openHelp(): void;
  toggleLook(): void;
  toggleClock(): void;
  openLink(): void;
  nextTheme(): void;
  undo(): void;
  redo(): void;
  /** Ends the work under way or closes a message. */
  escape(): void;
  /** What is open is edited by a key. */
  onEdit(): void;
}

export function createShortcuts(store: Store, commands: Commands, targets: KeyboardTargets): Shortcut[] {
  const toggle = (name: 'wireframe' | 'floor' | 'onion' | 'film') => (): void => {
    const { view } = store.get();
    const other = name === 'onion' ? { film: false } : name === 'film' ? { onion: false } : {};
    commands.view({ [name]: !view[name], ...other });
  };
  const edit = (run: () => void) => (): void => {
    targets.onEdit();
    run();
  };
  return [
    { keys: [' '], shown: 'Space', does: 'Play or pause', run: commands.togglePlay },
    { keys: [], shown: '←  →', does: 'One step in time; with Shift, ten', run: () => undefined },
    {
      keys: [],
      shown: 'Home  End',
      does: 'First or last key; again for the end of the extrapolation',
      run: () => undefined,
    },
    { keys: ['['], shown: '[', does: 'Previous key', run: () => commands.jumpKey(-1) },
    { keys: [']'], shown: ']', does: 'Next key', run: () => commands.jumpKey(1) },
    { keys: ['l'], shown: 'L', does: 'Back and forth, loop, or once', run: commands.nextLoop },
    { keys: [','], shown: ',', does: 'Slower', run: () => commands.stepSpeed(-1) },
    { keys: ['.'], shown: '.', does: 'Faster', run: () => commands.stepSpeed(1) },
    {
      keys: ['ctrl+home'],
      shown: 'Ctrl+Home',
      does: 'Start playback here',
      run: () => commands.loopEnd('start', null),
    },
    { keys: ['ctrl+end'], shown: 'Ctrl+End', does: 'End playback here', run: () => commands.loopEnd('end', null) },
    { keys: ['p'], shown: 'P', does: 'Play the whole range', run: () => commands.between(null) },
    {
      keys: ['+', '='],
      shown: '+',
      does: 'Zoom into the timeline; the wheel zooms about the pointer',
      run: () => commands.zoomTime(2),
    },
    { keys: ['-'], shown: '-', does: 'Zoom out of the timeline', run: () => commands.zoomTime(0.5) },
    { keys: ['0'], shown: '0', does: 'The whole timeline', run: () => commands.window(null) },
    { keys: ['t'], shown: 'T', does: 'Frames, loop and zoom', run: targets.toggleClock },
    { keys: ['k'], shown: 'K', does: 'Add the current shape as a key', run: edit(() => void commands.addCurrent()) },
    { keys: ['b'], shown: 'B', does: 'Ends: free, ease or loop', run: edit(commands.nextBoundary) },
    { keys: ['m'], shown: 'M', does: 'Next method', run: edit(commands.nextMethod) },
    { keys: ['n'], shown: 'N', does: 'Ghost mesh on or off', run: edit(commands.toggleGhost) },
    { keys: ['f'], shown: 'F', does: 'Fit the shape into view', run: () => commands.fit(null) },
    { keys: ['1'], shown: '1', does: 'Front view', run: () => commands.fit('front') },
    { keys: ['3'], shown: '3', does: 'Right view', run: () => commands.fit('right') },
    { keys: ['7'], shown: '7', does: 'Top view', run: () => commands.fit('top') },
    { keys: ['h'], shown: 'H', does: 'Initial view', run: () => commands.fit('home') },
    { keys: ['v'], shown: 'V', does: 'Display: colour and shading', run: targets.toggleLook },
    { keys: ['w'], shown: 'W', does: 'Wireframe', run: toggle('wireframe') },
    { keys: ['g'], shown: 'G', does: 'Floor', run: toggle('floor') },
    { keys: ['o'], shown: 'O', does: 'Onion skin', run: toggle('onion') },
    { keys: ['i'], shown: 'I', does: 'Film strip', run: toggle('film') },
    { keys: ['s'], shown: 'S', does: 'Divider between two motions on or off', run: commands.toggleSplit },
    { keys: ['c'], shown: 'C', does: 'Compare with the next method, then with none', run: commands.nextComparison },
    { keys: ['x'], shown: 'X', does: 'Presentation: the shape alone, in large type', run: commands.togglePresent },
    { keys: ['a'], shown: 'A', does: 'Presentation: the next plot, then none', run: commands.nextPlot },
    {
      keys: [],
      shown: 'Page Up  Page Down',
      does: 'Presentation: previous or next key, or page of the tour (elsewhere ten steps in time)',
      run: () => undefined,
    },
    { keys: ['q'], shown: 'Q', does: 'QR code of the link', run: targets.openLink },
    { keys: ['d'], shown: 'D', does: 'Light, dark or system colours', run: targets.nextTheme },
    { keys: ['e'], shown: 'E', does: 'Export', run: targets.openExport },
    { keys: ['ctrl+o'], shown: 'Ctrl+O', does: 'Open files', run: targets.openFiles },
    { keys: ['ctrl+z'], shown: 'Ctrl+Z', does: 'Undo', run: edit(targets.undo) },
    { keys: ['ctrl+shift+z', 'ctrl+y'], shown: 'Ctrl+Shift+Z', does: 'Redo', run: edit(targets.redo) },
    {
      keys: ['escape'],
      shown: 'Esc',
      does: 'Cancel the running work, go back to the motion, close a message or leave the presentation',
      run: targets.escape,
    },
    { keys: ['?'], shown: '?', does: 'This help', run: targets.openHelp },
  ];
}

export interface ArrowParts {
  store: Store;
  commands: Commands;
  /** Has its own use for arrows. */
  viewport: HTMLElement;
  range(): Range;
  /** Whether there is anything to move through. */
  isOpen(): boolean;
}

/** Arrow keys, Home and End move through time wherever the focus is, unless a control has its own use for them. */
export function listenToArrows({ store, commands, viewport, range, isOpen }: ArrowParts): void {
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || usesArrows(event.target)) return;
    if (!isOpen() || event.target === viewport || document.querySelector('dialog[open]')) return;
    const { doc, time: now, play, view } = store.get();
    const page = view.present === null ? undefined : PAGES[event.key];
    if (page !== undefined) {
      event.preventDefault();
      return commands.jumpKey(page);
    }
    const time = keyboardStep(event, now, timeScale(range(), doc.keys.length), play.fps);
    if (time === null) return;
    event.preventDefault();
    commands.seek(clampTime(time, range()));
  });
}

/** What presenters' clickers send. */
const PAGES: Readonly<Record<string, 1 | -1>> = { PageUp: -1, PageDown: 1 };
