/** The Analysis panel: shape plane and measures of the shown motions over time, computed when idle. */
import type { End } from '../../model/speeds.ts';
import type { Colouring } from '../../model/state.ts';
import { setAttribute } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { BendingEvents } from './bending-figure.ts';
import type { FacesFigure, FacesFigureEvents, FacesFigureProps } from './faces-figure.ts';
import { createMeasureCharts } from './measure-charts.ts';
import { createShapePlaneFigure } from './shape-plane-figure.ts';
import type { ShapePlaneFigure } from './shape-plane-figure.ts';
import { NO_CHOICES } from '../view/view-state.ts';
import type { Blend, ChartChoices } from '../view/view-state.ts';

export interface AnalysisPanelEvents extends FacesFigureEvents, BendingEvents {
  onSpeed(end: End, speed: number): void;
  onBlend(blend: Blend | null): void;
}

export interface AnalysisPanelProps {
  time: number;
  colouring: Colouring;
  charts: ChartChoices;
  blend: Parameters<ShapePlaneFigure['setBlend']>[0];
  keys: Parameters<ShapePlaneFigure['setBlend']>[1];
  speeds: Parameters<ShapePlaneFigure['setSpeeds']>[0];
  maxSpeeds: Parameters<ShapePlaneFigure['setSpeeds']>[1];
}

export interface AnalysisPanel {
  element: HTMLElement;
  update(props: AnalysisPanelProps): void;
  clicked: FacesFigure['clicked'];
}

/** Nothing is computed during rapid edits. */
const DELAY_MS = 200;

/** Fills `element`. */
export function createAnalysisPanel(
  element: HTMLElement,
  cache: AnalysisCache,
  events: AnalysisPanelEvents,
): AnalysisPanel {
  const { onError } = events;
  const plane = createShapePlaneFigure(cache.input, events);
  const faces = lazyComponent<FacesFigureProps, FacesFigure>(async () => {
    const { createFacesFigure } = await import('./faces-figure.ts');
    return createFacesFigure(cache.input, events);
  }, onError);
  void faces.need();
  let facesProps: FacesFigureProps = { cursor: 0, colouring: 'texture', charts: NO_CHOICES, version: 0 };
  const updateFaces = (change: Partial<FacesFigureProps>): void => {
    facesProps = { ...facesProps, ...change };
    faces.update(facesProps);
  };
  const charts = createMeasureCharts(cache.input, events);
  element.append(charts.legend, plane.element, ...charts.elements, faces.element);
  let visible = false;
  let timer = 0;
  let cursor = 0;

  const setCursor = (t: number): void => {
    cursor = t;
    plane.setCursor(t);
    updateFaces({ cursor: t });
    charts.setCursor(t);
  };

  const computeSoon = (): void => {
    window.clearTimeout(timer);
    if (visible && cache.stale) timer = window.setTimeout(() => void cache.refresh(), DELAY_MS);
  };

  cache.observe({
    onChange: (isOther) => {
      if (isOther) for (const figure of element.querySelectorAll('.figure')) setAttribute(figure, 'data-gone', true);
      element.dataset['stale'] = '';
      charts.outdate();
      updateFaces({ version: facesProps.version + 1 });
      if (visible) plane.refresh();
    },
    onStale: computeSoon,
    onWorking: charts.setWorking,
    onFresh(analysis) {
      delete element.dataset['stale'];
      charts.draw(analysis);
      setCursor(cursor);
    },
  });

  new IntersectionObserver(([entry]) => {
    visible = entry?.isIntersecting ?? false;
    if (visible && cache.stale) plane.refresh();
    computeSoon();
  }).observe(element);

  return {
    element,
    update({ time, colouring, charts: chosen, blend, keys, speeds, maxSpeeds }) {
      setCursor(time);
      updateFaces({ colouring, charts: chosen });
      charts.choose(chosen);
      plane.choose(chosen);
      plane.setBlend(blend, keys);
      plane.setSpeeds(speeds, maxSpeeds);
    },
    clicked: (pick) => void faces.need().then((figure) => figure?.clicked(pick)),
  };
}
