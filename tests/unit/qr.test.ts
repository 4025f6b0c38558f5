import { generate } from 'lean-qr';
import { describe, expect, it } from 'vitest';
import { QUIET, qrPath } from '../../web/ui/qr.ts';

/** The modules covered by the path's runs. */
function covered(path: string): Set<string> {
  const dark = new Set<string>();
  for (const [, x, y, width] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\d+z/g))
    for (let i = 0; i < Number(width); i += 1) dark.add(`${Number(x) + i - QUIET},${Number(y) - QUIET}`);
  return dark;
}

describe('the picture of a QR code', () => {
  it('covers every dark module once and no light one', () => {
    const modules = generate('https://example.org/#sample=cactus&t=0.25&present=volume');
    const path = qrPath({ size: modules.size, get: (x, y) => modules.get(x, y) });
    const dark = covered(path);
    let area = 0;
    for (let y = 0; y < modules.size; y += 1)
      for (let x = 0; x < modules.size; x += 1) {
        expect(dark.has(`${x},${y}`)).toBe(modules.get(x, y));
        if (modules.get(x, y)) area += 1;
      }
    expect(dark.size).toBe(area);
    // A finder pattern: a ring seven modules wide around a square of three.
    for (const at of [0, modules.size - 7])
      expect([0, 1, 2, 6].map((i) => dark.has(`${at + i},0`))).toEqual([true, true, true, true]);
    expect(dark.has('1,1')).toBe(false);
    expect(dark.has('3,3')).toBe(true);
  });

  it('refuses more than a code can hold', () => {
    expect(() => generate('x'.repeat(5000))).toThrow();
  });
});
