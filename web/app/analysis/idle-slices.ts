/** Splits work on the page's thread into short slices between drawn frames. A playing motion does not stutter. */

const SLICE_MS = 4;
/** A page that is never idle still works this often. */
const LONGEST_MS = 250;

/** Call the result often. It pauses after each slice, and stops the work when `signal` aborts. */
export function idleSlices(signal: AbortSignal): () => Promise<void> {
  let until = -Infinity;
  return async () => {
    signal.throwIfAborted();
    if (performance.now() < until) return;
    await idle();
    signal.throwIfAborted();
    until = performance.now() + SLICE_MS;
  };
}

function idle(): Promise<void> {
  return new Promise((resolve) => {
    // Safari and Node have no idle callbacks.
    if (typeof requestIdleCallback === 'undefined') setTimeout(resolve, 0);
    else requestIdleCallback(() => resolve(), { timeout: LONGEST_MS });
  });
}
