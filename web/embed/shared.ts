/** Objects shared by several users: made once per key, disposed of some time after the last user has left. */

export interface Lease<T> {
  readonly value: Promise<T>;
  /** Releases the object. Idempotent. */
  release(): void;
}

interface Held<T> {
  key: string;
  users: Set<Lease<T>>;
  abort: AbortController;
  value: Promise<T>;
  listeners: Set<(part: Stage) => void>;
  ending: ReturnType<typeof setTimeout> | undefined;
}

export interface Stage {
  stage: string;
  /** Completed share in [0, 1]. */
  fraction: number;
}

export interface Making {
  /** Aborted when there are no users left. */
  signal: AbortSignal;
  report(stage: Stage): void;
}

export class Shared<T> {
  private readonly held = new Map<string, Held<T>>();

  constructor(
    private readonly dispose: (value: T) => void,
    private readonly graceMs: number,
  ) {}

  /** Number of objects, including those waiting for disposal. */
  get size(): number {
    return this.held.size;
  }

  /** Calls `make` if no object exists for the key. Failures are not cached. */
  take(key: string, make: (making: Making) => Promise<T>, onProgress?: (part: Stage) => void): Lease<T> {
    return this.lease(this.held.get(key) ?? this.begin(key, make), onProgress);
  }

  private lease(held: Held<T>, onProgress?: (part: Stage) => void): Lease<T> {
    clearTimeout(held.ending);
    if (onProgress) held.listeners.add(onProgress);
    const lease: Lease<T> = {
      value: held.value,
      release: () => {
        if (!held.users.delete(lease)) return;
        if (onProgress) held.listeners.delete(onProgress);
        if (held.users.size === 0) held.ending = setTimeout(() => this.end(held), this.graceMs);
      },
    };
    held.users.add(lease);
    return lease;
  }

  private begin(key: string, make: (making: Making) => Promise<T>): Held<T> {
    const abort = new AbortController();
    const listeners: Held<T>['listeners'] = new Set();
    const report = (part: Stage): void => listeners.forEach((listener) => listener(part));
    const value = make({ signal: abort.signal, report });
    const held: Held<T> = { key, users: new Set(), abort, value, listeners, ending: undefined };
    this.held.set(key, held);
    value.catch(() => this.forget(held));
    return held;
  }

  private forget(held: Held<T>): void {
    if (this.held.get(held.key) === held) this.held.delete(held.key);
  }

  private end(held: Held<T>): void {
    if (held.users.size > 0) return;
    this.forget(held);
    held.abort.abort();
    held.value.then(this.dispose, () => undefined);
  }
}
