import { describe, expect, it } from 'vitest';
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
