/** <shape-spline> on the page of examples, as it is built. */
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';

test.use({ contextOptions: { reducedMotion: 'reduce' } });

async function open(page: Page): Promise<string[]> {
  const problems: string[] = [];
  page.on('pageerror', (error) => problems.push(error.message));
  await page.goto('./embed/examples/index.html');
  await page.waitForFunction(() => (document.getElementById('plain') as ShapeSplineElement).report !== null);
  return problems;
}

/** The picture that is seen, as text. */
const picture = (page: Page, id = 'plain'): Promise<string> =>
  page.evaluate((name) => {
    const shape = document.getElementById(name) as ShapeSplineElement;
    return shape.shadowRoot!.querySelector('canvas')!.toDataURL();
  }, id);

test('a seek resolves when the shape is drawn', async ({ page }, info) => {
  test.skip(info.project.name === 'dev', 'the examples are built');
  const problems = await open(page);
  const seek = (t: number): Promise<void> =>
    page.evaluate((time) => (document.getElementById('plain') as ShapeSplineElement).seek(time), t);
  await seek(0);
  const first = await picture(page);
  await seek(0.75);
  const other = await picture(page);
  expect(other).not.toBe(first);
  await seek(0);
  expect(await picture(page)).toBe(first);
  expect(problems).toEqual([]);
});

test('what is far below is neither fetched nor computed; keys move the time', async ({ page }, info) => {
  test.skip(info.project.name === 'dev', 'the examples are built');
  await open(page);
  const far = await page.evaluate(() => {
    const { report, stats } = document.getElementById('scrolled') as ShapeSplineElement;
    return { report, computed: stats.framesComputed };
  });
  expect(far).toEqual({ report: null, computed: 0 });
  const time = (): Promise<number> =>
    page.evaluate(() => (document.getElementById('plain') as ShapeSplineElement).currentTime);
  await page.locator('#plain [part=timeline]').focus();
  await page.keyboard.press('End');
  await expect.poll(time).toBe(1);
  await page.keyboard.press('Home');
  await expect.poll(time).toBe(0);
});

test('a file that is missing is told in a sentence', async ({ page }, info) => {
  test.skip(info.project.name === 'dev', 'the examples are built');
  await open(page);
  const detail = await page.evaluate(
    () =>
      new Promise<{ code: string; message: string; key: number }>((done) => {
        const shape = document.createElement('shape-spline');
        shape.addEventListener('error', (event) => done(event.detail));
        shape.loading = 'eager';
        shape.src = 'gone.glb';
        document.body.append(shape);
      }),
  );
  expect(detail).toMatchObject({ code: 'not-found', key: 0 });
  expect(detail.message).toMatch(/gone\.glb could not be fetched \(404 Not Found\)\. Check the address\./);
});
