/** Handles the end of a worker: the engine starts a new one with the next requested frame. */

/** Every caller that waited for a result reports the same end. */
const SAME_END_MS = 1000;
/** Another end so soon is a matter of the shape. */
const NEXT_END_MS = 10_000;

export class WorkerRestart {
  private restartedAt = -Infinity;

  /** `again` asks for a frame. */
  constructor(
    private readonly again: () => void,
    private readonly now: () => number = () => performance.now(),
  ) {}

  /** A worker has ended. Returns whether another try is worth it. */
  tryAgain(): boolean {
    const since = this.now() - this.restartedAt;
    if (since < SAME_END_MS) return true;
    if (since < NEXT_END_MS) return false;
    this.restartedAt = this.now();
    this.again();
    return true;
  }

  /** Whether this failure is the end of a worker, and another try is under way. */
  takesUp(error: unknown): boolean {
    return error instanceof Error && 'code' in error && error.code === 'crashed' && this.tryAgain();
  }
}
