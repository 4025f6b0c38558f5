/** The content of a key's thumbnail. */
import { expect, it } from 'vitest';
import { pictureExtent } from '../../web/viewer/thumbnails.ts';

const extent = (radius: number) => ({ points: new Float32Array(3), radius });

it('a shape that travels far fills its thumbnail; other shapes are shown at their position', () => {
  const whole = extent(10);
  const [small, large] = [extent(2), extent(8)];
  expect(pictureExtent(small, whole)).toBe(small);
  expect(pictureExtent(large, whole)).toBe(whole);
});
