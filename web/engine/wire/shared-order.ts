/**
 * The elimination order of a large system, in memory that two workers share. One worker finds it while the other
 * encodes, without the page.
 */

/** Its state, its length, and its numbers. */
export type SharedOrder = Int32Array<SharedArrayBuffer>;

const STATE = 0;
const COUNT = 1;
const HEADER = 2;
const state = { notBegun: 0, begun: 1, made: 2, failed: 3 } as const;

/** Longest wait in milliseconds, far more than the largest order takes. */
const PATIENCE = 60_000;

export function sharedOrder(vertices: number): SharedOrder {
  return new Int32Array(new SharedArrayBuffer(Int32Array.BYTES_PER_ELEMENT * (HEADER + vertices)));
}

/** Wakes the waiting worker, with the result of `make` or without it. Skips `make` if the order was given up before. */
export function provideOrder(order: SharedOrder, make: () => Int32Array): void {
  if (Atomics.compareExchange(order, STATE, state.notBegun, state.begun) !== state.notBegun) return;
  try {
    const made = make();
    order.set(made, HEADER);
    Atomics.store(order, COUNT, made.length);
    Atomics.store(order, STATE, state.made);
    Atomics.notify(order, STATE);
  } finally {
    giveUpOrder(order);
  }
}

/** No order will come. A finished order stays valid. */
export function giveUpOrder(order: SharedOrder): void {
  for (const before of [state.notBegun, state.begun]) Atomics.compareExchange(order, STATE, before, state.failed);
  Atomics.notify(order, STATE);
}

/** Blocks the worker until the order is ready; null if it failed or was never started. */
export function awaitedOrder(order: SharedOrder): Int32Array | null {
  Atomics.wait(order, STATE, state.begun, PATIENCE);
  if (Atomics.load(order, STATE) !== state.made) return null;
  return order.subarray(HEADER, HEADER + Atomics.load(order, COUNT));
}
