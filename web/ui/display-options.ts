/** Display options: colours, surroundings, and additional shapes. */
import type { Colouring, View } from '../model/state.ts';
import { MIN_FILM_SHAPES, MIN_ONION_SPACING, MAX_FILM_SHAPES } from '../model/state.ts';
import { MAX_ONION_SKINS, ONION_COLOURS } from '../model/state.ts';
import type { Choice } from './controls.ts';
import { button, checkbox, fieldRow, numberField, numberRow, segments } from './controls.ts';
import type { Component } from './dom.ts';
import { h, setField, setHidden } from './dom.ts';

export interface DisplayOptionsEvents {
  /** Turns the divider between two motions on or off. */
  onSplit(on: boolean): void;
  onView(change: Partial<View>): void;
  /** Starts the presentation. */
  onPresent(): void;
  /** Shows the link as a QR code. */
  onQr(): void;
}

const COLOURINGS: readonly Choice<Colouring>[] = [
  {
    value: 'texture',
    label: 'Material',
    hint: 'The file’s materials, or clay. The floor ring and the outline show the phase.',
  },
  { value: 'phase', label: 'Phase', hint: 'Colour by phase: blue at a key, green between, yellow beyond the ends' },
  { value: 'patches', label: 'Patches', hint: 'Regions that rotate as a whole' },
  { value: 'rotation', label: 'Rotation', hint: 'Rotation angle of each face relative to the reference pose' },
  { value: 'stretch', label: 'Stretch', hint: 'Stretch of each face relative to the reference pose' },
  { value: 'distance', label: 'Distance', hint: 'Distance from the first motion or from the shown animation' },
];

const SHADINGS: readonly Choice<View['shading']>[] = [
  { value: 'smooth', label: 'Smooth' },
  { value: 'flat', label: 'Flat' },
];

export function createDisplayOptions(events: DisplayOptionsEvents): Component<View> {
  const colouring = segments('Colour', 'colouring', COLOURINGS, (value) => events.onView({ colouring: value }));
  // The choices form two rows of three.
  colouring.element.classList.add('colourings');
  const shading = segments('Shading', 'shading', SHADINGS, (value) => events.onView({ shading: value }));
  const wireframe = checkbox('Wireframe', 'wireframe', (on) => events.onView({ wireframe: on }), 'W');
  const floor = checkbox('Floor', 'floor', (on) => events.onView({ floor: on }), 'G');
  const onion = checkbox('Onion skin', 'onion', (on) => events.onView({ onion: on, film: false }), 'O');
  const film = checkbox('Film strip', 'film', (on) => events.onView({ film: on, filmShapes: null, onion: false }), 'I');
  const split = checkbox('Divider', 'split', (on) => events.onSplit(on), 'S');
  split.element.title = 'Two motions of one shape, on either side of a divider';
  const onionFields = createOnionFields(events);
  const filmShapes = createFilmShapes(events);
  const present = button({
    label: 'Presentation mode: only the shape, with large type; A shows the plots',
    testId: 'present',
    icon: 'present',
    text: 'Present',
    shortcut: 'X',
    onClick: () => events.onPresent(),
  });
  const qr = button({
    label: 'QR code of the link to this view',
    testId: 'qr-open',
    icon: 'qr',
    text: 'QR code',
    shortcut: 'Q',
    onClick: () => events.onQr(),
  });
  const element = h(
    'div',
    { class: 'card popover', id: 'look', 'data-testid': 'look', hidden: true },
    colouring.element,
    shading.element,
    h('div', { class: 'checks' }, wireframe.element, floor.element, onion.element, film.element, split.element),
    onionFields.element,
    filmShapes.element,
    h('div', { class: 'button-row' }, present, qr),
  );
  return {
    element,
    update(view) {
      colouring.update(view.colouring);
      shading.update(view.shading);
      wireframe.update(view.wireframe);
      floor.update(view.floor);
      onion.update(view.onion);
      film.update(view.film);
      onionFields.update(view);
      filmShapes.update(view);
      split.update(view.split !== null);
    },
  };
}

function createOnionFields({ onView }: DisplayOptionsEvents): Component<View> {
  const count = numberField({
    label: 'Number of onion skins before and after the shape',
    testId: 'onion-skins',
    min: 1,
    max: MAX_ONION_SKINS,
    step: 1,
    onInput: (onionSkins) => onView({ onionSkins }),
  });
  const spacing = numberRow({
    label: 'Apart',
    name: 'Seconds between onion skins',
    testId: 'onion-spacing',
    unit: 's',
    min: MIN_ONION_SPACING,
    empty: 0,
    onInput: (value) => onView({ onionSpacing: value || null }),
  });
  const side = (when: keyof typeof ONION_COLOURS): HTMLElement =>
    h(
      'span',
      { class: 'unit onion-side', style: `--swatch: ${ONION_COLOURS[when]}` },
      h('span', { class: 'swatch' }),
      when,
    );
  const element = h(
    'div',
    { class: 'field', hidden: true },
    fieldRow(h('span', { class: 'onion-sides' }, side('before'), side('after')), count),
    spacing.element,
  );
  return {
    element,
    update({ onion, onionSkins, onionSpacing }) {
      setHidden(element, !onion);
      setField(count, String(onionSkins));
      spacing.update(onionSpacing, { text: String(onionSpacing ?? ''), placeholder: 'Auto' });
    },
  };
}

function createFilmShapes({ onView }: DisplayOptionsEvents): Component<View> {
  const { element, update } = numberRow({
    label: 'Shapes in the strip',
    name: 'Number of shapes in the film strip',
    testId: 'film-shapes',
    min: MIN_FILM_SHAPES,
    max: MAX_FILM_SHAPES,
    step: 1,
    onInput: (filmShapes) => onView({ filmShapes }),
  });
  return {
    element,
    update({ film, filmShapes }) {
      setHidden(element, !film);
      update(filmShapes, { text: String(filmShapes ?? ''), placeholder: 'Auto' });
    },
  };
}
