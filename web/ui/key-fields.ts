/** Name, time and slope of a key. */
import { hasEffect } from '../engine/api/rules.ts';
import { reasonFor } from '../model/option-reasons.ts';
import type { IntervalNumber, KeyTurns, Shaping, ShapingNumber } from '../model/shaping.ts';
import { INTERVAL_NUMBERS, SHAPING_NUMBERS } from '../model/shaping.ts';
import type { KeyRef, Motion } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { formatTime } from '../model/time-scale.ts';
import type { Timing } from '../model/timing-presets.ts';
import { TIMINGS, timingName } from '../model/timing-presets.ts';
import { button, fieldRow, numberField } from './controls.ts';
import { h, say, setField, setHidden, setText } from './dom.ts';
import { createKeyTurns } from './key-turns.ts';
import { optionControl } from './option-field.ts';

const BENT = 'With tension or bias the velocity stays smooth at this key, but the acceleration jumps (C1, not C2).';

const OF_REGIONS = 'Regions of the shape have timings of their own, which these numbers do not change.';

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
  /** Of the interval after the key. */
  onTiming(key: number, timing: Timing): void;
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
  const timing = createTiming(
    (...change) => events.onShaping(index, ...change),
    (one) => events.onTiming(index, one),
  );
  const turns = createKeyTurns((added) => events.onTurns(index, added), events.onComponent);
  return {
    elements: [fieldRow('Name', name), fieldRow('Time', time), ...shaped.elements, timing.element, ...turns.elements],
    update(props, at) {
      const { keys, range, components, motion } = props;
      index = at;
      const { name: text, time: t, shaping } = keys[at]!;
      setField(name, text);
      setField(time, formatTime(t, range));
      shaped.update(props, shaping);
      timing.update(props, shaping, at);
      turns.update({ shaping, canTurn: hasEffect('turns', motion) && at > 0, components });
    },
    focus() {
      name.focus();
      name.select();
    },
    leave: turns.reset,
  };
}

/** Options that belong to the key itself. */
const OWN_NUMBERS = SHAPING_NUMBERS.filter((name) => !(INTERVAL_NUMBERS as readonly string[]).includes(name));

/** Controls of some options, and the reason why they are disabled. */
function createNumbers<N extends ShapingNumber>(names: readonly N[], onInput: (name: N, value: number) => void) {
  const controls = names.map((name) => ({
    name,
    ...optionControl(name, (value) => onInput(name, value), { prefix: 'key-' }),
  }));
  return {
    elements: controls.map(({ element }) => element),
    /** Returns the reason, or ''. */
    update(motion: Motion, shaping: Shaping): string {
      const unused = names.map((name) => reasonFor(name, { motion }));
      const values: Readonly<Record<ShapingNumber, number>> = shaping;
      controls.forEach(({ name, update }, index) => update(values[name], { disabled: unused[index] !== '' }));
      return unused.join(' ').trim();
    },
  };
}

function createShaping(onShaping: (name: ShapingNumber, value: number) => void) {
  const numbers = createNumbers(OWN_NUMBERS, onShaping);
  const reason = h('p', { class: 'reason', 'data-testid': 'key-bend', hidden: true });
  return {
    elements: [...numbers.elements, reason],
    update({ motion }: KeyFieldsProps, shaping: Shaping): void {
      const unused = numbers.update(motion, shaping);
      say(reason, unused || (shaping.tension === 0 && shaping.bias === 0 ? '' : BENT));
    },
  };
}

/** Timing of the interval after the key. */
function createTiming(onNumber: (name: IntervalNumber, value: number) => void, onTiming: (timing: Timing) => void) {
  const numbers = createNumbers(INTERVAL_NUMBERS, onNumber);
  const presets = TIMINGS.map(({ id, label, hint, timing }) =>
    button({ label: hint, text: label, testId: `key-timing-${id}`, onClick: () => onTiming(timing) }),
  );
  const reason = h('p', { class: 'reason', 'data-testid': 'key-timing-reason', hidden: true });
  const summary = h('summary', { 'data-testid': 'key-timing-summary' });
  const rows = h('div', { class: 'group' }, h('div', { class: 'button-row' }, ...presets), ...numbers.elements, reason);
  // Closed, so the editor covers little of the page.
  const element = h('details', { class: 'details key-timing', 'data-testid': 'key-timing' }, summary, rows);
  return {
    element,
    update({ keys, motion }: KeyFieldsProps, shaping: Shaping, index: number): void {
      setHidden(element, index === keys.length - 1 && motion.boundary !== 'periodic');
      setText(summary, `Timing to the next key: ${timingName(shaping)}`);
      const unused = numbers.update(motion, shaping);
      for (const one of presets) one.disabled = unused !== '';
      const hasRegions = motion.regions.some(({ faces }) => faces.length > 0);
      say(reason, unused || (hasRegions ? OF_REGIONS : ''));
    },
  };
}
