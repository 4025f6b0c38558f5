/** Changed options: those that only change the curve refit without starting a worker to encode. */
import type { Page } from '@playwright/test';
import { expect, it } from 'vitest';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';
import { KEYS, on, openElements, picture, seek, told, useElements, when } from './support/element.ts';

useElements();

type Attributes = Readonly<Record<string, string>>;

const REFITTED: readonly Attributes[] = [
  { boundary: 'hermite', 'start-speed': '3' },
  { boundary: 'hermite', 'end-speed': '0' },
  { boundary: 'periodic' },
  { boundary: 'periodic', period: '5' },
  { method: 'linear' },
  { method: 'geodesic', 'in-place': '' },
  { tension: '1 0.5', bias: '0 1' },
  { compare: 'linear' },
  { 'key-times': '0 2' },
  { 'key-times': '-1 0.5', boundary: 'hermite', 'start-speed': '0' },
  {},
];
const NAMES = [...new Set(REFITTED.flatMap((one) => Object.keys(one)))];
const T = 0.4;

const element = (id: string, attributes: Attributes = {}): string =>
  `<shape-spline id="${id}" src="${KEYS}" ${Object.entries(attributes)
    .map(([name, text]) => `${name}="${text}"`)
    .join(' ')}></shape-spline>`;

/** Each sequence is encoded in a separate worker. */
function startedFrom(page: Page): () => number {
  let count = 0;
  page.on('worker', () => {
    count += 1;
  });
  return () => count;
}

const change = (page: Page, attributes: Attributes, id = 'a'): Promise<void> =>
  on(
    page,
    (shape, [names, wanted]) => {
      for (const name of names)
        if (name in wanted) shape.setAttribute(name, wanted[name]!);
        else shape.removeAttribute(name);
    },
    [NAMES, attributes] as const,
    id,
  );

it('a changed motion equals that of an element with these options from the start, without another worker', async () => {
  const fresh = await openElements(REFITTED.map((attributes, i) => element(`n${i}`, attributes)).join(''));
  const page = await openElements(element('a'));
  await when(page, 'load');
  const asked = (): Promise<number> => page.evaluate(() => performance.getEntriesByType('resource').length);
  const before = await asked();
  const started = startedFrom(page);
  const seen = new Set<string>();
  for (const [i, attributes] of REFITTED.entries()) {
    await change(page, attributes);
    await seek(page, T);
    await seek(fresh, T, `n${i}`);
    const shown = await picture(page);
    expect(shown === (await picture(fresh, `n${i}`)), JSON.stringify(attributes)).toBe(true);
    seen.add(shown);
  }
  expect(seen.size).toBeGreaterThan(REFITTED.length - 3);
  expect(started()).toBe(0);
  expect(await asked()).toBe(before);
  expect(await told(page, 'error')).toEqual([]);
  // A different encoding starts one worker. This checks the counter.
  await on(page, (shape) => (shape.stretch = 'log'));
  await seek(page, T);
  expect(started()).toBe(1);
});

it('of many changes during a computation, the last one takes effect', async () => {
  const page = await openElements(element('a'));
  await when(page, 'load');
  const started = startedFrom(page);
  await on(page, async (shape) => {
    shape.boundary = 'hermite';
    for (let i = 0; i < 60; i += 1) {
      shape.startSpeed = i / 10;
      await new Promise((later) => setTimeout(later, 5));
    }
    shape.startSpeed = 3;
    await shape.seek(0.4);
  });
  const calm = await openElements(element('a', { boundary: 'hermite', 'start-speed': '3' }));
  await when(calm, 'load');
  await seek(calm, T);
  expect((await picture(page)) === (await picture(calm))).toBe(true);
  expect(started()).toBe(0);
});

it('elements with the same keys share the encoding, also for different motions', async () => {
  const page = await openElements(element('a') + element('b'));
  await Promise.all([when(page, 'load', 'a'), when(page, 'load', 'b')]);
  await Promise.all([seek(page, T, 'a'), seek(page, T, 'b')]);
  const before = await picture(page, 'b');
  const started = startedFrom(page);
  await change(page, { boundary: 'hermite', 'start-speed': '3' });
  await seek(page, T);
  expect(started()).toBe(0);
  await seek(page, T, 'b');
  expect((await picture(page, 'b')) === before).toBe(true);
  expect((await picture(page, 'a')) === before).toBe(false);
  await change(page, {});
  await seek(page, T);
  expect((await picture(page, 'a')) === before).toBe(true);
  expect(started()).toBe(0);
  await page.evaluate(() => {
    for (const shape of document.querySelectorAll('shape-spline')) shape.boundary = 'periodic';
  });
  await Promise.all([seek(page, T, 'a'), seek(page, T, 'b')]);
  expect((await picture(page, 'a')) === (await picture(page, 'b'))).toBe(true);
  expect(started()).toBe(0);
});

it('an impossible change is reported, and the next change starts from the previous state', async () => {
  const page = await openElements(element('a'));
  await when(page, 'load');
  await seek(page, T);
  const before = await picture(page);
  const started = startedFrom(page);
  await change(page, { 'key-times': '0 1 2' });
  expect(await when(page, 'error')).toEqual({
    code: 'time-count-mismatch',
    message: 'There are 3 times for 2 keys. Give one per key.',
    key: -1,
  });
  await change(page, { tension: '1 2 3' });
  expect(await when(page, 'error', 'a', 2)).toMatchObject({ key: -1, message: expect.stringMatching(/tension/i) });
  await change(page, {});
  await seek(page, T);
  expect((await picture(page)) === before).toBe(true);
  expect(started()).toBe(0);
});

it('the time stays where it is, within the keys as they are now', async () => {
  const page = await openElements(element('a'));
  await when(page, 'load');
  await seek(page, 0.5);
  const time = async (attributes: Attributes): Promise<unknown> => {
    await change(page, attributes);
    return on(page, async (shape: ShapeSplineElement) => {
      await shape.evaluate(0);
      return [shape.currentTime, shape.duration];
    });
  };
  expect(await time({ 'key-times': '0 4' })).toEqual([0.5, 4]);
  await seek(page, 3);
  expect(await time({ 'key-times': '0 2' })).toEqual([2, 2]);
  expect(await time({ 'key-times': '5 6' })).toEqual([5, 1]);
  await seek(page, 8);
  expect(await time({})).toEqual([8, 1]);
});

it('shapes that seem to lie down are rotated upright, unless the page sets the up axis', async () => {
  const page = await openElements('<shape-spline id="a"></shape-spline>');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const heights = await on(page, async (shape) => {
    // Pyramids along z, beside the plane y = 0.
    const pyramid = (apex: number): string =>
      `OFF\n5 6 0\n-1 3 0\n1 3 0\n1 5 0\n-1 5 0\n${apex} 4 3\n` +
      '3 0 2 1\n3 0 3 2\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n';
    shape.keys = [0, 0.5].map((apex) => new File([pyramid(apex)], `${apex}.off`));
    const height = async (): Promise<number> => {
      const { positions } = await shape.evaluate(0);
      const ys = [...positions].filter((_, i) => i % 3 === 1);
      return Math.max(...ys) - Math.min(...ys);
    };
    const stood = await height();
    shape.up = 'y';
    return [stood, await height()];
  });
  expect(heights).toEqual([expect.closeTo(3, 4), expect.closeTo(2, 4)]);
});
