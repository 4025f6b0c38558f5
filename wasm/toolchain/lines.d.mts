export function languageOf(file: string): string | undefined;
export function codeLines(text: string, language: string): number;
export function printLines(): void;
