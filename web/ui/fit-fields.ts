/** The mesh and the times at which shapes between the keys are fitted. */
import { MOTION } from '../engine/api/option-table.ts';
import type { Motion } from '../model/state.ts';
import { button, fieldRow, numberField, setIdle, unit } from './controls.ts';
import type { Component } from './dom.ts';
import { h, setField } from './dom.ts';

type FitOption = 'spaceFaces' | 'spaceSamples';

interface Words {
  label: string;
  testId: string;
  unit?: string;
  hint: string;
}

const WORDS: Record<FitOption, Words> = {
  spaceFaces: {
    label: 'Fitted mesh',
    testId: 'space-faces',
    unit: 'faces',
    hint: 'Shapes are fitted on a mesh with at most this many faces, which the full shape follows. More: finer, but slower to build.',
  },
  spaceSamples: {
    label: 'Intervals',
    testId: 'space-samples',
    hint: 'Shapes are fitted at both ends of this many intervals. More: closer to the exact curve, but slower to build.',
  },
};

/** `place`: begins the test ids, because an option can be in two places. */
export function createFitFields(
  options: readonly FitOption[],
  place: string,
  onMotion: (change: Partial<Motion>) => void,
): Component<Motion> {
  const rows = options.map((name) => createRow(name, place, (value) => onMotion({ [name]: value })));
  return {
    element: h('div', { class: 'group' }, ...rows.map(({ element }) => element)),
    update: (motion) => rows.forEach((row, i) => row.update(motion[options[i]!])),
  };
}

function createRow(name: FitOption, place: string, onInput: (value: number) => void): Component<number> {
  const { min, max, default: fallback } = MOTION[name];
  const { label, testId, unit: of, hint } = WORDS[name];
  const field = numberField({
    label: of ? `${label}, ${of}` : label,
    testId: `${place}-${testId}`,
    min,
    max,
    step: 1,
    onInput: (value) => onInput(Math.round(value)),
  });
  const reset = button({
    label: `Reset ${label.toLowerCase()} to ${fallback.toLocaleString('en')}`,
    testId: `${place}-${testId}-reset`,
    icon: 'reset',
    onClick: () => onInput(fallback),
  });
  return {
    element: h(
      'div',
      { class: 'group' },
      fieldRow(label, field, ...(of ? [unit(of)] : []), reset),
      h('p', { class: 'hint' }, hint),
    ),
    update(value) {
      setField(field, String(value));
      setIdle(reset, value === fallback);
    },
  };
}
