/** The figures, each with its sentence. */
import { h } from '../ui/dom.ts';
import type { Edits } from './edits.ts';
import { createCurveFigure } from './figures/curve-figure.ts';
import { createFigure } from './figures/figure.ts';
import type { FigureOptions, Part } from './figures/figure.ts';
import { createKeysTable } from './figures/keys-table.ts';
import { createLayerList } from './figures/layer-list.ts';
import { createRateFigure } from './figures/rate-figure.ts';
import { createSystemTable } from './figures/system-table.ts';
import { createWeightsFigure } from './figures/weights-figure.ts';
import { bendingNotice, curveNotice, rateNotice, systemNotice, weightsNotice } from './notices.ts';
import { bendingNumbers, curveNumbers, systemNumbers, weightNumbers } from './numbers.ts';
import { createCurveControls, createEndsChoice, createTools } from './panels.ts';
import type { Panel } from './panels.ts';

/** `appConnection`: the panel that connects to the app. */
export function createBoard(appConnection: Panel, edits: Edits, onError: (error: unknown) => void): Part<HTMLElement> {
  const figure = (options: Omit<FigureOptions, 'onError'>): Part<HTMLElement> => createFigure({ ...options, onError });
  const rate = (id: 'slope' | 'bend', title: string, derivative: 1 | 2): Part<HTMLElement> =>
    figure({
      id,
      title,
      body: createRateFigure(derivative, edits.onTime),
      notice: ({ state, derived }) => rateNotice(state, derived, derivative),
      numbers: ({ state, derived }) => curveNumbers(state, derived, derivative),
    });
  const pictures = [
    figure({
      id: 'curve',
      title: 'The curve',
      body: createCurveFigure(edits),
      tools: createTools(edits),
      notice: ({ state, derived, lastAction }) => curveNotice(state, derived, lastAction),
      numbers: ({ state, derived }) => curveNumbers(state, derived, 0),
    }),
    rate('slope', 'Slope', 1),
    rate('bend', 'Bend', 2),
    figure({
      id: 'weights',
      title: 'Weights',
      body: createWeightsFigure(edits.onTime),
      notice: ({ state, derived }) => weightsNotice(state, derived),
      numbers: ({ derived }) => weightNumbers(derived),
    }),
  ];
  const tables = [
    figure({
      id: 'bending',
      title: 'Curves',
      body: createCurves(edits),
      notice: ({ state, derived }) => bendingNotice(state, derived),
      numbers: ({ derived }) => bendingNumbers(derived),
    }),
    figure({
      id: 'system',
      title: 'The system',
      body: createSystemTable(edits.onLit),
      tools: createEndsChoice(edits),
      notice: ({ state, derived, lit }) => systemNotice(state, derived, lit),
      numbers: ({ derived }) => systemNumbers(derived),
    }),
  ];
  const keys = createKeysTable(edits);
  const elementsOf = (parts: readonly Part<HTMLElement>[]): HTMLElement[] => parts.map(({ element }) => element);
  return {
    element: h(
      'div',
      { class: 'board' },
      ...elementsOf(pictures),
      h(
        'div',
        { class: 'board-side' },
        ...elementsOf(tables),
        h('section', { class: 'keys-as-numbers' }, h('h2', {}, 'Keys as numbers'), keys.element),
        appConnection.element,
      ),
    ),
    update(shown) {
      for (const part of [...pictures, ...tables, keys]) part.update(shown);
      appConnection.update(shown.state);
    },
  };
}

/** The list of curves, with the controls of the shown ones. */
function createCurves(edits: Edits): Part<HTMLElement> {
  const layers = createLayerList(edits.onLayer);
  const controls = createCurveControls(edits);
  return {
    element: h('div', { class: 'curves' }, layers.element, controls.element),
    update(shown) {
      layers.update(shown);
      controls.update(shown.state);
    },
  };
}
