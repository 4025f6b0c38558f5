import path from 'node:path';
import { expect, it } from 'vitest';
import { freePort, serve } from '../../wasm/toolchain/serve.mjs';

it.each([false, true])('every answer of npm start is guarded, isolated: %s', async (isolated) => {
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
      expect(response.headers.get('content-security-policy')).toBe("frame-ancestors 'self'");
      if (status === 200)
        expect(response.headers.get('cross-origin-opener-policy')).toBe(isolated ? 'same-origin' : null);
    }
  } finally {
    server.close();
  }
});
