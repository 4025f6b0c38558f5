/** Things that several users share: made once for a key, disposed of a while after the last user has left. */

export interface Lease<T> {
  readonly value: Promise<T>;
  /** Its user is about to have another one. */
  leaving: boolean;
  /** Idempotent. */
  release(): void;
}

interface Held<T> {
  key: string;
  users: Set<Lease<T>>;
  abort: AbortController;
  made: Promise<T>;
  /** The same, when it is what the key says. */
  value: Promise<T>;
  listeners: Set<(part: Stage) => void>;
  ending: ReturnType<typeof setTimeout> | undefined;
}

export interface Stage {
  stage: string;
  /** In [0, 1]. */
  fraction: number;
}

export interface Making {
  /** Everybody who wanted it has left. */
  signal: AbortSignal;
  report(stage: Stage): void;
}

export class Shared<T> {
  private readonly held = new Map<string, Held<T>>();

  constructor(
    private readonly dispose: (value: T) => void,
    private readonly graceMs: number,
  ) {}

  /** How many there are, with those that are about to leave. */
  get size(): number {
    return this.held.size;
  }

  has(key: string): boolean {
    return this.held.has(key);
  }

  /** `make` is called where nobody holds the key. What fails is not kept. */
  take(key: string, make: (making: Making) => Promise<T>, onProgress?: (part: Stage) => void): Lease<T> {
    return this.lease(this.held.get(key) ?? this.begin(key, make), onProgress);
  }

  /**
   * What one of these has, and nobody who stays, is changed into what another key stands for; it stays what it was
   * where that fails. Null where there is none. Nobody may hold `key`.
   */
  change(own: readonly Lease<T>[], key: string, change: (value: T) => Promise<void>): Lease<T> | null {
    const free = ({ users }: Held<T>): boolean =>
      own.some((one) => users.has(one)) && [...users].every(({ leaving }) => leaving);
    const held = [...this.held.values()].find(free);
    if (!held) return null;
    const before = { key: held.key, value: held.value };
    const value = held.value.then(async (made) => {
      await change(made);
      return made;
    });
    this.call(held, { key, value });
    value.catch(() => this.call(held, before));
    return this.lease(held);
  }

  private lease(held: Held<T>, onProgress?: (part: Stage) => void): Lease<T> {
    clearTimeout(held.ending);
    if (onProgress) held.listeners.add(onProgress);
    const lease: Lease<T> = {
      value: held.value,
      leaving: false,
      release: () => {
        if (!held.users.delete(lease)) return;
        if (onProgress) held.listeners.delete(onProgress);
        if (held.users.size === 0) held.ending = setTimeout(() => this.end(held), this.graceMs);
      },
    };
    held.users.add(lease);
    return lease;
  }

  /** A key that was given away meanwhile stays with whom it was given to; what has ended gets none. */
  private call(held: Held<T>, named: Pick<Held<T>, 'key' | 'value'>): void {
    this.forget(held);
    Object.assign(held, named);
    if (!held.abort.signal.aborted && !this.held.has(held.key)) this.held.set(held.key, held);
  }

  private begin(key: string, make: (making: Making) => Promise<T>): Held<T> {
    const abort = new AbortController();
    const listeners: Held<T>['listeners'] = new Set();
    const report = (part: Stage): void => listeners.forEach((listener) => listener(part));
    const value = make({ signal: abort.signal, report });
    const held: Held<T> = { key, users: new Set(), abort, made: value, value, listeners, ending: undefined };
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
    held.made.then(this.dispose, () => undefined);
  }
}
