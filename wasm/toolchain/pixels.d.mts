export const withoutPixels: Record<string, string>;
