export function whileHolding<T>(file: string, action: () => T | Promise<T>): Promise<T>;
export function whileLocked<T>(action: () => T | Promise<T>): Promise<T>;
