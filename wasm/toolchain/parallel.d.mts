export const cores: number;
export function inParallel<T>(tasks: readonly (() => Promise<T>)[], atOnce?: number): Promise<T[]>;
