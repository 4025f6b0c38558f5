/** Poses for several workers. */

/** An array that workers share without copies if threads can share memory. It is filled once and then constant. */
export function sharedFloats(length: number): Float32Array {
  const shared = typeof SharedArrayBuffer === 'function' && globalThis.crossOriginIsolated !== false;
  return new Float32Array(shared ? new SharedArrayBuffer(4 * length) : new ArrayBuffer(4 * length));
}
