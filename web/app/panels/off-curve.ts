/** Shapes off the curve in the shape plane: dragged points, drawn paths, and their key weights. */
import type { ShapePlanePlot } from '../../plots/shape-plane.ts';
import { createBlendWeights } from '../../ui/blend-weights.ts';
import { button } from '../../ui/controls.ts';
import { h, setAttribute, setHidden, setText } from '../../ui/dom.ts';
import { mixtureAt } from '../analysis/plane-weights.ts';
import type { PlaneShapes, Point } from '../analysis/plane-weights.ts';
import { createPlanePath } from './plane-path.ts';
import type { PlanePath } from './plane-path.ts';
import type { Blend } from '../view/view-state.ts';
import { reducedMotion } from '../view/window-events.ts';

export interface OffCurve {
  element: HTMLElement;
  onPoint(point: Point): void;
  onPath(points: readonly Point[]): void;
  onPointKey(event: KeyboardEvent): void;
  /** Sets the shapes of the plane; null clears them. */
  setShapes(shapes: PlaneShapes | null): void;
  /** Sets the motion's point on the curve. */
  setCurvePoint(at: Point): void;
  /** The shape shown instead of the motion. */
  update(blend: Blend | null, keys: readonly { name: string }[]): void;
}

const HINT = 'Drag the point off the curve: every mixture of the keys is a shape.';
const DRAWING_HINT = 'Draw in the plane: the shape follows your path.';
/** Step of an arrow key, as a share of the keys' extent. With Shift, ten steps. */
const STEP = 0.02;
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function createOffCurve(
  plot: () => Pick<ShapePlanePlot, 'setPoint' | 'setPath' | 'setDrawing'>,
  onBlend: (blend: Blend | null) => void,
): OffCurve {
  let shapes: PlaneShapes | null = null;
  let shown: Blend | null = null;
  let onCurve: Point = [0, 0];
  let drawing = false;
  const show = (point: Point): void => {
    if (!shapes) return;
    const blend = mixtureAt(shapes, point);
    shown = blend;
    plot().setPoint(blend.at);
    onBlend(blend);
  };
  const path = createPlanePath(show, () => drawTools());
  const weights = createBlendWeights();
  const leave = (): void => {
    path.stop();
    onBlend(null);
  };
  const tools = createPlaneTools(
    () => setDrawing(!drawing),
    () => (path.playing ? path.stop() : path.play()),
    leave,
  );
  const element = h('div', { class: 'group' }, ...tools.elements, weights.element);

  const drawTools = (): void => tools.update(drawing, path, shown !== null);
  const setDrawing = (on: boolean): void => {
    drawing = on;
    plot().setDrawing(on);
    drawTools();
  };
  drawTools();

  return {
    element,
    onPoint(point) {
      path.stop();
      show(point);
    },
    onPath(points) {
      path.set(points);
      plot().setPath(points);
      setDrawing(false);
      if (reducedMotion()) show(points[0]!);
      else path.play();
      drawTools();
    },
    onPointKey(event) {
      const to = shapes && stepped(shown?.at ?? onCurve, event, extentOf(shapes.keys));
      if (!to) return;
      event.preventDefault();
      path.stop();
      show(to);
    },
    setShapes(next) {
      const other = JSON.stringify(next?.keys) !== JSON.stringify(shapes?.keys);
      shapes = next;
      if (!other) return;
      path.set(null);
      plot().setPath(null);
      drawTools();
    },
    setCurvePoint(at) {
      onCurve = at;
    },
    update(blend, keys) {
      if (!blend) path.stop();
      shown = blend;
      plot().setPoint(blend?.at ?? null);
      weights.update({ weights: blend?.weights ?? null, keys });
      drawTools();
    },
  };
}

/** The point after an arrow key; null for other keys. */
function stepped([x, y]: Point, event: KeyboardEvent, extent: number): Point | null {
  const arrow = ARROWS[event.key];
  if (!arrow || event.ctrlKey || event.altKey || event.metaKey) return null;
  const step = STEP * (event.shiftKey ? 10 : 1) * extent;
  return [x + arrow[0] * step, y + arrow[1] * step];
}

function createPlaneTools(onDraw: () => void, onPlay: () => void, onBack: () => void) {
  const hint = h('p', { class: 'plane-note' }, HINT);
  const draw = button({
    label: 'Draw a path in the plane and play it',
    testId: 'plane-draw',
    text: 'Draw a path',
    onClick: onDraw,
  });
  const play = button({
    label: 'Play the drawn path',
    testId: 'plane-play',
    icon: 'play',
    text: 'Play path',
    onClick: onPlay,
  });
  const back = button({
    label: 'Back to the motion',
    testId: 'plane-back',
    text: 'Back to the motion',
    shortcut: 'Esc',
    onClick: onBack,
  });
  return {
    elements: [hint, h('div', { class: 'plane-tools' }, draw, play, back)],
    /** `off`: the shown shape is not the motion's. */
    update(drawing: boolean, path: PlanePath, off: boolean): void {
      setAttribute(draw, 'aria-pressed', String(drawing));
      setHidden(play, path.points === null);
      setText(play.lastElementChild!, path.playing ? 'Stop' : 'Play path');
      setHidden(back, !off);
      setText(hint, drawing ? DRAWING_HINT : HINT);
    },
  };
}

/** The longer side of the keys' bounding box. */
function extentOf(keys: readonly number[]): number {
  const sides = [0, 1].map((axis) => {
    const along = keys.filter((_, index) => index % 2 === axis);
    return Math.max(...along) - Math.min(...along);
  });
  return Math.max(...sides);
}
