/**
 * Detects a worker that the browser killed, which no event reports. A living worker holds a lock with its name; the
 * page gets the lock when the worker ends. Pages without https have no locks: there an open database serves instead,
 * which cannot be deleted before its worker ends.
 */

/** A connection that nothing refers to would be closed. */
const held: IDBDatabase[] = [];

/**
 * In the worker: takes the lock for as long as it lives; `taken` is called once it has it. Pages that may store
 * nothing, such as those in a sandboxed frame, have no locks: there an end goes unnoticed.
 */
export function holdLock(name: string, taken: () => void): void {
  try {
    hold(name, taken);
  } catch {
    // as said
  }
}

function hold(name: string, taken: () => void): void {
  if ('locks' in navigator) {
    const ended = navigator.locks.request(name, () => {
      taken();
      return new Promise(() => undefined);
    });
    ended.catch(() => undefined); // a page that may store nothing is refused
    return;
  }
  const opening = indexedDB.open(name);
  opening.onsuccess = () => {
    held.push(opening.result);
    taken();
  };
}

/** In the page: resolves when the worker that holds the lock has ended, however that came. */
export function lockReleased(name: string): Promise<void> {
  if ('locks' in navigator) return navigator.locks.request(name, () => undefined);
  return new Promise((resolve) => {
    const deleting = indexedDB.deleteDatabase(name);
    deleting.onsuccess = () => resolve();
  });
}
