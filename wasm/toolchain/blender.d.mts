export function findBlender(): string | null;
export function installBlender(): Promise<string | null>;
