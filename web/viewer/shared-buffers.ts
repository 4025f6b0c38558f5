/** A geometry that shares buffers with another. */
import type { BufferGeometry } from 'three';

/** Lets another geometry be drawn from a shape's buffers. */
export function shareBuffers(shape: BufferGeometry, other: BufferGeometry): void {
  for (const name of ['position', 'normal']) other.setAttribute(name, shape.getAttribute(name));
}

/** Disposes of a geometry's own buffers; the shape's buffers stay on the graphics card. */
export function disposeShared(other: BufferGeometry): void {
  for (const name of Object.keys(other.attributes)) other.deleteAttribute(name);
  other.dispose();
}
