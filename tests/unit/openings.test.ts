import { describe, expect, it } from 'vitest';
import { Openings } from '../../web/app/kept/openings.ts';
import type { Work } from '../../web/app/kept/work.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

const work = (name: string, bytes = 1): Work => ({
  files: [{ name, bytes: { byteLength: bytes } as Uint8Array }],
  options: {},
  poses: [],
  state: EMPTY_STATE,
  history: { past: [], future: [] },
});

const names = (openings: Openings): string[] => openings.all.map(({ files }) => files[0]!.name);

describe('what was open before', () => {
  it('is stepped back to and forth again', () => {
    const openings = new Openings();
    const [a, b, c] = [work('a'), work('b'), work('c')];
    openings.left(a);
    openings.left(b);
    expect(openings.before).toBe(b);
    openings.left(c, 'back');
    expect([openings.before, openings.after]).toEqual([a, c]);
    openings.left(b, 'forth');
    expect([openings.before, openings.after]).toEqual([b, null]);
    openings.left(c, 'back');
    openings.left(b);
    expect(openings.after).toBeNull();
  });

  it('keeps what was left last and fits', () => {
    const openings = new Openings();
    for (let index = 0; index < 12; ++index) openings.left(work(String(index)));
    expect(names(openings)).toHaveLength(10);
    openings.left(work('large', 400e6));
    openings.left(work('also large', 400e6));
    expect(names(openings)).toEqual(['also large']);
    openings.left(work('larger', 900e6));
    expect(names(openings)).toEqual(['larger']);
  });
});
