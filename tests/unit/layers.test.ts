import { expect, it } from 'vitest';
import { CASTER_LAYERS } from '../../web/viewer/contact-shadow.ts';
import { FIRST_EXTRAS, FIRST_SHAPE, MAX_VIEWS } from '../../web/viewer/contents.ts';

it('shadow casters are on layers that no view shows, below 32', () => {
  const seen = Array.from({ length: MAX_VIEWS }, (_, view) => [FIRST_SHAPE + view, FIRST_EXTRAS + view]).flat();
  const casting = seen.map((layer) => layer + CASTER_LAYERS);
  expect(new Set([0, ...seen, ...casting]).size).toBe(1 + 4 * MAX_VIEWS);
  expect(Math.max(...casting)).toBeLessThan(32);
});
