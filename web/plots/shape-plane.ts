/** The motion as a curve in the plane of the two leading principal components of the keys (the paper's Fig. 2b, 3). */
import { createEndHandle } from './end-handle.ts';
import type { End, EndHandleEvents } from './end-handle.ts';
import { make, text } from './line-chart.ts';
import { extent, path } from './scale.ts';

export interface PlaneCurve {
  label: string;
  /** 2 numbers for each time. */
  points: readonly number[];
  style: string;
}

export interface ShapePlaneData {
  times: readonly number[];
  /** 2 numbers per key. */
  keys: readonly number[];
  /** The first is the motion that is shown; its parts outside the range are drawn as extrapolated. */
  curves: readonly PlaneCurve[];
  range: readonly [number, number];
  /** Where the handles at the ends of the curve point, for speed 1; null = there are none. */
  tangents: Readonly<Record<End, Vector | null>> | null;
}

type Vector = readonly [number, number];

const WIDTH = 272;
const HEIGHT = 190;
const PAD = 16;

export interface ShapePlanePlot {
  element: SVGSVGElement;
  draw(data: ShapePlaneData): void;
  setCursor(t: number): void;
  /** How long the handles are, before the curve is worked out anew. */
  setSpeeds(speeds: Readonly<Record<End, number>> | null): void;
}

type Place = (x: number, y: number) => [number, number];

export function createShapePlane(events: EndHandleEvents): ShapePlanePlot {
  const element = make('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    class: 'plot shape-plane',
    role: 'group',
    'aria-label': 'Being computed',
  });
  const content = make('g', {});
  const cursor = make('circle', { class: 'now', r: 4.5 });
  const handles = { start: createEndHandle('start', element, events), end: createEndHandle('end', element, events) };
  element.append(content, cursor, handles.start.element, handles.end.element);
  let current: { data: ShapePlaneData; place: Place } | null = null;

  return {
    element,
    draw(data) {
      const place = placing(data);
      current = { data, place };
      content.replaceChildren(...parts(data, place));
      element.setAttribute(
        'aria-label',
        `The motion through ${data.keys.length / 2} keys as a curve in the plane of their two leading principal components`,
      );
      for (const end of ['start', 'end'] as const) handles[end].place(onPicture(data, end, place));
    },
    setSpeeds(speeds) {
      for (const end of ['start', 'end'] as const) handles[end].setSpeed(speeds?.[end] ?? null);
    },
    setCursor(t) {
      if (!current) return;
      const [x, y] = at(current.data, t);
      const [left, top] = current.place(x, y);
      cursor.setAttribute('cx', left.toFixed(2));
      cursor.setAttribute('cy', top.toFixed(2));
      const [start, end] = current.data.range;
      cursor.setAttribute('data-phase', t < start || t > end ? 'beyond' : 'between');
    },
  };
}

/** One scale for both axes: distances in the plane mean the same in every direction. */
function placing({ keys, curves, times, range }: ShapePlaneData): Place {
  const points = [...keys];
  const first = curves[0]?.points ?? [];
  // The margins are shown as far as they fit; the keys and the curve between them decide the scale.
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
  return (px, py) => [WIDTH / 2 + (px - x) * scale, HEIGHT / 2 - (py - y) * scale];
}

/** An end of the curve and the way a handle of speed 1 goes from there, in the picture's own pixels. */
function onPicture(
  { keys, tangents }: ShapePlaneData,
  end: End,
  place: Place,
): { from: Vector; unit: Vector; width: number; height: number } | null {
  const tangent = tangents?.[end];
  if (!tangent) return null;
  const [x, y] = (end === 'start' ? keys.slice(0, 2) : keys.slice(-2)) as [number, number];
  const [from, to] = [place(x, y), place(x + tangent[0], y + tangent[1])];
  return { from, unit: [to[0] - from[0], to[1] - from[1]], width: WIDTH, height: HEIGHT };
}

function parts({ times, keys, curves, range }: ShapePlaneData, place: Place): SVGElement[] {
  const line = (curve: PlaneCurve, style: string, from: number, to: number): SVGElement =>
    make('path', {
      class: `curve ${style}`,
      d: path(
        times.flatMap((t, index) =>
          t >= from && t <= to ? [place(curve.points[2 * index] ?? NaN, curve.points[2 * index + 1] ?? NaN)] : [],
        ),
      ),
    });
  const [main, ...others] = curves;
  const shown = [
    ...others.map((curve) => line(curve, curve.style, range[0], range[1])),
    ...(main
      ? [
          line(main, 'extrapolated', -Infinity, range[0]),
          line(main, 'extrapolated', range[1], Infinity),
          line(main, main.style, range[0], range[1]),
        ]
      : []),
  ];
  for (let index = 0; index < keys.length / 2; index += 1) {
    const [x, y] = place(keys[2 * index] ?? 0, keys[2 * index + 1] ?? 0);
    shown.push(
      make('circle', { class: 'key', cx: x, cy: y, r: 4 }),
      text('key-number', x + 8, y - 6, String(index + 1)),
    );
  }
  return shown;
}

/** The point of the first curve at t, between the computed ones in a straight line. */
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
