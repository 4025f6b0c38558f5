/** The figure of the shape plane. Its curve takes a millisecond to compute, so it follows every change immediately. */
import { DEFAULT_SPEED, USUAL_MAX_SPEEDS, formatSpeed, offeredSpeed } from '../../model/speeds.ts';
import type { End, Speeds } from '../../model/speeds.ts';
import type { EndHandleEvents } from '../../plots/end-handle.ts';
import { createShapePlane } from '../../plots/shape-plane.ts';
import type { ShapePlaneData } from '../../plots/shape-plane.ts';
import { h, setHidden, setText } from '../../ui/dom.ts';
import { METHOD_WORDS } from '../../model/method-words.ts';
import { SPEED_WORDS, typedSpeed } from '../../ui/speed-handles.ts';
import type { AnalysisInput } from '../analysis/analysis.ts';
import { computeShapePlanes, knownShapes } from '../analysis/shape-plane.ts';
import type { ShapePlanes } from '../analysis/shape-plane.ts';
import type { FigureNumbers } from './figure-files.ts';
import type { ChoiceEvents } from './chart-figure.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';
import { createOffCurve } from './off-curve.ts';
import { createPlaneCurves } from './plane-curves.ts';
import type { PlaneCurves } from './plane-curves.ts';
import type { Blend } from '../view/view-state.ts';

export interface ShapePlaneFigureEvents extends FigureEvents, ChoiceEvents {
  onSpeed(end: End, speed: number): void;
  onBlend(blend: Blend | null): void;
}

export interface ShapePlaneFigure {
  element: HTMLElement;
  /** Call when the curve has changed. */
  refresh(): void;
  choose: PlaneCurves['choose'];
  setCursor(t: number): void;
  /** The shape shown instead of the motion's, or null. */
  setBlend(blend: Blend | null, keys: readonly { name: string }[]): void;
  /** Hermite: lengths of the end handles (null for none), and the largest offered lengths. */
  setSpeeds(speeds: Speeds | null, max: Speeds): void;
}

const POINT_LABEL = 'The current shape. Arrow keys move it off the curve, Escape returns it to the curve.';
const TITLE =
  'The plane of the keys’ two leading principal components; distances in the plane approximate distances between shapes';

export function createShapePlaneFigure(
  input: () => AnalysisInput | null,
  { onSpeed, onBlend, onEnlarge, onCharts, onError }: ShapePlaneFigureEvents,
): ShapePlaneFigure {
  const ends = createEndEvents(onSpeed);
  const offCurve = createOffCurve(() => plot, onBlend);
  const plot = createShapePlane({
    pointLabel: POINT_LABEL,
    onPoint: offCurve.onPoint,
    onPath: offCurve.onPath,
    onPointKey: offCurve.onPointKey,
    ...ends.events,
  });
  const curves = createPlaneCurves({ onOverlays: plot.setOverlays, onCharts, onError });
  const explained = h('span', { class: 'unit' });
  const title = 'Shape plane';
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': 'plot-plane' },
    h('figcaption', { title: TITLE }, h('strong', {}, title), explained),
    plot.element,
    offCurve.element,
    curves.element,
  );
  let known: FigureNumbers | null = null;
  const redrawn = addFigureTools(element, { plot: 'plane', title, numbers: () => known, onEnlarge, onError });

  const setBusy = (busy: boolean): void => element.setAttribute('aria-busy', `${busy}`);
  const refresh = oneAfterTheOther(setBusy, onError, async () => {
    const asked = input();
    if (!asked) return;
    const computed = await computeShapePlanes(asked);
    const main = computed.planes[0]?.plane;
    setHidden(element, !main);
    if (!main) return;
    setText(explained, `Principal plane of the keys, explains ${(100 * main.explained).toFixed(0)} % of the variance`);
    plot.draw(planeData(computed, main.keys));
    known = { ...planeNumbers(computed), keep: asked.keyTimes };
    redrawn();
    offCurve.setShapes(knownShapes(main));
    await curves.show(asked);
  });

  return {
    element,
    refresh,
    setCursor(t) {
      plot.setCursor(t);
      offCurve.setCurvePoint(plot.curvePoint(t));
    },
    choose: curves.choose,
    setBlend: offCurve.update,
    setSpeeds(speeds, max) {
      ends.setSpeeds(speeds, max);
      plot.setSpeeds(speeds, max);
    },
  };
}

/** Maps the end handles to end speeds. */
function createEndEvents(onSpeed: ShapePlaneFigureEvents['onSpeed']) {
  let speeds: Speeds | null = null;
  let max = USUAL_MAX_SPEEDS;
  // Several events can arrive before the page is redrawn. Each builds on the previous request.
  const set = (end: End, speed: number): void => {
    if (speeds) speeds = { ...speeds, [end]: speed };
    onSpeed(end, speed);
  };
  const events: EndHandleEvents = {
    label: (end) => SPEED_WORDS[end].label,
    words: formatSpeed,
    onSpeed: (end, speed) => set(end, offeredSpeed(speed, max[end])),
    onReset: (end) => set(end, DEFAULT_SPEED),
    onKey(end, event) {
      const speed = typedSpeed(event, speeds?.[end] ?? DEFAULT_SPEED, end, max[end]);
      if (speed === null) return;
      event.preventDefault();
      set(end, speed);
    },
  };
  const setSpeeds: ShapePlaneFigure['setSpeeds'] = (next, nextMax) => {
    [speeds, max] = [next, nextMax];
  };
  return { events, setSpeeds };
}

/** Repeats the work once if it was called again in the meantime. */
function oneAfterTheOther(
  setBusy: (busy: boolean) => void,
  onError: (error: unknown) => void,
  work: () => Promise<void>,
): () => Promise<void> {
  let stale = false;
  let running = false;
  return async () => {
    stale = true;
    if (running) return;
    running = true;
    setBusy(true);
    while (stale) {
      stale = false;
      await work().catch(onError);
    }
    running = false;
    setBusy(false);
  };
}

function planeData({ times, range, planes, tangents }: ShapePlanes, keys: readonly number[]): ShapePlaneData {
  const curves = planes.map(({ method, plane }) => ({
    label: METHOD_WORDS[method].label,
    points: plane.curve,
    style: method,
  }));
  return { times, range, keys, tangents, curves };
}

function planeNumbers({ times, planes }: ShapePlanes): FigureNumbers {
  return {
    names: ['Time', ...planes.flatMap(({ method }) => [1, 2].map((n) => `${METHOD_WORDS[method].label} PC${n}`))],
    rows: times.map((t, i) => [t, ...planes.flatMap(({ plane: { curve } }) => [curve[2 * i]!, curve[2 * i + 1]!])]),
  };
}
