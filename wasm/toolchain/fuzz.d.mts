export function fuzz(args: string[]): Promise<void>;
export function fuzzArguments(args: readonly string[], known: readonly string[]): { seconds: number; importers: readonly string[] };
export function foundText(importer: string, artifact: string): string;
