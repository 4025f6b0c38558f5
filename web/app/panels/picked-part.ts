/** A face or patch, picked by click or by number: its number field and charts. */
import { EngineError } from '../../engine/api/errors.ts';
import { numberField } from '../../ui/controls.ts';
import { setField, setHidden } from '../../ui/dom.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { PartCharts } from './face-charts.ts';

export type Part = 'face' | 'patch';

export interface PickedPartEvents {
  input(): AnalysisInput | null;
  /** Reports the shown part; null for none. */
  onShow(index: number | null): void;
  /** Reports the text about the part. */
  onWords(words: string): void;
  onError(error: unknown): void;
}

/** The engine counts patches from 0. */
const FIELDS = {
  face: { label: 'Face, counted from 0 as in the file', placeholder: 'Face', first: 0 },
  patch: { label: 'Patch, counted from 1', placeholder: 'Patch', first: 1 },
};

const nothing = (): void => undefined;

export function createPickedPart(part: Part, charts: PartCharts, events: PickedPartEvents) {
  const { input, onShow, onWords, onError } = events;
  const { label, placeholder, first } = FIELDS[part];
  const field = numberField({
    label,
    testId: `${part}-number`,
    min: first,
    step: 1,
    empty: NaN,
    onInput(value) {
      if (Number.isNaN(value)) return show(null);
      const typed = Math.round(value);
      show(typed - first, (error) => onError(isMissing(error) ? new Error(`There is no ${part} ${typed}.`) : error));
    },
  });
  field.placeholder = placeholder;
  let shown: number | null = null;
  let cursor = 0;
  // A part chosen earlier may not exist in another shape or in other patches. This is not an error.
  const load = (onMissing: (error: unknown) => void = nothing): void => {
    charts
      .load(shown, input())
      .then((words) => {
        if (words === '' && shown !== null) return;
        onWords(words);
        charts.setCursor(cursor);
      })
      .catch((error: unknown) => {
        show(null);
        onMissing(error);
      });
  };
  const show = (index: number | null, onMissing?: (error: unknown) => void): void => {
    shown = index;
    setField(field, index === null ? '' : String(index + first));
    if (index === null) onWords('');
    onShow(index);
    load(onMissing);
  };
  return {
    field,
    element: charts.element,
    /** Counted from 0; null if none is picked. */
    get index(): number | null {
      return shown;
    },
    show: (index: number | null): void => show(index),
    /** Call when the motion has changed. */
    refresh(): void {
      if (shown !== null) load();
    },
    setHidden(hidden: boolean): void {
      setHidden(field, hidden);
      setHidden(charts.element, hidden || shown === null);
    },
    setCursor(t: number): void {
      cursor = t;
      charts.setCursor(t);
    },
  };
}

function isMissing(error: unknown): boolean {
  return error instanceof EngineError && error.code === 'invalid-option';
}
