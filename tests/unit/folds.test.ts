/** Whether a surface folds from one key to the next, with shared and with split vertices. */
import { expect, it } from 'vitest';
import { folds } from '../../web/app/analysis/folds.ts';
import { split } from '../engine/support/shapes.ts';

const faces = Uint32Array.of(0, 1, 2, 1, 3, 2);
const degrees = (angle: number): number => (angle * Math.PI) / 180;
/** Two triangles in the x-y plane, the second rotated about their edge. */
const folded = (angle: number): Float32Array => {
  const [out, up] = [Math.cos(degrees(angle)), Math.sin(degrees(angle))];
  return Float32Array.of(-1, 0, 0, 0, -1, 0, 0, 1, 0, out, 0, up);
};

const foldsFrom = (angles: readonly number[], over: Uint32Array, of = folded): Promise<boolean> =>
  folds({ faces: over, keys: angles.length, key: (k) => of(angles[k]!), pause: async () => undefined });

it('a surface folds where an angle changes by more than 90 degrees between two keys', async () => {
  expect(await foldsFrom([0, 80, 160], faces)).toBe(false);
  expect(await foldsFrom([-45, 44], faces)).toBe(false);
  expect(await foldsFrom([-46, 45], faces)).toBe(true);
  // Across 180 degrees.
  expect(await foldsFrom([170, -170], faces)).toBe(false);
});

it('vertices that are split along an edge are one, unless they part in another key', async () => {
  const apart = split(faces, [folded(0)]);
  const splitAt = (angle: number): Float32Array => split(faces, [folded(angle)]).poses[0]!;
  expect(await foldsFrom([0, 100], apart.faces, splitAt)).toBe(true);
  expect(await foldsFrom([0, 80], apart.faces, splitAt)).toBe(false);
  // Exporters may round the copies differently.
  const rounded = (angle: number): Float32Array => splitAt(angle).map((value, i) => value + (i % 2) * 1e-7);
  expect(await foldsFrom([0, 100], apart.faces, rounded)).toBe(true);
  // Wherever the edge lies, also across a border between the cells of the search.
  for (let step = 0; step < 40; step += 1) {
    const across = (angle: number): Float32Array =>
      splitAt(angle).map((value, i) => value + (i % 3 === 0 && i > 0 ? 1e-6 * (step + Number(i >= 9)) : 0));
    expect(await foldsFrom([0, 100], apart.faces, across), `moved by ${step} µm`).toBe(true);
  }
  const parting = (angle: number): Float32Array =>
    splitAt(angle).map((value, i) => (i >= 9 && i % 3 === 0 ? value + angle : value));
  expect(await foldsFrom([0, 100], apart.faces, parting)).toBe(false);
});

it('a fold is looked for in short parts', async () => {
  const strip = Uint32Array.from({ length: 3000 }, (_, i) => Math.floor(i / 3) + (i % 3));
  let pauses = 0;
  const found = await folds({
    faces: strip,
    keys: 2,
    key: () => Float32Array.from({ length: 3006 }, (_, i) => (i % 3 === 0 ? Math.floor(i / 3) : (i * i) % 7)),
    pause: async () => {
      pauses += 1;
    },
  });
  expect(found).toBe(false);
  expect(pauses).toBeGreaterThan(10);
});
