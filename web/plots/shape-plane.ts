/** The motion as a curve in the plane of the keys' two leading principal components (the paper's Fig. 2b, 3). */
import { ENDS, createEndHandle } from './end-handle.ts';
import type { End, EndHandleEvents } from './end-handle.ts';
import { make, namedCurve, text } from './svg-parts.ts';
import { createPlanePoint } from './plane-point.ts';
import type { PlanePointEvents } from './plane-point.ts';
import { extent, path, tickLabel, ticks } from './scale.ts';

export interface PlaneCurve {
  label: string;
  /** Points of the curve, 2 numbers per time. */
  points: readonly number[];
  style: string;
}

/** A curve with its own times, or without times. */
export interface PlaneOverlay extends PlaneCurve {
  /** Whether its points are marked. */
  marked: boolean;
}

export interface ShapePlaneData {
  times: readonly number[];
  /** Points of the keys, 2 numbers each. */
  keys: readonly number[];
  /** The first curve is the shown motion; its parts outside the range are drawn as extrapolated. */
  curves: readonly PlaneCurve[];
  range: readonly [number, number];
  /** End tangents; null hides the handles at the ends of the curve. */
  tangents: Readonly<Record<End, PlaneTangent>> | null;
}

export interface PlaneTangent {
  /** Vector from the end at speed 1. */
  handle: Vector;
  /** The shape that gives the tangent, if not a neighbour. */
  shape: Vector | null;
}

type Vector = readonly [number, number];

export interface ShapePlaneEvents extends EndHandleEvents, Pick<PlanePointEvents, 'pointLabel' | 'onPointKey'> {
  /** The point was dragged to these plane coordinates; snaps to keys. */
  onPoint(point: Vector): void;
  /** A path was drawn: 2 numbers per point. */
  onPath(points: readonly Vector[]): void;
}

const WIDTH = 272;
const HEIGHT = 190;
const PAD = 16;

export interface ShapePlanePlot {
  element: SVGSVGElement;
  draw(data: ShapePlaneData): void;
  setCursor(t: number): void;
  /** The motion's point at t; [0, 0] before the plot is first drawn. */
  curvePoint(t: number): Vector;
  /** Position of the shape shown instead of the motion's; null: on the curve. */
  setPoint(point: Vector | null): void;
  setOverlays(overlays: readonly PlaneOverlay[]): void;
  /** The drawn path, or null. */
  setPath(points: readonly Vector[] | null): void;
  setDrawing(on: boolean): void;
  /** Length of the handles until the curve is computed again, and their largest length. */
  setSpeeds(speeds: Readonly<Record<End, number>> | null, max: Readonly<Record<End, number>>): void;
}

const EXTRAPOLATED = 'extrapolated';

type Place = (x: number, y: number) => [number, number];

/** A point within this distance of a key, in plot pixels, snaps to it. */
const SNAP = 7;

export function createShapePlane(events: ShapePlaneEvents): ShapePlanePlot {
  const element = make('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    class: 'plot shape-plane',
    role: 'group',
    'aria-label': 'Being computed',
  });
  const content = make('g', {});
  const keys = make('g', {});
  const under = make('g', {});
  const over = make('g', {});
  const drawn = make('path', { class: 'drawn' });
  const handles = { start: createEndHandle('start', element, events), end: createEndHandle('end', element, events) };
  let current: Current | null = null;
  let overlays: readonly PlaneOverlay[] = [];
  let line: readonly Vector[] = [];
  let off: Vector | null = null;
  let time = 0;
  const point = createPlanePoint(element, WIDTH, {
    ...events,
    onDrag: (at) => current && events.onPoint(snapped(current, at)),
    onStroke: (places) => current && events.onPath(places.map(current.back)),
  });
  element.append(under, content, over, keys, drawn, point.element, handles.start.element, handles.end.element);

  const drawOver = (): void => {
    if (!current) return;
    const { place } = current;
    // Curves that coincide with the motion's are visible by their marks.
    under.replaceChildren(...overlays.map((overlay) => overlayLine(overlay, place)));
    over.replaceChildren(...overlays.flatMap((overlay) => (overlay.marked ? overlayMarks(overlay, place) : [])));
    drawn.setAttribute('d', path(line.map(([x, y]) => place(x, y))));
  };
  const placePoint = (): void => {
    if (!current) return;
    const [start, end] = current.data.range;
    const [x, y] = off ?? at(current.data, time);
    point.place(current.place(x, y), off ? 'off' : time < start || time > end ? 'beyond' : 'between');
  };

  return {
    element,
    draw(data) {
      const [place, back] = placing(data);
      current = { data, place, back };
      content.replaceChildren(...parts(data, place), ...axisTicks(place, back));
      keys.replaceChildren(...tangentMarks(data, place), ...keyMarks(data, place));
      drawOver();
      placePoint();
      element.setAttribute(
        'aria-label',
        `The motion through ${data.keys.length / 2} keys as a curve in the plane of their two leading principal components`,
      );
      for (const end of ENDS) handles[end].place(onPicture(data, end, place));
    },
    setSpeeds(speeds, max) {
      for (const end of ENDS) handles[end].setSpeed(speeds?.[end] ?? null, max[end]);
    },
    setCursor(t) {
      time = t;
      placePoint();
    },
    curvePoint: (t) => (current ? at(current.data, t) : [0, 0]),
    setPoint(next) {
      off = next;
      placePoint();
    },
    setOverlays(next) {
      overlays = next;
      drawOver();
    },
    setPath(points) {
      line = points ?? [];
      drawOver();
    },
    setDrawing: point.setDrawing,
  };
}

interface Current {
  data: ShapePlaneData;
  place: Place;
  /** Maps plot positions to the plane. */
  back: (place: Vector) => Vector;
}

function snapped({ data: { keys }, place, back }: Current, at: Vector): Vector {
  for (let index = 0; index < keys.length; index += 2) {
    const key: Vector = [keys[index]!, keys[index + 1]!];
    const [x, y] = place(...key);
    if (Math.hypot(x - at[0], y - at[1]) < SNAP) return key;
  }
  return back(at);
}

function placesOf({ points }: PlaneOverlay, place: Place): [number, number][] {
  return Array.from({ length: points.length / 2 }, (_, i) => place(points[2 * i]!, points[2 * i + 1]!));
}

function overlayLine(overlay: PlaneOverlay, place: Place): SVGElement {
  return namedCurve(overlay.label, overlay.style, placesOf(overlay, place));
}

function overlayMarks(overlay: PlaneOverlay, place: Place): SVGElement[] {
  return placesOf(overlay, place).map(([cx, cy]) =>
    make('circle', { class: `sample ${overlay.style}`, cx, cy, r: 1.8 }),
  );
}

/** Tick labels outside the plot, for a file. */
function axisTicks(place: Place, back: Current['back']): SVGElement[] {
  const [[left, bottom], [right, top]] = [back([PAD, HEIGHT - PAD]), back([WIDTH - PAD, PAD])];
  return [
    ...ticks([left, right], 5).map((x) => text('tick-x in-file', place(x, 0)[0], HEIGHT + 11, tickLabel(x))),
    ...ticks([bottom, top], 4).map((y) => text('tick-y in-file', -4, place(0, y)[1] + 3.5, tickLabel(y))),
  ];
}

/** Both axes have the same scale, so distances in the plane are the same in every direction. */
function placing(data: ShapePlaneData): [Place, Current['back']] {
  const { keys, curves, times, range } = data;
  const points = [...keys, ...shapesOf(data).flat()];
  const first = curves[0]?.points ?? [];
  // The keys and the curve between them determine the scale. Margins are shown as far as they fit.
  times.forEach((t, index) => {
    if (t >= range[0] && t <= range[1]) points.push(first[2 * index] ?? NaN, first[2 * index + 1] ?? NaN);
  });
  const [left, right] = extent(points.filter((_, index) => index % 2 === 0));
  const [bottom, top] = extent(points.filter((_, index) => index % 2 === 1));
  const margin = 0.14;
  const scale = Math.min(
    (WIDTH - 2 * PAD) / Math.max((right - left) * (1 + 2 * margin), 1e-12),
    (HEIGHT - 2 * PAD) / Math.max((top - bottom) * (1 + 2 * margin), 1e-12),
  );
  const [x, y] = [(left + right) / 2, (bottom + top) / 2];
  return [
    (px, py) => [WIDTH / 2 + (px - x) * scale, HEIGHT / 2 - (py - y) * scale],
    ([left, up]) => [x + (left - WIDTH / 2) / scale, y - (up - HEIGHT / 2) / scale],
  ];
}

/** An end of the curve and the handle vector at speed 1, in plot pixels. */
function onPicture(
  { keys, tangents }: ShapePlaneData,
  end: End,
  place: Place,
): { from: Vector; unit: Vector; width: number; height: number } | null {
  const handle = tangents?.[end].handle;
  if (!handle) return null;
  const [x, y] = (end === 'start' ? keys.slice(0, 2) : keys.slice(-2)) as [number, number];
  const [from, to] = [place(x, y), place(x + handle[0], y + handle[1])];
  return { from, unit: [to[0] - from[0], to[1] - from[1]], width: WIDTH, height: HEIGHT };
}

function parts({ times, curves, range }: ShapePlaneData, place: Place): SVGElement[] {
  const line = (curve: PlaneCurve, style: string, from: number, to: number, name = curve.label): SVGElement =>
    namedCurve(
      name,
      style,
      times.flatMap((t, index) =>
        t >= from && t <= to ? [place(curve.points[2 * index] ?? NaN, curve.points[2 * index + 1] ?? NaN)] : [],
      ),
    );
  const [main, ...others] = curves;
  return [
    ...others.map((curve) => line(curve, curve.style, range[0], range[1])),
    ...(main
      ? [
          line(main, 'extrapolated', -Infinity, range[0], EXTRAPOLATED),
          line(main, 'extrapolated', range[1], Infinity, EXTRAPOLATED),
          line(main, main.style, range[0], range[1]),
        ]
      : []),
  ];
}

function shapesOf({ tangents }: ShapePlaneData): Vector[] {
  return tangents ? [tangents.start.shape, tangents.end.shape].filter((shape) => shape !== null) : [];
}

/** A shape that gives an end tangent, and its direction from that end. */
function tangentMarks({ keys, tangents }: ShapePlaneData, place: Place): SVGElement[] {
  return ENDS.flatMap((end) => {
    const shape = tangents?.[end].shape;
    if (!shape) return [];
    const [fromX, fromY] = end === 'start' ? keys : keys.slice(-2);
    const [[x, y], from] = [place(...shape), place(fromX!, fromY!)];
    const size = 4.5;
    return [
      make('path', { class: 'tangent-way', d: path([from, [x, y]]) }),
      make('path', {
        class: 'tangent-shape',
        d: `M${x} ${y - size}L${x + size} ${y}L${x} ${y + size}L${x - size} ${y}Z`,
        'data-testid': `plane-${end}-tangent`,
      }),
    ];
  });
}

function keyMarks({ keys }: ShapePlaneData, place: Place): SVGElement[] {
  return Array.from({ length: keys.length / 2 }, (_, index) => {
    const [x, y] = place(keys[2 * index] ?? 0, keys[2 * index + 1] ?? 0);
    return [make('circle', { class: 'key', cx: x, cy: y, r: 4 }), text('key-number', x + 8, y - 6, String(index + 1))];
  }).flat();
}

/** The first curve's point at t, interpolated linearly between computed points. */
function at({ times, curves }: ShapePlaneData, t: number): [number, number] {
  const points = curves[0]?.points ?? [];
  const after = times.findIndex((time) => time >= t);
  const b = after < 0 ? times.length - 1 : after;
  const a = Math.max(b - 1, 0);
  const [ta, tb] = [times[a] ?? 0, times[b] ?? 0];
  const share = tb > ta ? Math.min(Math.max((t - ta) / (tb - ta), 0), 1) : 0;
  const mix = (from = 0, to = 0): number => from + (to - from) * share;
  return [mix(points[2 * a], points[2 * b]), mix(points[2 * a + 1], points[2 * b + 1])];
}
