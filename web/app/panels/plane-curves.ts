/** Additional curves of the shape plane, with their text. */
import { OWN_METHOD } from '../../engine/api/methods.ts';
import type { Motion } from '../../engine/api/api.ts';
import { EngineError } from '../../engine/api/errors.ts';
import type { PlaneOverlay } from '../../plots/shape-plane.ts';
import { checkbox, numberField } from '../../ui/controls.ts';
import { h, setField, setHidden, setText } from '../../ui/dom.ts';
import { METHOD_WORDS } from '../../model/method-words.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import { inPlane } from '../analysis/shape-plane.ts';
import { minimisedCurve, outsideCurves } from '../analysis/plane-overlays.ts';
import type { MinimisedCurve, OutsideCurve } from '../analysis/plane-overlays.ts';
import { NO_CHOICES } from '../view/view-state.ts';
import type { ChartChoices } from '../view/view-state.ts';
import type { ChoiceEvents } from './chart-figure.ts';

export interface PlaneCurves {
  element: HTMLElement;
  /** Call when the motions may have changed. */
  show(input: AnalysisInput): Promise<void>;
  choose(choices: PlaneChoices): void;
}

type PlaneChoices = Pick<ChartChoices, 'minimised' | 'samples'>;

export interface PlaneCurvesEvents extends ChoiceEvents {
  onOverlays(overlays: readonly PlaneOverlay[]): void;
  onError(error: unknown): void;
}

const MAX_SAMPLES = 400;
/** Motions outside the plane are slow to encode, so they wait for a pause between edits. */
const REST_MS = 300;
const percent = (share: number): string => `${Number((100 * share).toPrecision(2))}\u00a0%`;

export function createPlaneCurves({ onOverlays, onCharts, onError }: PlaneCurvesEvents): PlaneCurves {
  let input: AnalysisInput | null = null;
  let outside: OutsideCurve[] = [];
  let least = NONE;
  let timer = 0;
  const note = h('p', { class: 'plane-note', 'data-testid': 'plane-notes' });
  const onFound = (found: Further): void => {
    least = found;
    draw();
  };
  const minimised = createMinimised({ onFound, onCharts, onError });
  const element = h('div', { class: 'group' }, minimised.element, note);

  const draw = (): void => {
    onOverlays([...outside.map(outsideOverlay), ...least.overlays]);
    const sentences = [...least.sentences, ...outside.map(outsideWords)];
    setHidden(note, sentences.length === 0);
    setText(note, sentences.join(' '));
  };
  const setBusy = (busy: boolean): void => element.setAttribute('aria-busy', `${busy}`);
  const refreshOutside = async (of: AnalysisInput): Promise<void> => {
    try {
      const found = await outsideCurves(of);
      if (input === of) outside = found;
    } finally {
      if (input === of) setBusy(false);
    }
    draw();
  };

  return {
    element,
    choose: minimised.choose,
    async show(next) {
      input = next;
      outside = [];
      window.clearTimeout(timer);
      const leaves = !next.sequences.every(inPlane);
      setBusy(leaves);
      await minimised.show(next);
      if (leaves) timer = window.setTimeout(() => void refreshOutside(next).catch(onError), REST_MS);
    },
  };
}

interface Further {
  overlays: PlaneOverlay[];
  sentences: string[];
}

const NONE: Further = { overlays: [], sentences: [] };

interface MinimisedEvents extends ChoiceEvents {
  onFound(found: Further): void;
  onError(error: unknown): void;
}

/** The minimiser's samples, if shown. */
function createMinimised({ onFound, onCharts, onError }: MinimisedEvents): PlaneCurves {
  let input: AnalysisInput | null = null;
  let chosen: PlaneChoices = NO_CHOICES;
  let asked = 0;
  const count = numberField({
    label: 'Samples of the minimisation',
    testId: 'minimised-samples',
    min: 4,
    max: MAX_SAMPLES,
    step: 1,
    onInput: (samples) => onCharts({ samples }),
  });
  count.value = count.defaultValue = String(chosen.samples);
  const toggle = checkbox('Minimised over', 'minimised', (minimised) => onCharts({ minimised }));
  toggle.element.id = 'minimised';
  toggle.element.title =
    'The samples with the least total bending for fixed keys, found by minimising over all of them. The spline ' +
    'finds nearly the same curve from one equation per key';
  const element = h('div', { class: 'plane-tools' }, toggle.element, count, h('span', {}, 'samples'));

  const refresh = async (): Promise<void> => {
    const spline = input?.sequences.find((one) => one.method === OWN_METHOD && inPlane(one));
    setHidden(element, !spline);
    const mine = ++asked;
    const found = chosen.minimised && spline ? await minimiseBending(spline.sequence, chosen.samples, onError) : NONE;
    if (mine === asked) onFound(found);
  };
  return {
    element,
    show(next) {
      input = next;
      return refresh();
    },
    choose(next) {
      const same = next.minimised === chosen.minimised && next.samples === chosen.samples;
      chosen = next;
      if (same) return;
      toggle.update(next.minimised);
      setField(count, String(next.samples));
      void refresh();
    },
  };
}

async function minimiseBending(spline: Motion, samples: number, onError: (error: unknown) => void): Promise<Further> {
  try {
    const found = await minimisedCurve(spline, samples);
    const overlay = { label: 'Least bending', points: found.points, style: 'minimised', marked: true };
    return { overlays: [overlay], sentences: [minimisedWords(found, samples)] };
  } catch (error) {
    // This sample count is invalid for these keys. The core gives the reason.
    if (error instanceof EngineError && error.code === 'invalid-option') return { ...NONE, sentences: [error.message] };
    onError(error);
    return NONE;
  }
}

function outsideOverlay({ method, points }: OutsideCurve): PlaneOverlay {
  return { label: METHOD_WORDS[method].label, points, style: method, marked: false };
}

function minimisedWords({ energy, splineEnergy, off }: MinimisedCurve, samples: number): string {
  const more = energy > 0 ? Math.abs(splineEnergy / energy - 1) : 0;
  return (
    `The minimiser with ${samples} samples is at most ${percent(off)} of the keys\u2019 extent away from the spline. ` +
    `Its bending energy differs by at most ${percent(more)}.`
  );
}

function outsideWords({ method, off }: OutsideCurve): string {
  return `${METHOD_WORDS[method].label}: up to ${percent(off)} of the mean distance between keys away from this plane.`;
}
