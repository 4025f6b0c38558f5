/** The remaining time of an export, in words. */

/** The first frames are slower than the others. */
const SHOWN_AFTER_MS = 3000;
/** Shorter remaining times, in seconds, are not shown. */
const MIN_SHOWN_SECONDS = 10;

/** A phrase from the mean speed so far; empty while unknown. `fraction`: completed share, above 0. */
export function timeLeft(milliseconds: number, fraction: number): string {
  const left = (milliseconds / fraction - milliseconds) / 1000;
  if (milliseconds < SHOWN_AFTER_MS || left < MIN_SHOWN_SECONDS) return '';
  return left < 90
    ? `, about ${Math.ceil(left / 10) * 10}\u00a0s left`
    : `, about ${Math.round(left / 60)}\u00a0min left`;
}
