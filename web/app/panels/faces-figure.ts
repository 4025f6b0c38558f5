/** Patches and faces: heat maps on the surface, and the coordinates of what is clicked over time. */
import { isFaceAmount } from '../../model/state.ts';
import type { Colouring, FaceAmount } from '../../model/state.ts';
import { numberField, segments } from '../../ui/controls.ts';
import { h, setField, setHidden, setText } from '../../ui/dom.ts';
import { EngineError } from '../../engine/api/errors.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { Compared } from '../analysis/motion-distance.ts';
import type { ChartEvents } from './chart-figure.ts';
import type { DistanceFigure, DistanceFigureProps } from './distance-figure.ts';
import { createFaceCharts } from './face-charts.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import { createPatchCharts } from './patch-charts.ts';

export interface FacesFigureEvents extends ChartEvents {
  onColouring(colouring: Colouring): void;
  /** What distances are from; null where nothing is open. */
  compared(): Compared | null;
  /** An animation to compare with is to be chosen, or is not wanted any more. */
  onPickTruth(): void;
  onLeaveTruth(): void;
  /** Marks what moves with a face, or these patches; null: nothing. */
  onMark(what: { face: number } | { patches: number[] } | null): void;
}

export interface FacesFigureProps {
  cursor: number;
  colouring: Colouring;
  /** Another number: the motions may be others. */
  version: number;
}

export interface FacesFigure {
  element: HTMLElement;
  /** The picture was clicked: where the figure's panel is open, what is there is shown; -1 for none. */
  clicked(pick: () => number): void;
  update(props: FacesFigureProps): void;
}

type Heat = FaceAmount | 'distance' | 'none';
type Part = 'face' | 'patch';

const nothing = (): void => undefined;

const HINT = 'Click the picture: the coordinates there over time, as the spline has them.';

export function createFacesFigure(input: () => AnalysisInput | null, events: FacesFigureEvents): FacesFigure {
  const { onColouring, onMark, onError } = events;
  const heat = segments<Heat>(
    'Colour the surface',
    'heat',
    [
      { value: 'none', label: 'Off' },
      { value: 'rotation', label: 'Rotation', hint: 'The angle by which each face is turned against the reference' },
      { value: 'stretch', label: 'Stretch', hint: 'How much longer or shorter each face is than in the reference' },
      {
        value: 'distance',
        label: 'Distance',
        hint: 'How far what is compared is from the first motion or the animation',
      },
    ],
    (value) => onColouring(value === 'none' ? 'texture' : value),
  );
  const distance = lazyComponent<DistanceFigureProps, DistanceFigure>(async () => {
    const { createDistanceFigure } = await import('./distance-figure.ts');
    return createDistanceFigure({ ...events, input });
  }, onError);
  const part = segments<Part>(
    'Coordinates over time',
    'part',
    [
      { value: 'face', label: 'Face', hint: 'How a face turns in its patch, and how it stretches' },
      { value: 'patch', label: 'Patch', hint: 'How a patch turns against its neighbours, and how it stretches' },
    ],
    (value) => choose(value),
  );
  // The engine counts patches from 0.
  const typed = (of: Part, value: number) => (error: unknown) =>
    onError(
      error instanceof EngineError && error.code === 'invalid-option'
        ? new Error(`There is no ${of} ${value}.`)
        : error,
    );
  const number = (of: Part, label: string, first: number): HTMLInputElement =>
    numberField({
      label,
      testId: `${of}-number`,
      min: first,
      step: 1,
      empty: NaN,
      onInput: (value) =>
        Number.isNaN(value) ? show(of, null) : show(of, Math.round(value) - first, typed(of, Math.round(value))),
    });
  const fields = {
    face: number('face', 'Face, counted from 0 as in the file', 0),
    patch: number('patch', 'Patch, counted from 1', 1),
  };
  fields.face.placeholder = 'Face';
  fields.patch.placeholder = 'Patch';
  const said = h('span', { class: 'muted', 'aria-live': 'polite', 'data-testid': 'face-patch' });
  const charts = {
    face: createFaceCharts(events),
    patch: createPatchCharts(events, (neighbour) => {
      if (shown.patch !== null) onMark({ patches: [shown.patch, ...(neighbour === null ? [] : [neighbour])] });
    }),
  };
  const element = h(
    'section',
    { class: 'group', 'aria-label': 'Patches and faces', 'data-testid': 'faces' },
    heat.element,
    distance.element,
    part.element,
    h('p', { class: 'plane-note' }, HINT),
    h('div', { class: 'plane-tools' }, fields.face, fields.patch, said),
    charts.face.element,
    charts.patch.element,
  );
  let chosen: Part = 'face';
  /** null: none. */
  const shown: Record<Part, number | null> = { face: null, patch: null };
  let props: FacesFigureProps = { cursor: 0, colouring: 'texture', version: 0 };

  // What was chosen in another shape, or of other patches, may not be there any more: nothing is wrong then.
  const load = (of: Part, onMissing: (error: unknown) => void = nothing): void => {
    charts[of]
      .load(shown[of], input())
      .then((words) => {
        if (words === '' && shown[of] !== null) return;
        if (of === chosen) setText(said, words);
        charts[of].setCursor(props.cursor);
      })
      .catch((error: unknown) => {
        show(of, null);
        onMissing(error);
      });
  };
  const show = (of: Part, index: number | null, onMissing?: (error: unknown) => void): void => {
    shown[of] = index;
    setField(fields[of], index === null ? '' : String(index + (of === 'face' ? 0 : 1)));
    if (index === null) setText(said, '');
    if (index === null || of === 'face') onMark(index === null ? null : { face: index });
    load(of, onMissing);
  };
  const choose = (next: Part): void => {
    chosen = next;
    part.update(next);
    for (const of of ['face', 'patch'] as const) {
      setHidden(fields[of], of !== next);
      setHidden(charts[of].element, of !== next || shown[of] === null);
    }
    show(next, shown[next]);
  };
  /** The patch of the face that is there. */
  const patchAt = async (face: number): Promise<number | null> => {
    const patches = await input()?.sequences[0]?.sequence.shape.patches();
    const patch = patches?.[face] ?? -1;
    return patch < 0 ? null : patch;
  };
  part.update(chosen);
  setHidden(fields.patch, true);

  return {
    element,
    clicked(pick) {
      if (!element.checkVisibility()) return;
      const face = pick();
      if (face < 0 && shown[chosen] === null) return;
      if (face < 0 || chosen === 'face') show(chosen, face < 0 ? null : face);
      else patchAt(face).then((patch) => show('patch', patch), onError);
      if (face >= 0) element.scrollIntoView({ block: 'nearest' });
    },
    update(next) {
      const before = props;
      props = next;
      const { colouring, cursor, version } = next;
      const byDistance = colouring === 'distance';
      heat.update(isFaceAmount(colouring) || byDistance ? colouring : 'none');
      distance.update({ shown: byDistance, cursor, version });
      if (byDistance) void distance.need();
      for (const one of Object.values(charts)) one.setCursor(cursor);
      if (version !== before.version && shown[chosen] !== null) load(chosen);
    },
  };
}
