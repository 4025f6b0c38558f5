/**
 * Detects a worker that the browser killed, which no event reports. A living worker holds a lock with its name, and the
 * page gets the lock when the worker ends. Pages without https have no locks. They use an open database instead, which
 * cannot be deleted before its worker ends.
 */

/** A connection without references would be closed. */
const held: IDBDatabase[] = [];

/**
 * Called in the worker. Holds the lock for the worker's lifetime and calls `taken` once it has the lock. Pages without
 * storage access, such as sandboxed frames, have no locks, so their workers' ends are not detected.
 */
export function acquireLock(name: string, taken: () => void): void {
  try {
    hold(name, taken);
  } catch {
    // The worker has no lock, as described above.
  }
}

function hold(name: string, taken: () => void): void {
  if ('locks' in navigator) {
    const ended = navigator.locks.request(name, () => {
      taken();
      return new Promise(() => undefined);
    });
    ended.catch(() => undefined); // Pages without storage access refuse the request.
    return;
  }
  const opening = indexedDB.open(name);
  opening.onsuccess = () => {
    held.push(opening.result);
    taken();
  };
}

/** Called in the page. Resolves when the worker with this lock has ended for any reason. */
export function lockReleased(name: string): Promise<void> {
  if ('locks' in navigator) return navigator.locks.request(name, () => undefined);
  return new Promise((resolve) => {
    const deleting = indexedDB.deleteDatabase(name);
    deleting.onsuccess = () => resolve();
  });
}
