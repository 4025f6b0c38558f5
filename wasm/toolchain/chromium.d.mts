export function findBrowser(chromium: { executablePath(): string }): string | null;
export function hasBrowser(): boolean;
