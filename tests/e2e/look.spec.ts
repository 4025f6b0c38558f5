/** Default look of a shape: its own material or clay, with the phase on the floor and along its outline. */
import { colours, decode, matching, saturation } from './png.ts';
import type { Colour } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

/** The paper's colours, as in the ring. */
const PHASES = {
  key: { t: 0, colour: [0, 114, 178] },
  between: { t: 0.25, colour: [0, 158, 115] },
  beyond: { t: 1.3, colour: [230, 159, 0] },
} as const;

/** Number of image pixels within some levels of a colour. */
const near = (picture: Buffer, colour: Colour, levels = 34): number =>
  matching(picture, (seen) => seen.every((level, channel) => Math.abs(level - colour[channel]!) <= levels)).count;

for (const scheme of ['light', 'dark'] as const) {
  test(`the ring on the floor has the colour of the phase, and no other, in the ${scheme} theme`, {
    tag: scheme === 'dark' ? '@all' : [],
  }, async ({ app }) => {
    await app.page.emulateMedia({ colorScheme: scheme });
    await app.open({ sample: 'twisted-bar' });
    let ringed = 0;
    for (const [name, { t, colour }] of Object.entries(PHASES)) {
      await app.setTime(t);
      const picture = await app.picture();
      ringed = near(picture, colour);
      expect(ringed, name).toBeGreaterThan(700);
      for (const [other, { colour: wrong }] of Object.entries(PHASES))
        if (other !== name) expect(near(picture, wrong), `${other} at ${name}`).toBeLessThan(150);
    }
    await app.page.keyboard.press('g');
    await app.nextFrame();
    // The outline has the colour too.
    expect(near(await app.picture(), PHASES.beyond.colour)).toBeLessThan(ringed / 2);
    await app.expectNoProblems();
  });
}

/** Mean colour of the pixels at the shape's vertices. */
async function meanOnShape(app: App): Promise<number[]> {
  const picture = decode(await app.picture());
  const places = await app.page.evaluate(() =>
    Array.from(window.__shapespline!.project(window.__shapespline!.positions())),
  );
  const all = Array.from(colours(picture));
  const sum = [0, 0, 0];
  for (let i = 0; i < places.length; i += 2) {
    const colour = all[Math.round(places[i + 1]!) * picture.width + Math.round(places[i]!)];
    colour?.forEach((level, channel) => {
      sum[channel]! += level;
    });
  }
  return sum.map((total) => total / (places.length / 2));
}

async function openObjs(app: App, contents: readonly string[]): Promise<void> {
  await app.by('file-input').setInputFiles(
    contents.map((content, index) => ({
      name: `${index}.obj`,
      mimeType: 'application/octet-stream',
      buffer: Buffer.from(content),
    })),
  );
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
}

const PLATE = ['v -1 0 -1', 'v 1 0 -1', 'v 1 0 1', 'v -1 0 1', 'f 1 3 2', 'f 1 4 3'].join('\n');

test('a file without materials has the clay colour in every phase, or the colour of the phase if chosen', async ({
  app,
}) => {
  await app.open();
  await openObjs(app, [PLATE, PLATE.replace('v 1 0 1', 'v 1 0.2 1')]);
  await app.page.keyboard.press('7');
  for (const { t } of [PHASES.key, PHASES.between]) {
    await app.setTime(t);
    const [r, g, b] = (await meanOnShape(app)) as [number, number, number];
    expect(r, 'warm').toBeGreaterThan(b);
    expect(saturation([r, g, b]), 'nearly grey').toBeLessThan(60);
  }
  await app.by('look-toggle').click();
  await expect(app.by('colouring-texture')).toBeChecked();
  await app.by('colouring-phase').check();
  await app.setTime(0.5);
  const [r, g, b] = (await meanOnShape(app)) as [number, number, number];
  expect(g).toBeGreaterThan(r + 25);
  expect(g).toBeGreaterThan(b + 5);
  await app.expectNoProblems();
});

test('the outline has the colour of the phase', async ({ app }) => {
  await app.open({ hash: '#sample=twisted-bar&floor=0' });
  const blue = ([r, g, b]: Colour): boolean => b > r + 40 && b > g + 20;
  await app.setTime(0);
  const atKey = matching(await app.picture(), blue).count;
  await app.setTime(1.3);
  const beyond = matching(await app.picture(), blue).count;
  expect(atKey).toBeGreaterThan(200);
  expect(beyond).toBeLessThan(atKey / 10);
});

/** A cube standing on the floor or floating above it. */
function cube(height: number): string {
  const corners = [0, 1].flatMap((y) =>
    ['-1 # -1', '1 # -1', '1 # 1', '-1 # 1'].map((xz) => xz.replace('#', `${2 * y + height}`)),
  );
  const faces = ['1 2 3 4', '8 7 6 5', '1 5 6 2', '2 6 7 3', '3 7 8 4', '4 8 5 1'];
  return [...corners.map((corner) => `v ${corner}`), ...faces.map((face) => `f ${face}`)].join('\n');
}

test('a shape on the floor casts a shadow, and a shape above it a fainter one', async ({ app }) => {
  await app.page.emulateMedia({ colorScheme: 'light' });
  await app.open();
  await openObjs(app, [cube(0), cube(3)]);
  const grey = async (t: number): Promise<number> => {
    await app.setTime(t);
    return matching(await app.picture(), (colour) => Math.max(...colour) < 205 && saturation(colour) < 24).count;
  };
  const times = (await app.state()).doc.keys.map(({ time }) => time);
  const withFloor = [await grey(times[0]!), await grey(times[1]!)];
  await app.page.keyboard.press('g');
  await app.nextFrame();
  const [low, high] = [withFloor[0]! - (await grey(times[0]!)), withFloor[1]! - (await grey(times[1]!))];
  expect(low).toBeGreaterThan(120);
  expect(high).toBeLessThan(0.5 * low);
});

test('at 320 px the name of the sample and the speed are not cut off, and at 400 % zoom the shape is visible', async ({
  app,
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 568 });
  await app.open({ hash: '#sample=twisted-bar&boundary=hermite' });
  const cut = await page
    .locator('.gallery-name')
    .first()
    .evaluate((name) => name.scrollWidth > name.clientWidth);
  expect(cut).toBe(false);
  const room = await app.by('speed').evaluate((select: HTMLSelectElement) => {
    const { paddingLeft, paddingRight, font } = getComputedStyle(select);
    const context = document.createElement('canvas').getContext('2d')!;
    context.font = font;
    const text = context.measureText(select.selectedOptions[0]!.text).width;
    return select.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - text;
  });
  expect(room).toBeGreaterThanOrEqual(0);
  await page.setViewportSize({ width: 320, height: 180 });
  expect((await app.by('viewport').boundingBox())!.height).toBeGreaterThanOrEqual(200);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
});
