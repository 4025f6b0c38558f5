/** Clips lines far outside the plot, because a dashed line of a million pixels freezes a browser for seconds. */

type Point = readonly [number, number];

/** Clipping distance in pixels, larger than any plot. */
export const FARTHEST = 5000;
const GAP: Point = [NaN, NaN];

/** The pieces of a polyline within FARTHEST, separated by gaps. */
export function clipped(points: readonly Point[]): Point[] {
  if (points.every(isNear)) return [...points];
  const kept: Point[] = [];
  for (let i = 1; i < points.length; i += 1) {
    const piece = clippedSegment(points[i - 1]!, points[i]!);
    if (!piece) continue;
    const last = kept.at(-1);
    if (last && (last[0] !== piece[0][0] || last[1] !== piece[0][1])) kept.push(GAP);
    kept.push(...piece);
  }
  return kept;
}

const isNear = ([x, y]: Point): boolean => Math.abs(x) <= FARTHEST && Math.abs(y) <= FARTHEST;

/** The part of a line within the limits in both coordinates (Liang and Barsky 1984); null if there is none. */
function clippedSegment(from: Point, to: Point): [Point, Point] | null {
  let [start, end] = [0, 1];
  for (const axis of [0, 1] as const) {
    const way = to[axis] - from[axis];
    const limits = [(-FARTHEST - from[axis]) / way, (FARTHEST - from[axis]) / way].sort((a, b) => a - b);
    if (way === 0 && Math.abs(from[axis]) > FARTHEST) return null;
    if (way === 0) continue;
    start = Math.max(start, limits[0]!);
    end = Math.min(end, limits[1]!);
  }
  if (!(start < end)) return null;
  const at = (share: number): Point => [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
  return [start === 0 ? from : at(start), end === 1 ? to : at(end)];
}
