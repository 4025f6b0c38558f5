/** Pins: a button to pin the next clicked vertex, and a row per pin. */
import type { Pin } from '../engine/api/types.ts';
import type { KeyRef } from '../model/state.ts';
import type { Pins } from '../model/pins.ts';
import { PIN_SIZES, changedPin, pinSize, withoutPin } from '../model/pins.ts';
import { keyChoices, keyLabel } from '../model/key-names.ts';
import { button, select } from './controls.ts';
import { h, say, setAttribute, setHidden, setText } from './dom.ts';

const OWN = 'own';

export interface PinListProps {
  pins: Pins;
  keys: readonly KeyRef[];
  /** The next click on the shape places a pin. */
  placing: boolean;
  /** The motion is a loop. */
  periodic: boolean;
  disabled: boolean;
}

export interface PinListEvents {
  onPins(pins: Pin[]): void;
  onPlacing(placing: boolean): void;
}

interface Row {
  element: HTMLElement;
  update(pin: Pin, props: PinListProps): void;
}

export function createPinList(events: PinListEvents): { element: HTMLElement; update(props: PinListProps): void } {
  let pins: Pins = [];
  let placing = false;
  const place = button({
    label: 'Pin a place on the shape by clicking it in the view',
    testId: 'pin-place',
    icon: 'pin',
    text: 'Pin',
    onClick: () => events.onPlacing(!placing),
  });
  const hint = h('p', { class: 'hint', 'data-testid': 'pin-hint' });
  const list = h('div', { class: 'pin-list' });
  const element = h(
    'div',
    { class: 'field', role: 'group', 'aria-label': 'Pins' },
    h('div', { class: 'pin-title' }, h('span', { class: 'label' }, 'Pins'), place),
    hint,
    list,
  );
  const rows: Row[] = [];
  const change = (index: number, part: Parameters<typeof changedPin>[2]): void =>
    events.onPins(changedPin(pins, index, part));
  const remove = (index: number): void => {
    events.onPins(withoutPin(pins, index));
    place.focus({ preventScroll: true });
  };
  return {
    element,
    update(props) {
      const [before, wasPlacing] = [pins.length, placing];
      ({ pins, placing } = props);
      place.disabled = props.disabled;
      setAttribute(place, 'aria-pressed', String(placing));
      setText(hint, hintFor(props));
      setHidden(list, pins.length === 0);
      while (rows.length > pins.length) rows.pop()!.element.remove();
      while (rows.length < pins.length) {
        const row = createRow(rows.length, change, remove);
        rows.push(row);
        list.append(row.element);
      }
      rows.forEach((row, index) => row.update(pins[index]!, props));
      // The hint is below the button, which may be the last visible element.
      if (placing && !wasPlacing) hint.scrollIntoView({ block: 'nearest' });
      if (wasPlacing && pins.length > before) rows.at(-1)!.element.scrollIntoView({ block: 'nearest' });
    },
  };
}

function hintFor({ placing, pins }: PinListProps): string {
  if (placing) return 'Click the place to hold. Press Esc to cancel.';
  if (pins.length > 0) return 'Drag a pin in the view to set its position at the current time.';
  return 'A pin follows its own spline, keeps its position from a key, or goes where you drag it.';
}

/** Explains effects of a pin that its options do not show. */
function noteFor({ stay, path }: Pin, { keys, periodic }: PinListProps): string {
  if (stay !== undefined && !keys.some(({ pose }) => pose === stay))
    return 'The key of this pin was removed, so the pin follows its own spline.';
  if (path?.length === 1) return 'The pin moves by the same amount at all other times until you drag it there as well.';
  return stay !== undefined && periodic
    ? 'If a loop ends away from where it began, the shape travels at constant speed.'
    : '';
}

function createRow(
  index: number,
  change: (index: number, part: Parameters<typeof changedPin>[2]) => void,
  remove: (index: number) => void,
): Row {
  const name = `Pin ${index + 1}`;
  const mode = select<string>(`${name} holds`, `pin-${index}-mode`, [], (value) =>
    change(index, { stay: value === OWN ? undefined : Number(value) }),
  );
  const sizes = PIN_SIZES.map(({ radius, label }) => ({ value: String(radius), label }));
  const size = select(`Size of pin ${index + 1}`, `pin-${index}-size`, sizes, (value) =>
    change(index, { radius: Number(value) }),
  );
  for (const { element: labelled } of [mode, size]) labelled.classList.add('compact');
  const path = h('span', { class: 'hint', 'data-testid': `pin-${index}-path` });
  const clear = button({
    label: `Clear the path of ${name}`,
    testId: `pin-${index}-clear`,
    text: 'Clear path',
    kind: 'quiet',
    onClick: () => change(index, { path: undefined }),
  });
  const pathRow = h('div', { class: 'pin-path' }, path, clear);
  const note = h('p', { class: 'hint pin-note', 'data-testid': `pin-${index}-note` });
  const element = h(
    'div',
    { class: 'pin-row', role: 'group', 'aria-label': name, 'data-testid': `pin-${index}` },
    h('span', { class: 'pin-number', 'aria-hidden': 'true' }, String(index + 1)),
    mode.element,
    size.element,
    button({
      label: `Remove pin ${index + 1}`,
      testId: `pin-${index}-remove`,
      icon: 'close',
      onClick: () => remove(index),
    }),
    pathRow,
    note,
  );
  return {
    element,
    update(pin, props) {
      const { keys } = props;
      const stays = keys.findIndex(({ pose }) => pose === pin.stay);
      const held = stays < 0 ? 'follows its own spline' : `stays as in ${keyLabel(stays, keys[stays]!.name)}`;
      setAttribute(mode.field, 'title', `${name} ${held}`);
      mode.update(stays < 0 ? OWN : String(pin.stay), [
        { value: OWN, label: 'Own spline' },
        ...keyChoices(keys).map(({ value, label }) => ({ value, label: `As in ${label}` })),
      ]);
      size.update(String(pinSize(pin)));
      const count = pin.path?.length ?? 0;
      setHidden(pathRow, count === 0);
      setText(path, `Dragged at ${timesText((pin.path ?? []).map(({ time }) => time))}`);
      say(note, noteFor(pin, props));
    },
  };
}

/** More times than this are shown as a count. */
const MAX_TIMES = 4;

function timesText(times: readonly number[]): string {
  if (times.length > MAX_TIMES) return `${times.length} times`;
  return `${times.map((time) => Number(time.toPrecision(3))).join(', ')} s`;
}
