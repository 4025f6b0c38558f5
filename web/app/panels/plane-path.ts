/** A path in the shape plane, played once at constant speed. */

type Point = readonly [number, number];

export interface PlanePath {
  /** Sets the path and stops playback. */
  set(points: readonly Point[] | null): void;
  play(): void;
  stop(): void;
  readonly points: readonly Point[] | null;
  readonly playing: boolean;
}

const SECONDS = 4;

/** `onPoint` is called on every refresh during playback; `onEnd` when it ends or is stopped. */
export function createPlanePath(onPoint: (point: Point) => void, onEnd: () => void): PlanePath {
  let points: readonly Point[] | null = null;
  let frame = 0;
  const stop = (): void => {
    if (frame === 0) return;
    cancelAnimationFrame(frame);
    frame = 0;
    onEnd();
  };
  return {
    set(next) {
      stop();
      points = next;
    },
    play() {
      stop();
      if (!points) return;
      const path = points;
      const start = performance.now();
      const step = (now: number): void => {
        const share = Math.min(Math.max((now - start) / (1000 * SECONDS), 0), 1);
        frame = share < 1 ? requestAnimationFrame(step) : 0;
        onPoint(pointAlong(path, share));
        if (share === 1) onEnd();
      };
      frame = requestAnimationFrame(step);
    },
    stop,
    get points() {
      return points;
    },
    get playing() {
      return frame !== 0;
    },
  };
}

/** The point at a share of a polyline's length. */
export function pointAlong(points: readonly Point[], share: number): Point {
  const lengths = points.slice(1).map(([x, y], index) => Math.hypot(x - points[index]![0], y - points[index]![1]));
  let rest = share * lengths.reduce((sum, length) => sum + length, 0);
  for (const [index, length] of lengths.entries()) {
    if (rest <= length && length > 0) {
      const [from, to] = [points[index]!, points[index + 1]!];
      const along = (axis: 0 | 1): number => from[axis] + ((to[axis] - from[axis]) * rest) / length;
      return [along(0), along(1)];
    }
    rest -= length;
  }
  return points.at(-1)!;
}
