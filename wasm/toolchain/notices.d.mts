export const NOTICES: string;
export function packageOf(module: string): string | null;
export function notices(packages: Iterable<string>): string;
