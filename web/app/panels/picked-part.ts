/** A face or patch, picked by click or by number: its number field and charts. */
import { EngineError } from '../../engine/api/errors.ts';
import { numberField } from '../../ui/controls.ts';
import { setField, setHidden } from '../../ui/dom.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { ChartChoices } from '../view/view-state.ts';
import type { PartCharts } from './face-charts.ts';

export type Part = ChartChoices['part'];

export interface PickedPartEvents {
  input(): AnalysisInput | null;
  /** The user has picked a part, or the picked one does not exist; null for none. */
  onPick(index: number | null): void;
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

export function createPickedPart(part: Part, charts: PartCharts, events: PickedPartEvents) {
  const { input, onPick, onShow, onWords, onError } = events;
  const { label, placeholder, first } = FIELDS[part];
  const field = numberField({
    label,
    testId: `${part}-number`,
    min: first,
    step: 1,
    empty: NaN,
    onInput(value) {
      typed = Number.isNaN(value) ? null : value - first;
      onPick(typed);
    },
  });
  field.id = `${part}-number`;
  field.placeholder = placeholder;
  let typed: number | null = null;
  let shown: number | null = null;
  let cursor = 0;
  // A part chosen earlier may not exist in another shape or in other patches. This is not an error.
  const fail = (index: number | null, error: unknown): void => {
    onPick(null);
    if (index === null || index !== typed) return;
    onError(isMissing(error) ? new Error(`There is no ${part} ${index + first}.`) : error);
  };
  const load = async (): Promise<void> => {
    const index = shown;
    try {
      const words = await charts.load(index, input());
      if (words === '' && index !== null) return;
      onWords(words);
      charts.setCursor(cursor);
    } catch (error) {
      fail(index, error);
    } finally {
      typed = null;
    }
  };
  return {
    field,
    element: charts.element,
    /** Counted from 0; null for none. */
    show(index: number | null): void {
      shown = index;
      setField(field, index === null ? '' : String(index + first));
      if (index === null) onWords('');
      onShow(index);
      void load();
    },
    /** Call when the motion has changed. */
    refresh(): void {
      if (shown !== null) void load();
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
