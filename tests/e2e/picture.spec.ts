/** The drawn image against the engine's numbers, and the display options. */
import { changedShare, colours, decode, saturation } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

interface Overlap {
  /** Share of the engine's vertices that project onto drawn pixels of the shape. */
  verticesOnShape: number;
  /** Share of the shape's pixels close to a projected vertex. */
  shapeNearVertices: number;
  shapePixels: number;
}

/** Projects the engine's vertices (not the viewer's) and compares them with a screenshot of the canvas. */
async function overlap(app: App, t: number, drawn = t): Promise<Overlap> {
  await app.setTime(drawn);
  const picture = decode(await app.picture());
  const projected = await app.page.evaluate(async (time) => {
    const hook = window.__shapespline!;
    return Array.from(hook.project(await hook.evaluate(time)));
  }, t);
  const { width, height } = picture;
  // Only the shape has a strong colour; floor, shadow and background are grey.
  const shape = Uint8Array.from(colours(picture), (colour) => (saturation(colour) > 36 ? 1 : 0));
  const dots = new Uint8Array(width * height);
  const nearShape = grown(shape, width, 2);
  let inside = 0;
  let seen = 0;
  for (let i = 0; i < projected.length; i += 2) {
    const [x, y] = [Math.round(projected[i]!), Math.round(projected[i + 1]!)];
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    seen += 1;
    inside += nearShape[y * width + x]!;
    dots[y * width + x] = 1;
  }
  const nearDots = grown(dots, width, 9);
  const shapePixels = shape.reduce((sum, on) => sum + on, 0);
  const covered = shape.reduce((sum, on, i) => sum + (on & nearDots[i]!), 0);
  return { verticesOnShape: inside / seen, shapeNearVertices: covered / shapePixels, shapePixels };
}

/** All pixels within a square around any set pixel. */
function grown(mask: Uint8Array, width: number, radius: number): Uint8Array {
  const height = mask.length / width;
  const result = new Uint8Array(mask.length);
  mask.forEach((on, i) => {
    if (!on) return;
    const [x, y] = [i % width, Math.floor(i / width)];
    const [left, right] = [Math.max(x - radius, 0), Math.min(x + radius, width - 1)];
    for (let row = Math.max(y - radius, 0); row <= Math.min(y + radius, height - 1); row += 1)
      result.fill(1, row * width + left, row * width + right + 1);
  });
  return result;
}

/** A link to the shape alone, entirely in the phase colour. */
const COLOURED = '#sample=cactus&colour=phase&floor=0';

test('the drawn silhouette matches the engine’s vertices', async ({ app }) => {
  await app.open({ hash: COLOURED });
  const { verticesOnShape, shapeNearVertices, shapePixels } = await overlap(app, 1.2);
  expect(shapePixels).toBeGreaterThan(2000);
  expect(verticesOnShape).toBeGreaterThan(0.99);
  expect(shapeNearVertices).toBeGreaterThan(0.97);
  // The vertices of another time do not fit the image, so the comparison can distinguish shapes.
  const wrong = await overlap(app, 1.2, 0);
  expect(Math.min(wrong.verticesOnShape, wrong.shapeNearVertices)).toBeLessThan(0.9);
});

test('the look changes the image, but not the shape', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await app.setTime(0.3);
  const positions = await app.positions();
  await app.by('look-toggle').click();
  let before = await app.picture();
  for (const [what, change] of [
    ['flat', () => app.by('shading-flat').check()],
    ['wireframe', () => app.by('wireframe').check()],
    ['patches', () => app.by('colouring-patches').check()],
    ['onion', () => app.by('onion').check()],
  ] as const) {
    await change();
    const after = await app.picture();
    expect(changedShare(before, after), what).toBeGreaterThan(2e-3);
    before = after;
  }
  expect(await app.positions()).toEqual(positions);
  await app.expectNoProblems();
});

test('onion skins are behind the shape, in the chosen number, with different colours before and after', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ hash: `${COLOURED}&t=0.5` });
  await app.by('look-toggle').click();
  const alone = decode(await app.picture());
  await app.by('onion').check();
  const few = decode(await app.picture());
  for (const [field, value] of [
    ['onion-skins', '4'],
    ['onion-spacing', '0.05'],
  ] as const) {
    await app.by(field).fill(value);
    await app.by(field).press('Enter');
  }
  const many = decode(await app.picture());
  const [before, after, more] = [alone, few, many].map((picture) => [...colours(picture)]);
  const shape = grown(
    Uint8Array.from(before!, (colour) => (saturation(colour) > 36 ? 0 : 1)),
    alone.width,
    2,
  ); // the distance is 0 inside the shape
  const changed = (other: typeof before, inside: boolean): number =>
    before!.filter(
      (colour, i) => (shape[i] === 0) === inside && colour.some((value, k) => Math.abs(value - other![i]![k]!) > 8),
    ).length;
  expect(changed(after, true)).toBe(0);
  expect(changed(more, true)).toBe(0);
  expect(changed(after, false)).toBeGreaterThan(1000);
  expect(more).not.toEqual(after);
  await expect.poll(() => app.page.url()).toContain('onionSkins=4&onionSpacing=0.05');
  await app.by('onion-spacing').fill('');
  await app.by('onion-spacing').press('Enter');
  await expect.poll(async () => (await app.state()).view.onionSpacing).toBeNull();
});

test('a film strip has times under its shapes, the chosen number of shapes, and is part of links', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ sample: 'cactus' });
  const names = app.by('film-labels').locator('span');
  await expect(names).toHaveCount(0);
  await app.page.keyboard.press('i');
  await app.settled();
  await expect(names).toHaveText([
    'Key 1',
    'Key 2',
    'Key 3',
    /^-0\.16/,
    /^0\.16/,
    /^0\.33/,
    /^0\.66/,
    /^0\.83/,
    /^1\.16/,
  ]);
  // The labels are below their shapes and follow them.
  const left = async (): Promise<number> => (await names.nth(0).boundingBox())!.x;
  const before = await left();
  await app.by('look-toggle').click();
  await app.by('film-shapes').fill('4');
  await app.by('film-shapes').press('Enter');
  await app.settled();
  await expect(names).toHaveText(['Key 1', 'Key 3', '-1.000 s', '2.000 s']);
  expect(await left()).not.toBeCloseTo(before, 0);
  await expect.poll(() => app.page.url()).toContain('filmShapes=4');
  await app.by('film').uncheck();
  await app.settled();
  await expect(names).toHaveCount(0);
  expect((await app.state()).view.filmShapes).toBeNull();
});

test('the view is restored after a film strip, also if onion skins follow', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await app.by('view-right').click();
  await app.settled();
  const camera = async () => (await app.state()).view.camera!;
  const before = await camera();
  for (const next of ['i', 'o']) {
    await app.page.keyboard.press('i');
    await app.settled();
    await expect.poll(async () => (await camera()).position).not.toEqual(before.position);
    await app.page.keyboard.press(next);
    await app.settled();
    await expect.poll(camera).toEqual(before);
  }
});

test('standard views, fit, orbit, pan and zoom move one camera', async ({ app }) => {
  await app.open();
  const poses = new Set<string>();
  const pose = async (): Promise<string> => {
    await app.settled();
    return JSON.stringify((await app.state()).view.camera);
  };
  for (const view of ['view-front', 'view-top', 'view-right']) {
    await app.by(view).click();
    poses.add(await pose());
  }
  const { camera } = (await app.state()).view;
  expect(camera!.position[1]).toBeCloseTo(camera!.target[1], 3);
  expect(camera!.position[2]).toBeCloseTo(camera!.target[2], 3);
  const box = (await app.by('viewport').boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await app.page.mouse.move(x, y);
  await app.page.mouse.down();
  await app.page.mouse.move(x + 60, y + 30, { steps: 4 });
  await app.page.mouse.up();
  poses.add(await pose());
  await app.page.mouse.down({ button: 'right' });
  await app.page.mouse.move(x + 90, y + 60, { steps: 4 });
  await app.page.mouse.up({ button: 'right' });
  poses.add(await pose());
  await app.page.mouse.wheel(0, 300);
  await expect.poll(async () => poses.has(await pose())).toBe(false);
  poses.add(await pose());
  await app.by('viewport').focus();
  await app.page.keyboard.press('ArrowLeft');
  poses.add(await pose());
  await app.page.keyboard.press('Shift+ArrowUp');
  poses.add(await pose());
  await app.page.keyboard.press('+');
  poses.add(await pose());
  await app.by('fit').click();
  poses.add(await pose());
  expect(poses.size).toBe(10);
  expect((await app.state()).time).toBe(0);
});

test('dark and light themes differ, and the choice is stored', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const background = (): Promise<string> =>
    app.page.evaluate(() => getComputedStyle(document.querySelector('.deck')!).backgroundColor);
  await app.page.emulateMedia({ colorScheme: 'light' });
  const light = await background();
  await app.page.emulateMedia({ colorScheme: 'dark' });
  const dark = await background();
  expect(dark).not.toBe(light);
  await app.by('theme').click();
  expect(await background()).toBe(light);
  await app.open();
  expect(await background()).toBe(light);
  await app.by('theme').click();
  await app.page.emulateMedia({ colorScheme: 'light' });
  expect(await background()).toBe(dark);
});

test.describe('with a lost graphics context', () => {
  test.use({ fresh: true });

  test('a restored graphics context shows the same image', { tag: '@all' }, async ({ app }) => {
    await app.open();
    await app.setTime(0.3);
    const before = await app.picture();
    await app.page.evaluate(async () => {
      const canvas = document.querySelector<HTMLCanvasElement>('.picture canvas')!;
      const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
      const restored = new Promise((resolve) => canvas.addEventListener('webglcontextrestored', resolve));
      extension.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 100));
      extension.restoreContext();
      await restored;
    });
    expect(changedShare(before, await app.picture())).toBeLessThan(0.002);
  });
});

test('a resize while playing loses nothing', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await app.by('play').click();
  for (const [width, height] of [
    [900, 700],
    [360, 640],
    [1400, 900],
  ] as const) {
    await app.page.setViewportSize({ width, height });
    const { time } = await app.state();
    await expect.poll(async () => (await app.state()).time).not.toBe(time);
    const canvas = (await app.by('viewport').locator('canvas').boundingBox())!;
    const host = (await app.by('viewport').boundingBox())!;
    expect([canvas.width, canvas.height].map(Math.round)).toEqual([host.width, host.height].map(Math.round));
  }
  await app.expectNoProblems();
});

/** The mean of all strong colours. */
function meanColour(file: Buffer): number[] {
  const strong = Array.from(colours(decode(file))).filter((colour) => saturation(colour) > 60);
  expect(strong.length).toBeGreaterThan(200);
  return [0, 1, 2].map((channel) => strong.reduce((sum, colour) => sum + colour[channel]!, 0) / strong.length);
}

test.describe('with counted canvas regions', () => {
  test.use({ fresh: true });

  test('thumbnails show the keys like the main view, and are drawn outside the canvas', async ({ app }) => {
    // The widths of all canvas regions that are cleared for drawing.
    await app.page.addInitScript(() => {
      const widths = new Set<number>();
      Object.assign(window, { widths });
      const { clear } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.clear = function (mask) {
        if (this.getParameter(this.FRAMEBUFFER_BINDING) === null) widths.add(this.getParameter(this.SCISSOR_BOX)[2]);
        clear.call(this, mask);
      };
    });
    await app.open({ hash: COLOURED });
    const image = app.by('key-0').locator('img');
    await expect(image).toHaveAttribute('src', /^data:image\/png;base64,/);
    const images = app.by('keys').locator('img[src^="data:image/png;base64,"]');
    await expect(images).toHaveCount(3);
    expect(new Set(await images.evaluateAll((all) => all.map((one) => one.getAttribute('src')))).size).toBe(3);
    const thumbnail = Buffer.from((await image.getAttribute('src'))!.split(',')[1]!, 'base64');
    const { width, height, data } = decode(thumbnail);
    expect([width, height]).toEqual([88, 60]);
    expect([data[3], data.at(-1)]).toEqual([0, 0]);
    await app.setTime(0);
    const seen = meanColour(await app.picture());
    for (const [channel, level] of meanColour(thumbnail).entries())
      expect(Math.abs(level - seen[channel]!), `channel ${channel}`).toBeLessThan(10);
    const widths = await app.page.evaluate(() => [...(window as unknown as { widths: Set<number> }).widths]);
    expect(Math.min(...widths)).toBeGreaterThan(300);
    await app.expectNoProblems();
  });
});

test('no sample is under the introduction, and names of views move with the samples', { tag: '@all' }, async ({
  app,
}) => {
  await app.page.setViewportSize({ width: 1024, height: 768 });
  for (const sample of ['cactus', 'twisted-bar']) {
    await app.open({ sample });
    const [welcome, picture] = [(await app.by('welcome').boundingBox())!, (await app.by('viewport').boundingBox())!];
    const highest = await app.page.evaluate(() => {
      const points = window.__shapespline!.project(window.__shapespline!.positions());
      return points.filter((_, index) => index % 2 === 1).reduce((least, y) => Math.min(least, y), Infinity);
    });
    expect(picture.y + highest, sample).toBeGreaterThan(welcome.y + welcome.height);
  }
  await app.by('compare-linear').check();
  await app.settled();
  const beside = (await app.by('tile-1').boundingBox())!;
  await app.page.setViewportSize({ width: 360, height: 740 });
  await expect.poll(async () => (await app.by('tile-1').boundingBox())!.y).toBeGreaterThan(beside.y + 100);
  expect((await app.by('tile-1').boundingBox())!.x).toBeLessThan(10);
});

test('when a phone is rotated, a fitted shape stays completely visible, and a moved camera stays where it is', async ({
  app,
}) => {
  await app.page.setViewportSize({ width: 844, height: 390 });
  await app.open({ sample: 'octopus' });
  await app.by('fit').click();
  await app.settled();
  const across = () =>
    app.page.evaluate(() => {
      const points = window.__shapespline!.project(window.__shapespline!.positions());
      const x = points.filter((_, index) => index % 2 === 0);
      return [x.reduce((a, b) => Math.min(a, b)), x.reduce((a, b) => Math.max(a, b))] as const;
    });
  await app.page.setViewportSize({ width: 360, height: 740 });
  await expect.poll(async () => (await app.by('viewport').locator('canvas').boundingBox())!.width).toBe(360);
  await app.settled();
  const [left, right] = await across();
  expect(left).toBeGreaterThan(0);
  expect(right).toBeLessThan(360);
  expect(right - left).toBeGreaterThan(200);
  await app.page.evaluate(() => window.__shapespline!.settled());
  const box = (await app.by('viewport').boundingBox())!;
  await app.page.mouse.move(box.x + 180, box.y + 150);
  await app.page.mouse.wheel(0, -400);
  await app.settled();
  const { camera } = (await app.state()).view;
  await app.page.setViewportSize({ width: 844, height: 390 });
  await expect.poll(async () => (await app.by('viewport').locator('canvas').boundingBox())!.width).not.toBe(360);
  await app.settled();
  expect((await app.state()).view.camera).toEqual(camera);
});
