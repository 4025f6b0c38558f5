/** Choice of an animation's keys: a number of evenly spaced times, or the fewest within an error. */
import { MAX_SAMPLED } from '../engine/api/option-table.ts';
import { fieldRow, numberField } from './controls.ts';
import { h, say, setField, uniqueId } from './dom.ts';

/** Range of the error for the fewest keys, in percent of the diagonal. */
const TOLERANCE = { min: 0.1, max: 20, default: 2 };

export interface SamplingModeEvents {
  onCount(count: number): void;
  /** Resolves when the keys are in use, or the search has failed or been cancelled. */
  onFewest(percent: number): Promise<void>;
}

export interface SamplingMode {
  elements: HTMLElement[];
  /** `taken`: the keys are from the animation. `fewest`: they were found for an error. */
  update(taken: boolean, fewest: boolean): void;
  /** Shows the number of keys, even while a number is being typed. */
  setCount(count: number, taken: boolean): void;
}

export function createSamplingMode({ onCount, onFewest }: SamplingModeEvents): SamplingMode {
  let chosen = 0;
  let [isTaken, isFewest] = [false, false];
  /** Number of running searches for the fewest keys. */
  let searching = 0;
  const limitHint = h('p', { class: 'reason', role: 'status', 'data-testid': 'sample-most', hidden: true });
  const count = numberField({
    label: 'Number of keys; changing it spaces them evenly',
    testId: 'sample-count',
    min: 2,
    step: 1,
    onInput(value) {
      onCount(Math.min(value, MAX_SAMPLED));
      say(limitHint, value > MAX_SAMPLED ? `At most ${MAX_SAMPLED} keys can be sampled.` : '');
    },
  });
  const tolerance = numberField({
    label: 'Largest error in percent of the model’s size',
    testId: 'sample-tolerance',
    min: TOLERANCE.min,
    max: TOLERANCE.max,
    onInput(value) {
      setField(tolerance, String(value));
      void search();
    },
  });
  tolerance.value = tolerance.defaultValue = String(TOLERANCE.default);
  const name = uniqueId('sample-way');
  const byCount = h('input', {
    type: 'radio',
    name,
    'data-testid': 'sample-number',
    onchange: () => onCount(count.valueAsNumber || chosen),
  });
  const byError = h('input', { type: 'radio', name, 'data-testid': 'sample-fewest', onchange: () => void search() });

  const search = async (): Promise<void> => {
    searching += 1;
    draw();
    await onFewest(tolerance.valueAsNumber || TOLERANCE.default);
    searching -= 1;
    draw();
  };
  const draw = (): void => {
    byError.checked = searching > 0 || isFewest;
    byCount.checked = !byError.checked && isTaken;
  };
  return {
    elements: [
      fieldRow(modeLabel(byCount, 'Number of keys', 'Keys at even times'), count),
      limitHint,
      fieldRow(
        modeLabel(byError, 'Fewest within', 'As few keys as needed to stay within this error'),
        tolerance,
        h('span', { class: 'muted' }, '%'),
      ),
    ],
    update(taken, fewest) {
      [isTaken, isFewest] = [taken, fewest];
      draw();
    },
    setCount(keys, taken) {
      chosen = keys;
      const shown = taken ? String(keys) : '';
      setField(count, shown);
      count.value = shown;
      count.placeholder = String(keys);
    },
  };
}

function modeLabel(input: HTMLInputElement, text: string, hint: string): HTMLElement {
  return h('label', { class: 'check label', title: hint }, input, h('span', {}, text));
}
