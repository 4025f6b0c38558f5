/** Name, time and slope of a key. */
import { hasEffect } from '../engine/api/rules.ts';
import { reasonFor } from '../model/option-reasons.ts';
import type { KeyTurns, Shaping, ShapingNumber } from '../model/shaping.ts';
import { SHAPING_NUMBERS } from '../model/shaping.ts';
import type { KeyRef, Motion } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { formatTime } from '../model/time-scale.ts';
import { fieldRow, numberField } from './controls.ts';
import { h, say, setField } from './dom.ts';
import { createKeyTurns } from './key-turns.ts';
import { optionControl } from './option-field.ts';

const BENT = 'With tension or bias the velocity stays smooth at this key, but the acceleration jumps (C1, not C2).';

export interface KeyFieldsProps {
  keys: readonly KeyRef[];
  range: Range;
  /** Number of components of the shape. */
  components: number;
  motion: Motion;
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
  const shaped = createShaping((option, value) => events.onShaping(index, option, value));
  const turns = createKeyTurns((added) => events.onTurns(index, added), events.onComponent);
  return {
    elements: [fieldRow('Name', name), fieldRow('Time', time), ...shaped.elements, ...turns.elements],
    update(props, at) {
      const { keys, range, components, motion } = props;
      index = at;
      const { name: text, time: t, shaping } = keys[at]!;
      setField(name, text);
      setField(time, formatTime(t, range));
      shaped.update(props, shaping);
      turns.update({ shaping, canTurn: hasEffect('turns', motion) && at > 0, components });
    },
    focus() {
      name.focus();
      name.select();
    },
    leave: turns.reset,
  };
}

function createShaping(onShaping: (name: ShapingNumber, value: number) => void) {
  const sliders = SHAPING_NUMBERS.map((option) => ({
    option,
    ...optionControl(option, (value) => onShaping(option, value), { prefix: 'key-' }),
  }));
  const reason = h('p', { class: 'reason', 'data-testid': 'key-bend', hidden: true });
  return {
    elements: [...sliders.map(({ element }) => element), reason],
    update({ motion }: KeyFieldsProps, shaping: Shaping): void {
      const unused = SHAPING_NUMBERS.map((option) => reasonFor(option, { motion }));
      sliders.forEach(({ option, update }, index) => update(shaping[option], { disabled: unused[index] !== '' }));
      say(reason, unused.join(' ').trim() || (shaping.tension === 0 && shaping.bias === 0 ? '' : BENT));
    },
  };
}
