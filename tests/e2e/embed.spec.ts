/** <shape-spline> on the built examples page, and the path to it from the app. */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Page } from '@playwright/test';
import { difference, diagonal, expect, test } from './support.ts';
import { unzip } from '../unzip.ts';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';

// The test uses another page than the app.
test.use({ fresh: true });

async function open(page: Page): Promise<string[]> {
  const problems: string[] = [];
  page.on('pageerror', (error) => problems.push(error.message));
  await page.goto('./embed/examples/index.html');
  await page.waitForFunction(() => (document.getElementById('plain') as ShapeSplineElement).report !== null);
  return problems;
}

test('compared methods, time that follows scrolling, files of the user, and every table', async ({ page }, info) => {
  test.skip(info.project.name === 'dev', 'the examples are built');
  const problems = await open(page);
  const shape = (id: string): Promise<{ time: number; vertices: number | undefined }> =>
    page.evaluate((name) => {
      const { currentTime, report } = document.getElementById(name) as ShapeSplineElement;
      return { time: currentTime, vertices: report?.vertices };
    }, id);
  await page.locator('#compared').scrollIntoViewIfNeeded();
  await expect(page.locator('#compared [part=name]')).toHaveText(['Shape spline', 'Morph targets']);
  await page.locator('#scrolled').scrollIntoViewIfNeeded();
  await expect.poll(async () => (await shape('scrolled')).vertices).toBeGreaterThan(0);
  const before = (await shape('scrolled')).time;
  await page.mouse.wheel(0, 200);
  await expect.poll(async () => (await shape('scrolled')).time).toBeGreaterThan(before);
  const obj = (bend: number): string => `v 0 0 0\nv 1 0 ${bend}\nv 0 1 0\nv 1 1 ${bend}\nf 1 2 3\nf 2 4 3\n`;
  await page
    .locator('#files')
    .setInputFiles(
      [0, 0.5].map((bend) => ({ name: `${bend}.obj`, mimeType: 'model/obj', buffer: Buffer.from(obj(bend)) })),
    );
  await expect.poll(async () => (await shape('dropped')).vertices).toBe(4);
  await expect(page.locator('#react')).toContainText("import 'shapespline/element'");
  await expect(page.locator('#attributes tbody tr').filter({ hasText: 'playback-rate' })).toHaveCount(1);
  await expect(page.locator('#events tbody tr')).toHaveCount(9);
  await expect(page.locator('#members tbody tr').filter({ hasText: 'seek(' })).toHaveCount(1);
  expect(problems).toEqual([]);
});

test('the zip from the app shows its open shape, and opens it again in the app', async ({ app, browser }, info) => {
  test.skip(info.project.name === 'dev', 'the package is built');
  const { page } = app;
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('start-speed-number').fill('2');
  await app.by('start-speed-number').press('Enter');
  await app.settled();
  const middle = await app.positionsAt(0.3);
  const { doc } = await app.state();
  await app.by('export').click();
  await app.by('export-embed').click();
  await expect(app.by('embed-snippet')).toHaveText(
    '<script type="module" src="shapespline/cdn.js"></script>\n' +
      '<shape-spline src="cactus.glb" controls autoplay loop="bounce" alt="Cactus"></shape-spline>',
  );
  await expect(app.by('embed-dialog').getByRole('link')).toHaveAttribute('href', './embed/examples/index.html');
  const coming = page.waitForEvent('download');
  await app.by('embed-save').click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('cactus-page.zip');
  const zip = readFileSync(await download.path());
  await app.expectNoProblems();

  // A server without content types on another port; all other hosts are blocked.
  const files = new Map((await unzip(new Blob([zip]))).map(({ name, bytes }) => [`/${name}`, bytes]));
  const server = createServer((request, response) => {
    const bytes = files.get(request.url === '/' ? '/index.html' : request.url!);
    const type =
      request.url === '/' ? 'text/html' : request.url!.endsWith('.js') ? 'text/javascript' : 'application/x-any';
    response.writeHead(bytes ? 200 : 404, { 'content-type': type }).end(bytes);
  });
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready));
  const home = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
  const visitor = await browser.newPage();
  const strange: string[] = [];
  visitor.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(home)) strange.push(request.url());
  });
  visitor.on('console', (message) => message.type() === 'error' && strange.push(message.text()));
  await visitor.goto(home);
  const shown = await visitor.evaluate(async () => {
    await customElements.whenDefined('shape-spline');
    const shape = document.querySelector<ShapeSplineElement>('shape-spline')!;
    const frame = await shape.evaluate(0.3);
    return { positions: [...frame.positions], range: shape.duration, height: shape.offsetHeight };
  });
  expect(difference(shown.positions, middle)).toBeLessThan(1e-3 * diagonal(middle));
  expect(shown.range).toBe(doc.keys.at(-1)!.time - doc.keys[0]!.time);
  expect(shown.height).toBe(visitor.viewportSize()!.height);
  expect(strange.filter((one) => !one.includes('favicon'))).toEqual([]);
  await visitor.close();
  server.close();

  await app.by('file-input').setInputFiles({ name: 'cactus-page.zip', mimeType: 'application/zip', buffer: zip });
  await expect.poll(async () => (await app.state()).source).toMatchObject({ kind: 'files' });
  await app.settled();
  expect((await app.state()).doc.motion).toEqual(doc.motion);
  await app.expectNoProblems();
});

test(
  'the example in React is live: it shows its time, and its button restarts it',
  { tag: '@all' },
  async ({ page }, info) => {
    test.skip(info.project.name === 'dev', 'the examples are built');
    const problems = await open(page);
    await page.locator('#in-react').scrollIntoViewIfNeeded();
    const shape = page.locator('#in-react shape-spline');
    await expect.poll(() => shape.evaluate((one: ShapeSplineElement) => one.report !== null)).toBe(true);
    await shape.evaluate((one: ShapeSplineElement) => one.seek(0.5));
    const said = page.locator('#in-react output');
    await expect(said).toHaveText('0.50 s');
    await page.getByRole('button', { name: 'From the start' }).click();
    await expect(said).toHaveText('0.00 s');
    expect(problems).toEqual([]);
  },
);
