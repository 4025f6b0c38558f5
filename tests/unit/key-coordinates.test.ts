/** Angles between patches and stretches, for shapes with known values. */
import { describe, expect, it } from 'vitest';
import { keyCoordinates } from '../../web/study/key-coordinates.ts';
import { bar, moved } from '../engine/support/shapes.ts';

const mesh = bar(2, 20);
const faces = mesh.indices.length / 3;
/** The lower and upper half of the bar, by the height of a face's first vertex. */
const patches = Int32Array.from({ length: faces }, (_, face) => {
  const heights = [0, 1, 2].map((corner) => mesh.positions[3 * mesh.indices[3 * face + corner]! + 2]!);
  return Math.min(...heights) < 5 - 1e-6 ? 0 : 1;
});

/** Degrees. The ring of faces at the fold is sheared and belongs to the upper half. */
const SHEARED = 1.5;

/** The upper half rotated about the x axis through its lower end, and the whole bar rotated about z. */
const folded = (degrees: number, whole = 0): Float32Array => {
  const [a, b] = [degrees, whole].map((angle) => (angle * Math.PI) / 180) as [number, number];
  return moved(mesh, (x, y, z) => {
    const up = z - 5;
    const [v, w] = up > 0 ? [y * Math.cos(a) - up * Math.sin(a), y * Math.sin(a) + up * Math.cos(a) + 5] : [y, z];
    return [x * Math.cos(b) - v * Math.sin(b), x * Math.sin(b) + v * Math.cos(b), w];
  });
};

const measured = (poses: Float32Array[]) => keyCoordinates({ faces: mesh.indices, patches, poses, reference: 0 }, 4);

describe('coordinates of a shape at its keys', () => {
  it('have the angle between two patches, for any rotation of the whole', () => {
    const [angle] = measured([folded(0), folded(40, 75), folded(-25, 200), folded(90)]);
    expect(angle).toMatchObject({ kind: 'angle', patches: [0, 1] });
    [0, 40, -25, 90].forEach((degrees, key) => expect(Math.abs(angle!.values[key]! - degrees)).toBeLessThan(SHEARED));
  });

  it('follow a fold beyond half a turn', () => {
    const [angle] = measured([0, 120, 240, 400].map((degrees) => folded(degrees)));
    [0, 120, 240, 400].forEach((degrees, key) => expect(Math.abs(angle!.values[key]! - degrees)).toBeLessThan(SHEARED));
  });

  it('have the stretch of each patch', () => {
    const twice = moved(mesh, (x, y, z) => [2 * x, 2 * y, 2 * z]);
    const stretches = measured([mesh.positions, twice]).filter(({ kind }) => kind === 'stretch');
    expect(stretches.map(({ patches: [patch] }) => patch).sort()).toEqual([0, 1]);
    for (const { values } of stretches) values.forEach((value, key) => expect(value).toBeCloseTo(key + 1, 6));
  });

  it('offer the requested number, those with the largest changes first', () => {
    const all = keyCoordinates({ faces: mesh.indices, patches, poses: [folded(0), folded(60)], reference: 0 }, 1);
    expect(all.map(({ kind }) => kind)).toEqual(['angle', 'stretch']);
  });
});
