import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { freePort, guards, serve } from '../../wasm/toolchain/serve.mjs';

const inRepository = (name: string): string => readFileSync(path.resolve(import.meta.dirname, '../..', name), 'utf8');
const directives = (policy: string): string[] => policy.split('; ');
const ofPage = (html: string): string[] => directives(/content="(default-src [^"]*)"/.exec(html)![1]!);

it.each([false, true])('every response of npm start has the security headers, isolated: %s', async (isolated) => {
  const folder = path.resolve(import.meta.dirname, '../../public/icons');
  const { url, server } = await serve(folder, { port: await freePort(), isolated });
  try {
    for (const [name, status] of [
      ['icon.svg', 200],
      ['missing', 404],
    ] as const) {
      const response = await fetch(new URL(name, url));
      expect(response.status).toBe(status);
      expect(response.headers.get('x-content-type-options')).toBe('nosniff');
      expect(response.headers.get('content-security-policy')).toBe(guards['content-security-policy']);
      if (status === 200)
        expect(response.headers.get('cross-origin-opener-policy')).toBe(isolated ? 'same-origin' : null);
    }
  } finally {
    server.close();
  }
});

it('the policy of the header is the one of the page, and who may frame it; the manual has it for other hosts', () => {
  const header = directives(guards['content-security-policy']!);
  expect(header).toEqual([...ofPage(inRepository('web/index.html')), "frame-ancestors 'self'"]);
  const text = inRepository('web/manual/MANUAL.md').replace(/\s+/g, ' ');
  expect(text).toContain(guards['content-security-policy']);
});
