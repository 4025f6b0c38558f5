/** Poses that several workers need. */

/**
 * Where threads can share memory, an array that workers share without copies. It is filled once and never changed.
 */
export function sharedFloats(length: number): Float32Array {
  const shared = typeof SharedArrayBuffer === 'function' && globalThis.crossOriginIsolated !== false;
  return new Float32Array(shared ? new SharedArrayBuffer(4 * length) : new ArrayBuffer(4 * length));
}
