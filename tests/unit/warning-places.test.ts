import { describe, expect, it } from 'vitest';
import { momentOf } from '../../web/app/drawing/marking.ts';
import { renumbered, withSentences } from '../../web/engine/api/sentences.ts';
import type { Warning } from '../../web/engine/api/types.ts';
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
  about: 'Between',
  start: 'Between key 4 and key 5',
  text: 'neighbouring regions turn.',
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
  const place = { face: -1, patches: [] };
  const of = (warning: Pick<Warning, 'key' | 'count' | 'about' | 'message'>, poses: number[]) =>
    renumbered(withSentences([{ ...place, ...warning, code: 'one' }], 10)[0]!, (pose) => poses.indexOf(pose));
  const split = { key: 2, count: 1, about: 'Key', message: '(w2): torn.' };

  it('name and show the key that the pose is now', () => {
    const warning = of(split, [0, 2, 3])!;
    expect([warning.key, warning.message]).toEqual([1, 'Key 2 (w2): torn.']);
    expect(momentOf(warning, [0, 1, 3], [0, 3])).toBe(1);
    expect(of(split, [2, 3, 0])?.message).toBe('Key 1 (w2): torn.');
  });

  it('are dropped without their key, and stay if they have none', () => {
    expect(of(split, [0, 1, 3])).toBeNull();
    const all = { key: -1, count: 1, about: '', message: 'All keys are 2 m high.' };
    expect(of(all, [2, 3])?.message).toBe('All keys are 2 m high.');
  });

  it('list the keys that are left, of at least two', () => {
    const same = { key: 3, count: 3, about: 'Keys', message: 'are the same pose.' };
    expect(of(same, [0, 1, 2, 3])?.message).toBe('Keys 2, 3 and 4 are the same pose.');
    expect(of(same, [3, 0, 1])?.message).toBe('Keys 1 and 3 are the same pose.');
    expect(of(same, [0, 1, 2])).toMatchObject({ key: 2, message: 'Keys 2 and 3 are the same pose.' });
    expect(of(same, [0, 3])).toBeNull();
    const many = of({ ...same, key: 9, count: 10 }, [0, 1, 2, 3, 4, 5, 6, 7, 9])!;
    expect([many.key, many.message]).toEqual([8, 'Keys 1 to 9 are the same pose.']);
  });
});
