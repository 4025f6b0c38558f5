/** Draggable items of the shape plane: the shown shape's point, and drawn paths. */
import { drag } from './drag.ts';
import { make } from './svg-parts.ts';

type Vector = readonly [number, number];

export interface PlanePointEvents {
  /** Description of the point for screen readers. */
  pointLabel: string;
  /** Dragged to a position in the plot. */
  onDrag(place: Vector): void;
  /** A key was pressed on the point; the caller interprets it. */
  onPointKey(event: KeyboardEvent): void;
  /** A path was drawn, as positions in the plot. */
  onStroke(places: readonly Vector[]): void;
}

export interface PlanePoint {
  element: SVGGElement;
  place(at: Vector, phase: 'between' | 'beyond' | 'off'): void;
  /** Strokes draw a path instead of moving the point. */
  setDrawing(on: boolean): void;
}

/** Positions of a stroke closer than this, in plot pixels, are merged. */
const STEP = 2;

export function createPlanePoint(picture: SVGSVGElement, width: number, events: PlanePointEvents): PlanePoint {
  const reach = make('circle', { class: 'point-reach', r: 16 });
  const mark = make('circle', { class: 'now', r: 4.5 });
  const stroke = make('polyline', { class: 'stroke', display: 'none' });
  const element = make('g', {
    class: 'plane-point',
    role: 'application',
    tabindex: 0,
    'aria-roledescription': 'point',
    'aria-label': events.pointLabel,
    'data-testid': 'plane-point',
  });
  element.append(reach, mark);
  let drawing = false;

  const placeOf = (event: PointerEvent): Vector => {
    const box = picture.getBoundingClientRect();
    const scale = width / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  };

  const draw = (places: Vector[]): void => {
    stroke.setAttribute('display', places.length > 1 ? 'inline' : 'none');
    stroke.setAttribute('points', places.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' '));
  };

  picture.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || (event.target as Element).closest('.end-handle')) return;
    const onPoint = element.contains(event.target as Node);
    // A finger beside the point scrolls the page.
    if (!drawing && !onPoint && event.pointerType !== 'mouse') return;
    event.preventDefault();
    element.focus({ preventScroll: true });
    const places: Vector[] = [placeOf(event)];
    const move = (at: PointerEvent): void => {
      const place = placeOf(at);
      if (!drawing) return events.onDrag(place);
      const [x, y] = places.at(-1)!;
      if (Math.hypot(place[0] - x, place[1] - y) < STEP) return;
      places.push(place);
      draw(places);
    };
    drag(picture, event, move, () => {
      draw([]);
      if (drawing && places.length > 1) events.onStroke(places);
    });
    if (!drawing && !onPoint) events.onDrag(places[0]!);
  });
  element.addEventListener('keydown', (event) => events.onPointKey(event));
  picture.append(stroke);

  return {
    element,
    place([x, y], phase) {
      for (const circle of [reach, mark]) {
        circle.setAttribute('cx', x.toFixed(2));
        circle.setAttribute('cy', y.toFixed(2));
      }
      mark.setAttribute('data-phase', phase);
    },
    setDrawing(on) {
      drawing = on;
      picture.classList.toggle('drawing', on);
    },
  };
}
