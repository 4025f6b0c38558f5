/** Name, time and slope of a key. */
import { PER_KEY } from '../engine/api/option-table.ts';
import type { KeyTurns, Shaping, ShapingNumber } from '../model/shaping.ts';
import { DEFAULT_SHAPING, SHAPING_NUMBERS } from '../model/shaping.ts';
import type { KeyRef } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { formatTime } from '../model/time-scale.ts';
import { fieldRow, numberField, slider } from './controls.ts';
import { h, setField, setHidden } from './dom.ts';
import { createKeyTurns } from './key-turns.ts';

export interface KeyFieldsProps {
  keys: readonly KeyRef[];
  range: Range;
  /** Number of components of the shape. */
  components: number;
  /** Whether the method supports added turns. */
  turns: boolean;
}

export interface KeyFieldsEvents {
  onRetime(key: number, time: number): void;
  onRename(key: number, name: string): void;
  onShaping(key: number, name: ShapingNumber, value: number): void;
  onTurns(key: number, added: KeyTurns): void;
  /** The component that receives turns; null for the whole shape or when the editor closes. */
  onComponent(component: number | null): void;
}

export interface KeyFields {
  elements: HTMLElement[];
  update(props: KeyFieldsProps, index: number): void;
  focus(): void;
  /** Called when the fields are hidden. */
  leave(): void;
}

export function createKeyFields(events: KeyFieldsEvents): KeyFields {
  let index = 0;
  const name = h('input', {
    type: 'text',
    maxlength: 60,
    placeholder: 'None',
    'data-testid': 'key-name',
    'aria-label': 'Name',
    onchange: () => events.onRename(index, name.value.trim()),
  });
  const time = numberField({ label: 'Time', testId: 'key-time', onInput: (t) => events.onRetime(index, t) });
  const sliders = createShapingSliders((option, value) => events.onShaping(index, option, value));
  const turns = createKeyTurns((added) => events.onTurns(index, added), events.onComponent);
  return {
    elements: [fieldRow('Name', name), fieldRow('Time', time), ...sliders.elements, ...turns.elements],
    update({ keys, range, components, turns: takesTurns }, at) {
      index = at;
      const { name: text, time: t, shaping } = keys[at]!;
      setField(name, text);
      setField(time, formatTime(t, range));
      sliders.update(shaping);
      turns.update({ shaping, canTurn: takesTurns && at > 0, components });
    },
    focus() {
      name.focus();
      name.select();
    },
    leave: turns.reset,
  };
}

function createShapingSliders(onShaping: (name: ShapingNumber, value: number) => void): {
  elements: HTMLElement[];
  update(shaping: Shaping): void;
} {
  const sliders = SHAPING_NUMBERS.map((option) => {
    const { label, hint, slider: ends } = PER_KEY[option];
    const control = slider({
      label,
      hint,
      min: ends[0],
      max: ends[1],
      testId: `key-${option}`,
      step: 0.05,
      fallback: DEFAULT_SHAPING[option],
      onInput: (value) => onShaping(option, value),
    });
    return { option, control };
  });
  const bend = h(
    'p',
    { class: 'reason', 'data-testid': 'key-bend', hidden: true },
    'With tension or bias the velocity stays smooth at this key, but the acceleration jumps (C1, not C2).',
  );
  return {
    elements: [...sliders.map(({ control }) => control.element), bend],
    update(shaping) {
      for (const { option, control } of sliders) control.update(shaping[option]);
      setHidden(bend, shaping.tension === 0 && shaping.bias === 0);
    },
  };
}
