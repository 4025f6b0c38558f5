/** A word that the browser keeps on this machine. Storage can be forbidden there; then nothing is kept. */

export function readSetting(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Written before the call returns, also while the page is left; null removes it. */
export function writeSetting(key: string, value: string | null): void {
  try {
    if (value === null) localStorage.removeItem(key);
    else localStorage.setItem(key, value);
  } catch {
    // Nothing to keep it with.
  }
}
