/** A text setting stored by the browser on this machine. If storage is forbidden, nothing is stored. */

/** A setting is stored for all visits, or for this tab until it is closed. */
const STORAGE = { browser: () => localStorage, tab: () => sessionStorage };
type Keeper = keyof typeof STORAGE;

export function readSetting(key: string, keeper: Keeper = 'browser'): string | null {
  try {
    return STORAGE[keeper]().getItem(key);
  } catch {
    return null;
  }
}

/** Written before the call returns, also while the page closes; null removes it. */
export function writeSetting(key: string, value: string | null, keeper: Keeper = 'browser'): void {
  try {
    const storage = STORAGE[keeper]();
    if (value === null) storage.removeItem(key);
    else storage.setItem(key, value);
  } catch {
    // Storage is not available.
  }
}
