/** The edges of a shape's polygons as lines over it, without the edges from triangulation. */
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { disposeShared, shareBuffers } from './shared-buffers.ts';

/**
 * Two corners per polygon edge. faces: 3 corners each; polygons: number of faces of each polygon, null if every face is
 * a polygon.
 */
export function edgesOf(faces: ArrayLike<number>, polygons: Int32Array | null): Uint32Array {
  const edges = new Uint32Array(2 * faces.length);
  let count = 0;
  let corner = 0;
  for (let polygon = 0; corner < faces.length; polygon += 1) {
    const end = Math.min(corner + 3 * (polygons?.[polygon] ?? 1), faces.length);
    const next = (at: number): number => faces[at % 3 === 2 ? at - 2 : at + 1]!;
    const isCut = (from: number, to: number): boolean => {
      for (let at = corner; at < end; at += 1) if (faces[at] === to && next(at) === from) return true;
      return false;
    };
    for (let at = corner; at < end; at += 1) {
      const [from, to] = [faces[at]!, next(at)];
      if (end - corner > 3 && isCut(from, to)) continue;
      edges[count] = from;
      edges[count + 1] = to;
      count += 2;
    }
    corner = Math.max(end, corner + 3);
  }
  return edges.subarray(0, count);
}

export class Wire {
  readonly object: LineSegments;
  private readonly geometry = new BufferGeometry();
  private readonly lines = new LineBasicMaterial({ transparent: true, opacity: 0.35 });

  /** edges: 2 drawn vertices each. */
  constructor(edges: Uint32Array, shape: BufferGeometry, layer: number) {
    this.geometry.setIndex(new BufferAttribute(edges, 1));
    shareBuffers(shape, this.geometry);
    this.object = new LineSegments(this.geometry, this.lines);
    this.object.frustumCulled = false;
    this.object.layers.set(layer);
  }

  setDark(dark: boolean): void {
    this.lines.color.set(dark ? 0xffffff : 0x10151b);
  }

  dispose(): void {
    this.object.removeFromParent();
    disposeShared(this.geometry);
    this.lines.dispose();
  }
}
