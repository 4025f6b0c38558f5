/** Patches and faces: heat maps on the surface, and the clicked face's or patch's coordinates over time. */
import { isFaceAmount } from '../../model/state.ts';
import type { Colouring, FaceAmount } from '../../model/state.ts';
import { segments } from '../../ui/controls.ts';
import { h, setText } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import type { Compared } from '../analysis/motion-distance.ts';
import type { ChartEvents, ChoiceEvents } from './chart-figure.ts';
import { NO_CHOICES } from '../view/view-state.ts';
import type { ChartChoices } from '../view/view-state.ts';
import type { DistanceFigure, DistanceFigureProps } from './distance-figure.ts';
import { createFaceCharts } from './face-charts.ts';
import { createPatchCharts } from './patch-charts.ts';
import { createPickedPart } from './picked-part.ts';
import type { Part } from './picked-part.ts';

export interface FacesFigureEvents extends ChartEvents, ChoiceEvents {
  onColouring(colouring: Colouring): void;
  /** Reference of distances; null if nothing is open. */
  compared(): Compared | null;
  /** Lets the user choose or remove an animation to compare with. */
  onPickReference(): void;
  onLeaveReference(): void;
  /** Marks the region that moves with a face, or these patches; null clears the marker. */
  onMark(what: { face: number } | { patches: number[] } | null): void;
}

export interface FacesFigureProps {
  cursor: number;
  colouring: Colouring;
  charts: ChartChoices;
  /** A number that increases when the motions may have changed. */
  version: number;
}

export interface FacesFigure {
  element: HTMLElement;
  /** The viewport was clicked. If the figure's panel is open, shows the picked face; -1 for none. */
  clicked(pick: () => number): void;
  update(props: FacesFigureProps): void;
}

type Heat = FaceAmount | 'distance' | 'none';

const HINT = 'Click the shape to plot a face’s coordinates over time.';

export function createFacesFigure(input: () => AnalysisInput | null, events: FacesFigureEvents): FacesFigure {
  const { onMark, onCharts, onError } = events;
  let charts = NO_CHOICES;
  const colours = createSurfaceColours(input, events);
  const choice = segments<Part>(
    'Coordinates over time',
    'part',
    [
      { value: 'face', label: 'Face', hint: 'Rotation of a face within its patch, and its stretch' },
      { value: 'patch', label: 'Patch', hint: 'Rotation of a patch relative to its neighbours, and its stretch' },
    ],
    (part) => onCharts({ part }),
  );
  const said = h('span', { class: 'muted', 'aria-live': 'polite', 'data-testid': 'face-patch' });
  const eventsOf = (part: Part) => ({
    input,
    onPick: (index: number | null) => onCharts({ [part]: index }),
    onWords: (words: string) => charts.part === part && setText(said, words),
    onError,
  });
  const neighbours = createPatchCharts({
    ...events,
    onPair(neighbour) {
      if (charts.patch !== null) onMark({ patches: [charts.patch, ...(neighbour === null ? [] : [neighbour])] });
    },
    onNeighbour: (neighbour) => onCharts({ neighbour }),
  });
  const parts = {
    face: createPickedPart('face', createFaceCharts(events), {
      ...eventsOf('face'),
      onShow: (face) => onMark(face === null ? null : { face }),
    }),
    // Marks a patch and its neighbour, as soon as the neighbour is known.
    patch: createPickedPart('patch', neighbours, {
      ...eventsOf('patch'),
      onShow: (patch) => patch === null && onMark(null),
    }),
  };
  const choose = (next: ChartChoices): void => {
    const before = charts;
    charts = next;
    const { part } = next;
    choice.update(part);
    neighbours.setNeighbour(next.neighbour);
    for (const one of ['face', 'patch'] as const) parts[one].setHidden(one !== part);
    // Otherwise, its charts would appear again once their curves have arrived.
    if (before.part !== part) parts[before.part].show(null);
    if (before.part !== part || before[part] !== next[part]) parts[part].show(next[part]);
  };
  choose(charts);
  const element = h(
    'section',
    { class: 'group', id: 'faces', 'aria-label': 'Patches and faces', 'data-testid': 'faces' },
    ...colours.elements,
    choice.element,
    h('p', { class: 'plane-note' }, HINT),
    h('div', { class: 'plane-tools' }, parts.face.field, parts.patch.field, said),
    parts.face.element,
    parts.patch.element,
  );
  let version = 0;

  return {
    element,
    clicked(pick) {
      if (!element.checkVisibility()) return;
      const face = pick();
      const { part } = charts;
      const picked = (index: number | null): void =>
        index === charts[part] ? parts[part].show(index) : onCharts({ [part]: index });
      if (face < 0 && charts[part] === null) return;
      if (face < 0 || part === 'face') picked(face < 0 ? null : face);
      else patchAt(input(), face).then(picked, onError);
      if (face >= 0) element.scrollIntoView({ block: 'nearest' });
    },
    update(props) {
      colours.update(props);
      for (const part of Object.values(parts)) part.setCursor(props.cursor);
      if (props.charts !== charts) choose(props.charts);
      if (props.version !== version) parts[charts.part].refresh();
      version = props.version;
    },
  };
}

/** The choice of surface colours, and the distance figure while colours show the distance. */
function createSurfaceColours(input: () => AnalysisInput | null, events: FacesFigureEvents) {
  const heat = segments<Heat>(
    'Colour the surface',
    'heat',
    [
      { value: 'none', label: 'Off' },
      { value: 'rotation', label: 'Rotation', hint: 'Rotation angle of each face relative to the reference' },
      { value: 'stretch', label: 'Stretch', hint: 'Stretch of each face relative to the reference' },
      {
        value: 'distance',
        label: 'Distance',
        hint: 'Distance of the compared motion from the first motion or the animation',
      },
    ],
    (value) => events.onColouring(value === 'none' ? 'texture' : value),
  );
  const distance = lazyComponent<DistanceFigureProps, DistanceFigure>(async () => {
    const { createDistanceFigure } = await import('./distance-figure.ts');
    return createDistanceFigure({ ...events, input });
  }, events.onError);
  return {
    elements: [heat.element, distance.element],
    update({ colouring, cursor, version }: FacesFigureProps): void {
      const byDistance = colouring === 'distance';
      heat.update(isFaceAmount(colouring) || byDistance ? colouring : 'none');
      distance.update({ shown: byDistance, cursor, version });
      if (byDistance) void distance.need();
    },
  };
}

/** The patch of a face; null if it belongs to none. */
async function patchAt(input: AnalysisInput | null, face: number): Promise<number | null> {
  const patches = await input?.sequences[0]?.sequence.shape.patches();
  const patch = patches?.[face] ?? -1;
  return patch < 0 ? null : patch;
}
