import { expect, it } from 'vitest';
import { chosenSamples, partOf, shapeLines } from '../../web/app/panels/ghost-shapes.ts';
import type { Sample } from '../../web/app/sources/samples.ts';

const sample = (id: string): Sample => ({ id, title: id }) as Sample;

it('each shape has a line up to its largest ghost; sizes without any ghost are omitted', () => {
  const { faces, series } = shapeLines([
    { id: 'large', title: 'Large', kg: [5, 4, 3, 2, 1] },
    { id: 'small', title: 'Small', kg: [3, 2] },
  ]);
  expect(faces).toEqual([500, 1000, 2000, 3000, 5000]);
  expect(series.map(({ label, values }) => [label, ...values])).toEqual([
    ['Large', 5, 4, 3, 2, 1],
    ['Small', 3, 2],
  ]);
  expect(new Set(series.map(({ style }) => style)).size).toBe(2);
});

it('progress names the shape and never falls from one shape to the next', () => {
  const parts = [0, 1, 2, 3].flatMap((index) =>
    [0, 0.5, 1].map((fraction) => partOf({ stage: 'encoding', fraction }, `Shape ${index}`, index, 4)),
  );
  expect(parts[4]).toEqual({ stage: 'Shape 1: encoding', fraction: 0.375 });
  const fractions = parts.map(({ fraction }) => fraction);
  expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
  expect([fractions[0], fractions.at(-1)]).toEqual([0, 1]);
});

it('four samples are compared; a missing one is named', () => {
  const all = ['column', 'cactus', 'dachshund', 'octopus', 'hand'].map(sample);
  expect(chosenSamples(all).map(({ id }) => id)).toEqual(['octopus', 'hand', 'dachshund', 'cactus']);
  const without = all.filter(({ id }) => id !== 'hand');
  expect(() => chosenSamples(without)).toThrow('this page has no sample “hand”.');
});
