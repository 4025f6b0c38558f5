/** What is changed of one key. Not modal: the shape, and the time, can be moved meanwhile. */
import type { Choice } from './controls.ts';
import { button, numberField, select, slider } from './controls.ts';
import { h, setField, setHidden, setText } from './dom.ts';
import { MOST_TURNS, PER_KEY } from '../engine/api/option-table.ts';
import type { KeyTurns, ShapingNumber } from '../model/shaping.ts';
import { DEFAULT_SHAPING, SHAPING_NUMBERS, turnsOf } from '../model/shaping.ts';
import type { KeyRef } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { formatTime } from '../model/time-scale.ts';

export interface EditedKey extends KeyRef {
  isReference: boolean;
}

export interface KeyEditorProps {
  keys: readonly EditedKey[];
  range: Range;
  canRemove: boolean;
  /** How many components the shape has. */
  components: number;
}

export interface KeyEditorEvents {
  onMove(from: number, to: number): void;
  onRemove(key: number): void;
  onRetime(key: number, time: number): void;
  onRename(key: number, name: string): void;
  onShaping(key: number, name: ShapingNumber, value: number): void;
  onTurns(key: number, added: KeyTurns): void;
  /** The component that whole turns are given to, null for the whole shape or when the editor closes. */
  onComponent(component: number | null): void;
  onReference(key: number): void;
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

const OTHER_WORK = '.side, .app-header, .tabs, .warning-count';

function isOwn(target: EventTarget | null): boolean {
  return document.querySelector('dialog[open]') !== null || (target as Element | null)?.closest?.('.popover') != null;
}

export interface KeyEditor {
  element: HTMLElement;
  /** `from`: what was pressed, where the focus goes back to. False where that closes the editor. */
  open(index: number, from: HTMLElement): boolean;
  update(props: KeyEditorProps): void;
}

export function createKeyEditor(events: KeyEditorEvents): KeyEditor {
  let index = 0;
  /** The pose of the key that is edited: another time may give it another place. */
  let pose: KeyRef['pose'] | null = null;
  let props: KeyEditorProps | null = null;
  let opener: HTMLElement | null = null;
  const title = h('h2', {});
  const name = h('input', {
    type: 'text',
    maxlength: 60,
    placeholder: 'None',
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
  // Wherever the focus is, before Escape means anything else; dialogs and menus have their own.
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape' || element.hidden || isOwn(event.target)) return;
      event.stopPropagation();
      close();
    },
    { capture: true },
  );
  // The shape and the time can be moved meanwhile, and steps be taken back; other work has its room again.
  document.addEventListener('pointerdown', ({ target }) => {
    if (target instanceof Element && target.closest(OTHER_WORK) && !target.closest('.history')) hide();
  });
  window.addEventListener('drop', () => hide(), { capture: true });

  const hide = (): void => {
    if (element.hidden) return;
    element.hidden = true;
    chooseComponent(null);
  };

  const close = (): void => {
    if (element.hidden) return;
    hide();
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
