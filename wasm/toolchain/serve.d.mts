import type { Server } from 'node:http';

export function serve(
  folder: string,
  options?: {
    port?: number;
    prefix?: string;
    tries?: number;
    isolated?: boolean;
    headers?: Record<string, string>;
  },
): Promise<{ url: string; server: Server }>;
export const guards: Record<string, string>;
export const developmentGuards: Record<string, string>;
export function freePort(): Promise<number>;
