/** Handles the end of a worker: the engine starts a new one with the next requested frame. */

/** Every caller that waits for a result reports the same end within this time. */
const SAME_END_MS = 1000;
/** Another end within this time is caused by the shape. */
const NEXT_END_MS = 10_000;

export class WorkerRestart {
  private restartedAt = -Infinity;

  /** `again` requests a frame. */
  constructor(
    private readonly again: () => void,
    private readonly now: () => number = () => performance.now(),
  ) {}

  /** A worker has ended. Returns whether to try again. */
  tryAgain(): boolean {
    const since = this.now() - this.restartedAt;
    if (since < SAME_END_MS) return true;
    if (since < NEXT_END_MS) return false;
    this.restartedAt = this.now();
    this.again();
    return true;
  }

  /** Whether this failure is a worker's end that another try handles. */
  takesUp(error: unknown): boolean {
    return error instanceof Error && 'code' in error && error.code === 'crashed' && this.tryAgain();
  }
}
