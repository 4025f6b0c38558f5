/** The playground: one state, its figures and controls, drawn anew when something of it changes. */
import { button } from '../ui/controls.ts';
import { h, setAttribute, setHidden, setText } from '../ui/dom.ts';
import { setIcon } from '../ui/icons.ts';
import { clamp } from '../model/time-scale.ts';
import type { Scale } from '../plots/scale.ts';
import { sentence, subscript, unitsOf } from './captions.ts';
import { createDemonstration, SCENES } from './demonstration.ts';
import { derive } from './derived.ts';
import type { Derived } from './derived.ts';
import { createCurveFigure, shownSpan } from './figures/curve-figure.ts';
import { createFigure } from './figures/figure.ts';
import type { Figure } from './figures/figure.ts';
import { createKeysTable } from './figures/keys-table.ts';
import { createLayerList } from './figures/layer-list.ts';
import { listenToTime } from './figures/plot.ts';
import type { Box } from './figures/plot.ts';
import { createRateFigure } from './figures/rate-figure.ts';
import { createSystemTable } from './figures/system-table.ts';
import { createWeightsFigure } from './figures/weights-figure.ts';
import { readLink, writeLink } from './link.ts';
import { bendingNotice, curveNotice, rateNotice, systemNotice, weightsNotice } from './notices.ts';
import type { Touched } from './notices.ts';
import { bendingNumbers, curveNumbers, systemNumbers, weightNumbers } from './numbers.ts';
import { createCurveControls, createEndsChoice, createTools } from './panels.ts';
import type { PanelEvents } from './panels.ts';
import { valueAt } from './splines/curve.ts';
import { INITIAL, addKey, moveKey, removeKey, setEnds, setShaping, showLayer, withKey } from './state.ts';
import type { PlayState } from './state.ts';

export interface PageParts {
  /** Shown at the page's top, such as messages. */
  notices: readonly HTMLElement[];
  /** The window to the app: a coordinate of a real shape. */
  real: { element: HTMLElement; update(state: PlayState): void };
  theme: HTMLElement;
  /** Before the first touch the page plays by itself. */
  playing: boolean;
  onError(error: unknown): void;
  /** A sentence about what the link holds that cannot be shown; null = nothing. */
  onLeftOut(sentence: string | null): void;
}

export interface PlayPage {
  element: HTMLElement;
  get(): PlayState;
  /** Another state, as if somebody had made it. */
  change(state: PlayState, touched: Touched): void;
}

const SAY_MS = 600;
const LINK_MS = 300;

export function createPlayPage(parts: PageParts): PlayPage {
  const opened = readLink(location.hash);
  let state: PlayState = opened?.state ?? INITIAL;
  let derived: Derived = derive(state);
  let touched: Touched = 'key';
  let lit = -1;
  let frame = 0;
  let sayTimer = 0;
  let linkTimer = 0;

  const redraw = (): void => {
    if (frame === 0) frame = requestAnimationFrame(draw);
  };
  const show = (next: PlayState, what: Touched): void => {
    state = next;
    touched = what;
    derived = derive(state);
    redraw();
  };
  const change = (next: PlayState, what: Touched): void => {
    demonstration.stop();
    if (next === state && what === touched) return;
    show(next, what);
    window.clearTimeout(sayTimer);
    sayTimer = window.setTimeout(() => setText(said, sentence(state, derived, touched)), SAY_MS);
    window.clearTimeout(linkTimer);
    linkTimer = window.setTimeout(() => {
      const link = writeLink(state);
      history.replaceState(null, '', link ? `#${link}` : location.pathname + location.search);
    }, LINK_MS);
  };

  const events: PanelEvents = {
    onPlane: (plane) => change({ ...state, plane }, 'plane'),
    onAdd: () => change(addKey(state, valuesAt), 'key'),
    onRemove: () => change(removeKey(state, state.selected), 'key'),
    // Times that follow from distances stay where they are when the hand takes over.
    onSpacing: (spacing) => change({ ...state, spacing, keys: timed() }, 'spacing'),
    onEnds: (ends) => change(setEnds(state, ends), ends),
    onSamples: (samples) => change({ ...state, samples }, 'samples'),
    onShaping: (shaping) => change(setShaping(state, shaping), 'shaping'),
    onSpeed: (end, speed) =>
      change({ ...state, speeds: end === 0 ? [speed, state.speeds[1]] : [state.speeds[0], speed] }, 'speed'),
  };
  const timed = (): PlayState['keys'] => state.keys.map((key, i) => ({ ...key, time: derived.times[i]! }));
  const valuesAt = (time: number): { value: number; across: number } => {
    const across = derive({ ...state, plane: true }).curves.natural.map((curve) => valueAt(curve, time));
    return { value: across[0]!, across: across[1]! };
  };

  const curve = createCurveFigure({
    onSelect: (selected) => selected !== state.selected && change({ ...state, selected }, 'key'),
    onMove: (key, { along, value }) =>
      change(
        state.plane ? withKey(state, key, { value, across: along }) : moveKey(state, key, { time: along, value }),
        'key',
      ),
    onAdd: events.onAdd,
    onRemove: (key) => change(removeKey(state, key), 'key'),
    onHold: () => undefined,
    onSpeed: (end, speed) => events.onSpeed(end === 'start' ? 0 : 1, speed),
  });
  const listen = (element: SVGSVGElement, x: () => Scale | null, box: () => Box): void =>
    listenToTime(element, x, box, (time) => {
      const [low, high] = shownSpan(derived);
      change({ ...state, time: clamp(time, low, high) }, 'time');
    });
  const slope = createRateFigure(1, listen);
  const bend = createRateFigure(2, listen);
  const weights = createWeightsFigure(listen);
  const layers = createLayerList((layer, on) => change(showLayer(state, layer, on), on ? layer : 'key'));
  const system = createSystemTable((key) => {
    if (key !== lit) {
      lit = key;
      redraw();
    }
  });
  const keysTable = createKeysTable({
    onType: (key, field, value) =>
      change(
        field === 'time'
          ? moveKey(state, key, { time: value, value: state.keys[key]!.value })
          : withKey(state, key, { [field]: value }),
        'key',
      ),
    onSelect: (selected) => selected !== state.selected && change({ ...state, selected }, 'key'),
    onRemove: (key) => change(removeKey(state, key), 'key'),
  });
  const tools = createTools(events);
  const controls = createCurveControls(events);
  const ends = createEndsChoice(events);
  const { onError } = parts;
  const figures = {
    curve: createFigure({
      ...{
        id: 'curve',
        title: 'The curve',
        body: curve.element,
        picture: curve.element,
        tools: tools.element,
        onError,
      },
      numbers: () => curveNumbers(state, derived, 0),
    }),
    slope: createFigure({
      ...{ id: 'slope', title: 'Slope', body: slope.element, picture: slope.element, onError },
      numbers: () => curveNumbers(state, derived, 1),
    }),
    bend: createFigure({
      ...{ id: 'bend', title: 'Bend', body: bend.element, picture: bend.element, onError },
      numbers: () => curveNumbers(state, derived, 2),
    }),
    weights: createFigure({
      ...{ id: 'weights', title: 'Weights', body: weights.element, picture: weights.element, onError },
      numbers: () => weightNumbers(derived),
    }),
    bending: createFigure({
      ...{
        id: 'bending',
        title: 'Curves',
        body: h('div', { class: 'curves' }, layers.element, controls.element),
        onError,
      },
      numbers: () => bendingNumbers(derived),
    }),
    system: createFigure({
      ...{ id: 'system', title: 'The system', body: system.element, tools: ends.element, onError },
      numbers: () => systemNumbers(derived),
    }),
  } satisfies Record<string, Figure>;
  const said = h('p', { class: 'visually-hidden', role: 'status', 'data-testid': 'said' });
  const playing = h('span', { class: 'scene', 'data-testid': 'scene' });
  const demonstration = createDemonstration((next, scene, index) => {
    show(next, scene.touched);
    setText(playing, `${index + 1} of ${SCENES.length}`);
  });
  const player = button({
    label: 'Play the demonstration',
    testId: 'demonstration',
    icon: 'play',
    kind: 'plain',
    text: 'Watch',
    onClick: () => (demonstration.running ? change(state, touched) : demonstration.start()),
  });
  player.addEventListener('click', redraw);
  const reset = button({
    label: 'Back to the beginning',
    testId: 'reset',
    icon: 'reset',
    onClick: () => change(INITIAL, 'natural'),
  });

  function draw(): void {
    frame = 0;
    const { unit } = state.taken ?? { unit: '' };
    curve.update(state, derived, lit);
    slope.update(state, derived);
    bend.update(state, derived);
    weights.update(state, derived, lit);
    layers.update(state, derived);
    system.update(derived, lit);
    keysTable.update(state, derived.times);
    for (const panel of [tools, controls, ends, parts.real]) panel.update(state);
    const units = unitsOf(state, unit);
    figures.curve.update(units.curve, curveNotice(state, derived, touched));
    figures.slope.update(units.slope, rateNotice(state, derived, 1));
    figures.bend.update(units.bend, rateNotice(state, derived, 2));
    figures.weights.update(`w₁ to w${subscript(state.keys.length)} over time`, weightsNotice(state, derived));
    figures.bending.update(units.bending, bendingNotice(state, derived));
    figures.system.update(
      `${state.keys.length} × ${state.keys.length}, for the slopes m`,
      systemNotice(state, derived, lit),
    );
    const { running } = demonstration;
    setIcon(player, running ? 'pause' : 'play');
    setText(player.querySelector('span')!, running ? 'Stop' : 'Watch');
    setAttribute(player, 'aria-label', running ? 'Stop the demonstration' : 'Play the demonstration');
    setHidden(playing, !running);
  }

  const main = h(
    'main',
    { class: 'play-main' },
    h(
      'div',
      { class: 'lead' },
      h('h1', {}, 'The bent ruler'),
      h(
        'p',
        {},
        'A motion through key poses is this picture, once for every coordinate of the shape. Drag a key; switch curves on and off.',
      ),
      h('div', { class: 'demonstration' }, playing, player, reset),
    ),
    h(
      'div',
      { class: 'board' },
      figures.curve.element,
      figures.slope.element,
      figures.bend.element,
      figures.weights.element,
      h(
        'div',
        { class: 'board-side' },
        figures.bending.element,
        figures.system.element,
        h('section', { class: 'keys-as-numbers' }, h('h2', {}, 'Keys as numbers'), keysTable.element),
        parts.real.element,
      ),
    ),
    said,
  );
  // The first touch ends what plays by itself; links and the button that stops it mean something else.
  for (const name of ['pointerdown', 'keydown'] as const) {
    main.addEventListener(
      name,
      (event) => {
        if (demonstration.running && !player.contains(event.target as Node)) change(state, touched);
      },
      { capture: true },
    );
  }
  window.addEventListener('hashchange', () => {
    const linked = readLink(location.hash);
    if (linked) change(linked.state, 'key');
    parts.onLeftOut(linked?.leftOut ?? null);
  });
  if (parts.playing && location.hash.length < 2) demonstration.start();
  if (opened) parts.onLeftOut(opened.leftOut);
  redraw();
  return {
    element: h(
      'div',
      { class: 'play' },
      h(
        'header',
        { class: 'play-header' },
        h('a', { class: 'wordmark', href: './', title: 'To the app' }, 'shape', h('span', {}, 'spline')),
        h('div', { class: 'spacer' }),
        parts.theme,
      ),
      ...parts.notices,
      main,
    ),
    get: () => state,
    change,
  };
}
