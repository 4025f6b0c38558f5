import { describe, expect, it } from 'vitest';
import { momentOf } from '../../web/app/drawing/marking.ts';
import { renumbered } from '../../web/engine/api/renumbered-warnings.ts';
import { partOf, withPlaces } from '../../web/app/drawing/warning-places.ts';

// A cube's corners, with one face at the top left front and one at the bottom right back.
const POSITIONS = Float32Array.of(0, 0, 0, 9, 9, 9, 0, 9, 9, 1, 9, 9, 0, 8, 9, 9, 0, 0, 8, 0, 0, 9, 1, 0);
const FACES = Uint32Array.of(2, 3, 4, 5, 6, 7);
const warning = (code: string, face: number) => ({
  code,
  message: 'Between key 4 and key 5 neighbouring regions turn.',
  count: 1,
  key: 4,
  face,
  patches: [],
});

describe('places of warnings', () => {
  it('names the part by the thirds of the box', () => {
    expect(partOf(POSITIONS, FACES, 0)).toBe('at the top left front');
    expect(partOf(POSITIONS, FACES, 1)).toBe('at the bottom right back');
  });

  it('reports an interval once per place, and leaves warnings without a place', () => {
    const all = [
      warning('ambiguous-patch-turn', 0),
      warning('ambiguous-face-turn', 0),
      warning('ambiguous-face-turn', 1),
    ];
    const told = withPlaces([...all, warning('ambiguous-turn', -1)], FACES, () => POSITIONS);
    expect(told.map(({ message }) => message)).toEqual([
      'Between key 4 and key 5, at the top left front, neighbouring regions turn.',
      'Between key 4 and key 5, at the bottom right back, neighbouring regions turn.',
      'Between key 4 and key 5 neighbouring regions turn.',
    ]);
  });
});

describe('warnings of an import after its keys were changed', () => {
  const names = ['w0', 'w1', 'w2', 'w3', 'key 3'];
  const split = { code: 'split-vertices', count: 1, face: -1, patches: [] };
  const of = (key: number, message: string, poses: number[]) =>
    renumbered({ ...split, key, message }, names, (pose) => poses.indexOf(pose));

  it('name and show the key that the pose is now', () => {
    const warning = of(2, 'w2.obj (key 3): one vertex of key 1 has more.', [0, 2, 3])!;
    expect(warning).toEqual({ ...split, key: 1, message: 'w2.obj (key 2): one vertex of key 1 has more.' });
    expect(momentOf(warning, [0, 1, 3], [0, 3])).toBe(1);
    const moved = of(2, 'w2.obj (key 3): one vertex of key 1 has more.', [2, 3, 0])!;
    expect([moved.key, moved.message]).toEqual([0, 'w2.obj (key 1): one vertex of key 3 has more.']);
  });

  it('are dropped without their key, and name another pose that is no longer a key', () => {
    expect(of(2, 'w2.obj (key 3): torn.', [0, 1, 3])).toBeNull();
    expect(of(-1, 'w2.obj (key 3): hidden.', [0, 1, 3])).toBeNull();
    expect(of(2, 'w2.obj (key 3): as in key 1.', [2, 3])?.message).toBe('w2.obj (key 1): as in the pose “w0”.');
    expect(of(-1, 'All keys are 2 m high.', [2, 3])).not.toBeNull();
  });

  it('list the keys that are left, of at least two', () => {
    const same = 'Keys 2, 3 and 4 are the same pose, so nothing moves.';
    expect(of(3, same, [3, 0, 1])?.message).toBe('Keys 1 and 3 are the same pose, so nothing moves.');
    const first = of(3, same, [0, 1, 2])!;
    expect([first.key, first.message]).toEqual([2, 'Keys 2 and 3 are the same pose, so nothing moves.']);
    expect(of(3, same, [0, 3])).toBeNull();
    const many = of(9, 'Keys 1 to 10 are the same.', [0, 1, 2, 3, 4, 5, 6, 7, 9])!;
    expect([many.key, many.message]).toEqual([8, 'Keys 1 to 9 are the same.']);
  });

  it('keep numbers in names of files', () => {
    expect(of(4, 'key 3.obj (key 5): torn.', [4, 2])?.message).toBe('key 3.obj (key 1): torn.');
  });
});
