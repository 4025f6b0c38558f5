/** Screen positions of pins, the vertex under a click, and the path that follows from a drag. */
import type { PathKey, Pin } from '../../engine/api/types.ts';
import { moveAt, withPathKey } from '../../model/pins.ts';
import type { AppState } from '../../model/state.ts';
import { length } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import type { Place } from '../../ui/pin-handles.ts';
import type { Viewer } from '../../viewer/viewer.ts';

/** A drag of one pin from its start position. */
export interface PinDrag {
  /** The pin's path, with a key at the drag's time that puts the pin at a point of the view. */
  pathTo(to: Place): PathKey[];
  time: number;
}

export function pinPositions(viewer: Viewer, pins: readonly Pick<Pin, 'vertex'>[]): (Place | null)[] {
  const [seen] = viewer.seen();
  const isSeen = (x: number, y: number): boolean =>
    seen !== undefined && x >= seen.x && x <= seen.x + seen.width && y >= seen.y && y <= seen.y + seen.height;
  return pins.map(({ vertex }) => {
    const [x = NaN, y = NaN] = viewer.project(viewer.vertex(vertex));
    return isSeen(x, y) ? { x, y } : null;
  });
}

/** The face's vertex nearest to a point of the view. */
export function vertexAt(viewer: Viewer, faces: Uint32Array, face: number, { x, y }: Place): number {
  const off = (vertex: number): number => {
    const [px = 0, py = 0] = viewer.project(viewer.vertex(vertex));
    return Math.hypot(px - x, py - y);
  };
  return faces.slice(3 * face, 3 * face + 3).reduce((best, other) => (off(other) < off(best) ? other : best));
}

/** Two path keys within half a frame are unintended, and the path would overshoot between them. */
function sameMoment(range: Range): number {
  return Math.max(length(range) / 1000, Math.min(length(range) / 200, 1 / 60));
}

/** Starts a drag, which moves the pin parallel to the screen; null if the pin is not drawn. */
export function startPinDrag(viewer: Viewer, { doc, time }: AppState, range: Range, index: number): PinDrag | null {
  const pin = doc.motion.pins[index];
  const from = pin ? viewer.vertex(pin.vertex) : [];
  if (!pin || from.length < 3) return null;
  const period = doc.motion.boundary === 'periodic' ? length(range) : null;
  const t = period === null ? time : time - Math.floor((time - range[0]) / period) * period;
  const path = pin.path ?? [];
  const before = moveAt(path, t, period);
  return {
    time: t,
    pathTo({ x, y }) {
      const to = viewer.beside(from, x, y);
      const move = before.map((way, axis) => way + to[axis]! - from[axis]!) as PathKey['move'];
      return withPathKey(path, { time: t, move }, sameMoment(range));
    },
  };
}
