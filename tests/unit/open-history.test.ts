import { describe, expect, it } from 'vitest';
import { OpenHistory } from '../../web/app/storage/open-history.ts';
import type { Snapshot } from '../../web/app/storage/snapshot.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

const snapshot = (name: string, bytes = 1): Snapshot => ({
  files: [{ name, bytes: { byteLength: bytes } as Uint8Array }],
  options: {},
  poses: [],
  state: EMPTY_STATE,
  history: { past: [], future: [] },
});

const names = (history: OpenHistory): string[] => history.all.map(({ files }) => files[0]!.name);

describe('the history of opened content', () => {
  it('goes back and forth', () => {
    const history = new OpenHistory();
    const [a, b, c] = [snapshot('a'), snapshot('b'), snapshot('c')];
    history.left(a);
    history.left(b);
    expect(history.before).toBe(b);
    history.left(c, 'back');
    expect([history.before, history.after]).toEqual([a, c]);
    history.left(b, 'forth');
    expect([history.before, history.after]).toEqual([b, null]);
    history.left(c, 'back');
    history.left(b);
    expect(history.after).toBeNull();
  });

  it('keeps the last entries within its size', () => {
    const history = new OpenHistory();
    for (let index = 0; index < 12; ++index) history.left(snapshot(String(index)));
    expect(names(history)).toHaveLength(10);
    history.left(snapshot('large', 400e6));
    history.left(snapshot('also large', 400e6));
    expect(names(history)).toEqual(['also large']);
    history.left(snapshot('larger', 900e6));
    expect(names(history)).toEqual(['larger']);
  });
});
