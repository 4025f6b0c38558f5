/** What lies on the viewport: standard views, the look of the shape, the phase in words, and the names of the views. */
import type { ViewName } from '../model/camera.ts';
import type { Colouring, View } from '../model/state.ts';
import type { Phase } from '../model/time-scale.ts';
import { LEAST_FILM_SHAPES, MOST_FILM_SHAPES } from '../model/state.ts';
import { button, checkbox, numberField, segments } from './controls.ts';
import { h, memo, setAttribute, setField, setHidden, setStyle, setText } from './dom.ts';
import { popover } from './popover.ts';

export interface ViewBarProps {
  view: View;
  /** Which axis is up where the files do not say it themselves. */
  up: 'y' | 'z' | null;
  disabled: boolean;
}

export interface ViewBarEvents {
  /** Two motions on either side of a divider, or not. */
  onSplit(on: boolean): void;
  onFit(view: ViewName | null): void;
  onView(change: Partial<View>): void;
  onUp(up: 'y' | 'z'): void;
  /** The shape alone, in large type. */
  onPresent(): void;
  /** The link as a QR code. */
  onQr(): void;
}

export function createViewBar(events: ViewBarEvents): {
  element: HTMLElement;
  toggleLook(): void;
  update(props: ViewBarProps): void;
} {
  const colouring = segments<Colouring>(
    'Colour',
    'colouring',
    [
      {
        value: 'texture',
        label: 'Material',
        hint: 'From the file, or clay; the ring on the floor and the outline show the phase',
      },
      { value: 'phase', label: 'Phase', hint: 'Colour by phase: blue at a key, green between, yellow beyond the ends' },
      { value: 'patches', label: 'Patches', hint: 'Regions that turn as a whole' },
      { value: 'rotation', label: 'Rotation', hint: 'How far each face is turned against the reference pose' },
      {
        value: 'stretch',
        label: 'Stretch',
        hint: 'How much longer or shorter each face is than in the reference pose',
      },
      { value: 'distance', label: 'Distance', hint: 'From the first motion, or from the animation that is shown' },
    ],
    (value) => events.onView({ colouring: value }),
  );
  // Two rows of three.
  colouring.element.classList.add('colourings');
  const shading = segments<View['shading']>(
    'Shading',
    'shading',
    [
      { value: 'smooth', label: 'Smooth' },
      { value: 'flat', label: 'Flat' },
    ],
    (value) => events.onView({ shading: value }),
  );
  const wireframe = checkbox('Wireframe', 'wireframe', (on) => events.onView({ wireframe: on }), 'W');
  const floor = checkbox('Floor', 'floor', (on) => events.onView({ floor: on }), 'G');
  const onion = checkbox('Onion skin', 'onion', (on) => events.onView({ onion: on, film: false }), 'O');
  const film = checkbox('Film strip', 'film', (on) => events.onView({ film: on, filmShapes: null, onion: false }), 'I');
  const filmShapes = numberField({
    label: 'Shapes of the film strip',
    testId: 'film-shapes',
    min: LEAST_FILM_SHAPES,
    max: MOST_FILM_SHAPES,
    step: 1,
    onInput: (value) => events.onView({ filmShapes: Math.round(value) }),
  });
  const filmRow = h(
    'label',
    { class: 'field row', hidden: true },
    h('span', { class: 'label' }, 'Shapes in the strip'),
    filmShapes,
  );
  filmShapes.placeholder = 'Auto';
  const split = checkbox('Divider', 'split', (on) => events.onSplit(on), 'S');
  split.element.title = 'Two motions of one shape, on either side of a divider';
  const present = button({
    label: 'Presentation: the shape alone, in large type; A shows the plots',
    testId: 'present',
    icon: 'present',
    text: 'Present',
    shortcut: 'X',
    onClick: () => {
      toggleLook();
      events.onPresent();
    },
  });
  const qr = button({
    label: 'QR code of the link to this view',
    testId: 'qr-open',
    icon: 'qr',
    text: 'QR code',
    shortcut: 'Q',
    onClick: () => events.onQr(),
  });
  const look = h(
    'div',
    { class: 'card popover', id: 'look', 'data-testid': 'look', hidden: true },
    colouring.element,
    shading.element,
    h('div', { class: 'checks' }, wireframe.element, floor.element, onion.element, film.element, split.element),
    filmRow,
    h('div', { class: 'button-row' }, present, qr),
  );
  const toggle = button({
    label: 'Display',
    testId: 'look-toggle',
    icon: 'eye',
    text: 'Display',
    shortcut: 'V',
    onClick: () => toggleLook(),
  });
  const view = (name: ViewName, label: string, key: string): HTMLButtonElement =>
    button({
      label: `${label} view`,
      testId: `view-${name}`,
      text: label,
      shortcut: key,
      onClick: () => events.onFit(name),
    });
  const fit = button({
    label: 'Fit the shape into view',
    testId: 'fit',
    icon: 'fit',
    text: 'Fit',
    shortcut: 'F',
    onClick: () => events.onFit(null),
  });
  let up: ViewBarProps['up'] = null;
  const stand = button({
    label: 'Stand the shape up, or lay it down: these files do not say which axis is up',
    testId: 'stand-up',
    text: 'Stand up',
    onClick: () => events.onUp(up === 'z' ? 'y' : 'z'),
  });
  const bar = h(
    'div',
    { class: 'view-buttons', role: 'toolbar', 'aria-label': 'View' },
    fit,
    view('front', 'Front', '1'),
    view('top', 'Top', '7'),
    view('right', 'Right', '3'),
    stand,
    toggle,
  );
  const element = h('div', { class: 'view-bar' }, look, bar);

  const toggleLook = popover(element, toggle, look);

  const draw = memo(({ view: state, up: present, disabled }: ViewBarProps) => {
    up = present;
    setHidden(stand, up === null);
    setAttribute(stand, 'aria-pressed', String(up === 'z'));
    colouring.update(state.colouring);
    shading.update(state.shading);
    wireframe.update(state.wireframe);
    floor.update(state.floor);
    onion.update(state.onion);
    film.update(state.film);
    setHidden(filmRow, !state.film);
    setField(filmShapes, String(state.filmShapes ?? ''));
    split.update(state.split !== null);
    for (const control of bar.querySelectorAll('button')) control.disabled = disabled;
  });
  return { element, toggleLook, update: draw };
}

/** What of the shape has turned inside out. */
export interface LostFaces {
  /** Of all faces, in [0, 1]. */
  share: number;
  /** One of them is known and can be shown. */
  hasPlace: boolean;
}

/** Fewer than this share of the faces cannot be seen. */
const SEEN_SHARE = 0.001;

/**
 * Where the moment lies, large enough to read from afar; the colour's meaning in words; a way out where the shape
 * breaks.
 */
export function createPhaseLabel(onShowLost: () => void): {
  element: HTMLElement;
  update(phase: Phase | null, lost: LostFaces): void;
} {
  const text = h('span', { 'data-testid': 'phase' });
  const lostText = h('span', {});
  const show = button({
    label: 'Show where',
    testId: 'lost-show',
    text: 'Show where',
    onClick: onShowLost,
  });
  const hint = h('div', { class: 'lost', 'data-testid': 'lost', hidden: true }, lostText, show);
  const element = h(
    'div',
    { class: 'phase-corner', hidden: true },
    hint,
    h('div', { class: 'phase' }, h('span', { class: 'dot' }), text),
  );
  return {
    element,
    update(phase, lost) {
      setHidden(element, phase === null);
      if (!phase) return;
      setAttribute(element, 'data-phase', phase.kind);
      setText(text, phase.text);
      setHidden(hint, !(lost.share >= SEEN_SHARE));
      setText(lostText, lostWords(lost.share, phase));
      setHidden(show, !lost.hasPlace);
    },
  };
}

function lostWords(share: number, { kind }: Phase): string {
  const percent = `${Number((100 * share).toPrecision(share < 0.1 ? 1 : 2))}\u00a0% of the faces fold over here`;
  return kind === 'beyond' ? `${percent}, this far from the keys.` : `${percent}.`;
}

export interface TileLabel {
  title: string;
  /** Measures in percent of the first key's; empty = not known. */
  detail: string;
  /** The same of the volume alone, in whole percent. */
  volume: string;
  x: number;
  y: number;
  width: number;
}

/** Between a divider and an edge as near as this there is no room for words. */
const NARROW_PX = 120;

/** The method's name and its measures over each of several views; beside a divider, the volume in large figures. */
export function createTileLabels(): {
  element: HTMLElement;
  update(labels: readonly TileLabel[], split: boolean): void;
} {
  const element = h('div', { class: 'tile-labels' });
  return {
    element,
    update(labels, split) {
      setAttribute(element, 'data-split', split);
      while (element.children.length > labels.length) element.lastElementChild?.remove();
      labels.forEach((label, index) => {
        const tile = (element.children[index] ??
          element.appendChild(
            h(
              'div',
              { class: 'tile-label', 'data-testid': `tile-${index}` },
              h('strong', {}),
              h('span', { class: 'measures' }, h('span', {}), h('span', { class: 'of' }, ' of the first key')),
              h('span', { class: 'volume' }, h('b', {}), h('span', { class: 'whose' }, ' of its volume')),
            ),
          )) as HTMLElement;
        setStyle(tile, 'left', `${label.x}px`);
        setStyle(tile, 'top', `${label.y}px`);
        setStyle(tile, 'width', `${label.width}px`);
        setAttribute(tile, 'data-edge', label.x > 0);
        setAttribute(tile, 'data-below', label.y > 0);
        setText(tile.firstElementChild!, label.title);
        setAttribute(tile, 'data-narrow', label.width < NARROW_PX);
        const [, measures, volume] = tile.children as unknown as [Element, HTMLElement, HTMLElement];
        setHidden(measures, split || label.detail === '');
        setHidden(volume, !split || label.detail === '');
        setText(measures.firstElementChild!, label.detail);
        setText(volume.firstElementChild!, label.volume);
      });
    },
  };
}
