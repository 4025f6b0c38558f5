/**
 * The keys as thumbnails: go to one, put it elsewhere in the order, give it another time or name, remove it, add one.
 */
import type { Choice } from './controls.ts';
import { button, numberField, select, slider } from './controls.ts';
import { h, memo, setAttribute, setField, setHidden, setText } from './dom.ts';
import { icon } from './icons.ts';
import { shortNames } from '../model/short-names.ts';
import { MOST_TURNS, PER_KEY } from '../engine/api/option-table.ts';
import type { KeyTurns, ShapingNumber } from '../model/shaping.ts';
import { DEFAULT_SHAPING, SHAPING_NUMBERS, turnsOf } from '../model/shaping.ts';
import type { KeyRef } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { SAME_TIME, formatTime, length } from '../model/time-scale.ts';

export interface KeyItem extends KeyRef {
  isReference: boolean;
  /** Picture of the key, or null while there is none. */
  thumbnail: string | null;
}

export interface KeyStripProps {
  keys: readonly KeyItem[];
  time: number;
  range: Range;
  disabled: boolean;
  canRemove: boolean;
  /** How many components the shape has. */
  components: number;
  /** Why the current shape cannot become a key, or null when it can. */
  addReason: string | null;
}

export interface KeyStripEvents {
  onSeek(t: number): void;
  onMove(from: number, to: number): void;
  onRemove(key: number): void;
  onRetime(key: number, time: number): void;
  onRename(key: number, name: string): void;
  onShaping(key: number, name: ShapingNumber, value: number): void;
  onTurns(key: number, added: KeyTurns): void;
  /** The component that whole turns are given to, null for the whole shape or when the editor closes. */
  onComponent(component: number | null): void;
  onReference(key: number): void;
  onAddCurrent(): void;
  onAddFile(): void;
}

interface Card {
  element: HTMLElement;
  /** `short`: its name without what all names begin with. */
  update(item: KeyItem, index: number, props: KeyStripProps, short: string): void;
}

export interface KeyStrip {
  element: HTMLElement;
  update(props: KeyStripProps): void;
  /** The key before which something lies that is put down here, the number of keys after the last; null elsewhere. */
  placeAt(point: { x: number; y: number }): number | null;
}

export function createKeyStrip(events: KeyStripEvents): KeyStrip {
  const list = h('ol', { class: 'key-list', 'data-testid': 'keys' });
  const editor = createEditor(events);
  const addCurrent = button({
    label: 'Add the current shape as a key',
    testId: 'add-current',
    icon: 'plus',
    text: 'Add key',
    shortcut: 'K',
    kind: 'plain',
    onClick: () => events.onAddCurrent(),
  });
  const addFile = button({
    label: 'Add a key from a file',
    testId: 'add-file',
    icon: 'open',
    text: 'Import pose',
    kind: 'plain',
    onClick: () => events.onAddFile(),
  });
  const element = h(
    'section',
    { class: 'key-strip', 'aria-label': 'Keys' },
    list,
    h('div', { class: 'key-actions' }, addCurrent, addFile),
    editor.element,
  );
  const cards: Card[] = [];
  // What is dragged is told to the page only when it is dropped.
  const drag = { from: -1 };
  const edit = (index: number, from: HTMLElement, time: number): void => {
    if (editor.open(index, from)) events.onSeek(time);
  };
  const draw = memo((next: KeyStripProps) => {
    while (cards.length > next.keys.length) cards.pop()?.element.remove();
    const names = shortNames(next.keys.map(({ name }) => name));
    next.keys.forEach((item, index) => {
      let card = cards[index];
      if (!card) {
        card = createCard(events, drag, edit);
        cards.push(card);
        list.append(card.element);
      }
      card.update(item, index, next, names[index]!);
    });
    setAttribute(element, 'data-empty', next.keys.length === 0);
    addCurrent.disabled = next.disabled || next.addReason !== null;
    setAttribute(addCurrent, 'title', next.addReason ?? 'Add the current shape as a key (K)');
    addFile.disabled = next.disabled;
    editor.update(next);
  });

  const placeAt = ({ x, y }: { x: number; y: number }): number | null => {
    const { left, right, top, bottom } = list.getBoundingClientRect();
    if (x < left || x > right || y < top || y > bottom) return null;
    return cards.filter((card) => middleOf(card.element) < x).length;
  };
  return { element, update: draw, placeAt };
}

function middleOf(element: HTMLElement): number {
  const { left, right } = element.getBoundingClientRect();
  return (left + right) / 2;
}

function createCard(
  events: KeyStripEvents,
  dragged: { from: number },
  onEdit: (index: number, from: HTMLElement, time: number) => void,
): Card {
  let index = 0;
  let time = 0;
  let removable = false;
  const image = h('img', { alt: '', draggable: 'false', width: 72, height: 54 });
  const badge = h('span', { class: 'badge' });
  const name = h('span', { class: 'key-name' });
  const when = h('span', { class: 'key-time' });
  const go = h(
    'button',
    { type: 'button', class: 'key-go', onclick: () => events.onSeek(time) },
    h('span', { class: 'thumb' }, image, badge),
    name,
    when,
  );
  const edit = h(
    'button',
    { type: 'button', class: 'key-edit', onclick: () => onEdit(index, edit, time) },
    icon('down'),
  );
  const element = h('li', { class: 'key-card', draggable: 'true' }, go, edit);

  element.addEventListener('dragstart', (event) => {
    dragged.from = index;
    event.dataTransfer?.setData('application/x-shapespline-key', String(index));
    if (event.dataTransfer) event.dataTransfer.effectAllowed = 'move';
  });
  element.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('application/x-shapespline-key')) return;
    event.preventDefault();
    setAttribute(element, 'data-drop', dragged.from < index ? 'after' : 'before');
  });
  element.addEventListener('dragleave', () => setAttribute(element, 'data-drop', null));
  element.addEventListener('drop', (event) => {
    setAttribute(element, 'data-drop', null);
    const from = event.dataTransfer?.getData('application/x-shapespline-key');
    if (!from) return;
    event.preventDefault();
    event.stopPropagation();
    events.onMove(Number(from), index);
  });
  go.addEventListener('keydown', (event) => {
    if ((event.key === 'Delete' || event.key === 'Backspace') && removable) events.onRemove(index);
  });

  return {
    element,
    update(item, at, { range, time: now, disabled, canRemove }, short) {
      index = at;
      time = item.time;
      removable = canRemove && !disabled;
      const current = Math.abs(now - item.time) <= SAME_TIME * length(range);
      setAttribute(element, 'data-testid', `key-${at}`);
      setAttribute(element, 'data-pose', item.pose);
      setAttribute(element, 'data-current', current);
      setAttribute(go, 'aria-current', current ? 'true' : null);
      setAttribute(
        go,
        'aria-label',
        `Key ${at + 1}, ${item.name}, at ${formatTime(item.time, range)} s${item.isReference ? ', reference' : ''}`,
      );
      setAttribute(go, 'title', `Go to ${item.name}; drag to reorder the keys`);
      setAttribute(go, 'data-testid', `key-${at}-go`);
      setAttribute(edit, 'data-testid', `key-${at}-edit`);
      setAttribute(edit, 'aria-label', `Edit key ${at + 1}, ${item.name}`);
      setAttribute(edit, 'title', 'Name, time, order, remove');
      setAttribute(image, 'src', item.thumbnail);
      setAttribute(image, 'hidden', item.thumbnail === null);
      setText(badge, String(at + 1));
      setText(name, short);
      // Keys of an animation are named by their time already.
      const named = Math.abs(parseFloat(item.name) - item.time) <= 1e-3 * length(range) && item.name.endsWith(' s');
      setText(when, named ? '' : `${Number(formatTime(item.time, range))} s`);
      go.disabled = disabled;
      edit.disabled = disabled;
    },
  };
}

/** More of them cannot be told apart in a list. */
const MOST_COMPONENTS = 400;

/** Those that turn already say so. */
function componentChoices(count: number, turnsOf: (component: number) => number): Choice<string>[] {
  const label = (component: number): string => {
    const turns = turnsOf(component);
    return `Component ${component + 1}${turns === 0 ? '' : `: ${turns > 0 ? '+' : ''}${turns}`}`;
  };
  const each = Array.from({ length: count }, (_, component) => ({ value: String(component), label: label(component) }));
  return [{ value: '', label: 'Whole shape' }, ...each];
}

interface Editor {
  element: HTMLElement;
  /** `from`: what was pressed, where the focus goes back to. False where that closes the editor. */
  open(index: number, from: HTMLElement): boolean;
  update(props: KeyStripProps): void;
}

/** Not modal: the shape, and the time, can be moved while a key is changed. */
function createEditor(events: KeyStripEvents): Editor {
  let index = 0;
  /** The pose of the key that is edited: another time may give it another place. */
  let pose: KeyRef['pose'] | null = null;
  let props: KeyStripProps | null = null;
  let opener: HTMLElement | null = null;
  const title = h('h2', {});
  const name = h('input', {
    type: 'text',
    maxlength: 60,
    'data-testid': 'key-name',
    'aria-label': 'Name',
    onchange: () => events.onRename(index, name.value.trim()),
  });
  const time = numberField({ label: 'Time', testId: 'key-time', onInput: (t) => events.onRetime(index, t) });
  const sliders = SHAPING_NUMBERS.map((option) => ({
    option,
    control: slider({
      label: PER_KEY[option].label,
      hint: PER_KEY[option].hint,
      min: PER_KEY[option].slider[0],
      max: PER_KEY[option].slider[1],
      testId: `key-${option}`,
      step: 0.05,
      fallback: DEFAULT_SHAPING[option],
      onInput: (value) => events.onShaping(index, option, value),
    }),
  }));
  let component: number | null = null;
  const turns = numberField({
    label: PER_KEY.turns.label,
    testId: 'key-turns',
    min: -MOST_TURNS,
    max: MOST_TURNS,
    step: 1,
    onInput: (value) => {
      const added = { turns: Math.round(value) };
      events.onTurns(index, component === null ? added : { component, ...added });
    },
  });
  const turningComponent = select<string>('Of', 'key-turns-component', [], (value) =>
    chooseComponent(value === '' ? null : Number(value)),
  );
  const turnsRow = h(
    'div',
    { class: 'field row' },
    h('span', { class: 'label', title: PER_KEY.turns.hint }, PER_KEY.turns.label),
    turns,
  );
  turningComponent.element.classList.add('row');
  const bend = h(
    'p',
    { class: 'reason', 'data-testid': 'key-bend', hidden: true },
    'With tension or bias the velocity stays smooth at this key, but the acceleration jumps (C1, not C2).',
  );
  const earlier = button({
    label: 'Move earlier in the order',
    testId: 'key-earlier',
    icon: 'left',
    text: 'Earlier',
    kind: 'plain',
    onClick: () => move(-1),
  });
  const later = button({
    label: 'Move later in the order',
    testId: 'key-later',
    icon: 'right',
    text: 'Later',
    kind: 'plain',
    onClick: () => move(1),
  });
  const reference = button({
    label: 'Measure deformations from this key',
    testId: 'key-reference',
    icon: 'check',
    text: 'Use as reference',
    kind: 'plain',
    onClick: () => events.onReference(index),
  });
  const remove = button({
    label: 'Remove this key',
    testId: 'key-remove',
    icon: 'trash',
    text: 'Remove',
    kind: 'plain',
    onClick: () => {
      events.onRemove(index);
      close();
    },
  });
  const reason = h('p', { class: 'reason', hidden: true }, 'A motion needs at least two keys.');
  const element = h(
    'div',
    { class: 'card key-editor', role: 'dialog', 'data-testid': 'key-editor', 'aria-label': 'Edit key', hidden: true },
    h(
      'header',
      {},
      title,
      button({ label: 'Close', testId: 'key-editor-close', icon: 'close', shortcut: 'Esc', onClick: () => close() }),
    ),
    h('div', { class: 'field row' }, h('span', { class: 'label' }, 'Name'), name),
    h('div', { class: 'field row' }, h('span', { class: 'label' }, 'Time'), time),
    ...sliders.map(({ control }) => control.element),
    bend,
    turnsRow,
    turningComponent.element,
    h('div', { class: 'button-row' }, earlier, later),
    h('div', { class: 'button-row' }, reference, remove),
    reason,
  );
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });

  const close = (): void => {
    if (element.hidden) return;
    element.hidden = true;
    chooseComponent(null);
    opener?.focus();
  };

  const chooseComponent = (chosen: number | null): void => {
    if (component === chosen) return;
    component = chosen;
    events.onComponent(component);
    draw();
  };

  const move = (by: 1 | -1): void => {
    const from = index;
    index += by;
    events.onMove(from, from + by);
  };

  const draw = (): void => {
    const item = props?.keys[index];
    if (!props || element.hidden) return;
    if (!item) return close();
    setText(title, `Key ${index + 1}`);
    setField(name, item.name);
    setField(time, formatTime(item.time, props.range));
    for (const { option, control } of sliders) control.update(item.shaping[option]);
    const count = index > 0 && props.components > 1 ? Math.min(props.components, MOST_COMPONENTS) : 0;
    if (component !== null && component >= count) chooseComponent(null);
    const turnsOfOne = (which: number): number => turnsOf(item.shaping, which);
    setField(turns, String(turnsOf(item.shaping, component ?? undefined)));
    setHidden(turningComponent.element, count === 0);
    turningComponent.update(String(component ?? ''), count === 0 ? [] : componentChoices(count, turnsOfOne));
    setHidden(turnsRow, index === 0);
    setHidden(bend, item.shaping.tension === 0 && item.shaping.bias === 0);
    earlier.disabled = index === 0;
    later.disabled = index === props.keys.length - 1;
    reference.disabled = item.isReference;
    remove.disabled = !props.canRemove;
    setHidden(reason, props.canRemove);
  };

  return {
    element,
    open(at, from) {
      if (!element.hidden && at === index) {
        close();
        return false;
      }
      index = at;
      pose = props?.keys[at]?.pose ?? null;
      opener = from;
      element.hidden = false;
      draw();
      name.focus();
      name.select();
      return true;
    },
    update(next) {
      props = next;
      if (next.keys[index]?.pose !== pose) index = next.keys.findIndex((key) => key.pose === pose);
      draw();
    },
  };
}
