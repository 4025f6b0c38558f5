/** Heat maps on the surface, and the coordinates of a clicked face. */
import { writeFileSync } from 'node:fs';
import { bar as barMesh, bent } from '../engine/support/shapes.ts';
import { changedShare, decode } from './png.ts';
import { viridis } from '../../web/plots/viridis.ts';
import { type App, diagonal, difference, expect, realFile, test } from './support.ts';

test.use({ sharpness: 1 });

/** The current largest amount. */
const now = async (app: App): Promise<number> =>
  Number(/at most ([\d.]+)/.exec(await app.by('colour-bar-now').innerText())![1]);

/** Position of a colour in the map, regardless of lighting. */
function shareOf([r, g, b]: readonly [number, number, number]): number {
  const size = Math.hypot(r, g, b) || 1;
  const alike = (share: number): number => {
    const [mr, mg, mb] = viridis(share);
    return (r * mr + g * mg + b * mb) / (size * Math.hypot(mr, mg, mb));
  };
  const shares = Array.from({ length: 101 }, (_, i) => i / 100);
  return shares.reduce((best, share) => (alike(share) > alike(best) ? share : best));
}

/** Ranks of the places; equal values have equal ranks. */
const ranksOf = (values: number[]): number[] =>
  values.map((value) => values.filter((other) => other < value).length + values.filter((o) => o === value).length / 2);

function correlation(a: number[], b: number[]): number {
  const centred = (values: number[]): number[] => {
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return values.map((value) => value - mean);
  };
  const [x, y] = [centred(ranksOf(a)), centred(ranksOf(b))];
  const dot = (p: number[], q: number[]): number => p.reduce((sum, value, i) => sum + value * q[i]!, 0);
  return dot(x, y) / Math.sqrt(dot(x, x) * dot(y, y));
}

test('colours follow the numbers: larger distances have higher colours', async ({ app }) => {
  await app.open({ hash: '#sample=cactus&compare=linear&colour=distance' });
  await app.setTime(0.3);
  await expect(app.by('colour-bar')).toContainText('% of the model’s size');
  const { places, far } = await app.page.evaluate(() => {
    const [a, b] = [window.__shapespline!.positions(0), window.__shapespline!.positions(1)];
    const apart = Array.from({ length: a.length / 3 }, (_, v) =>
      Math.hypot(...[0, 1, 2].map((axis) => a[3 * v + axis]! - b[3 * v + axis]!)),
    );
    return { places: Array.from(window.__shapespline!.project(b)), far: apart };
  });
  const { data, width } = decode(await app.picture());
  // The point in the second view, which has the same camera.
  const offset = width / 2;
  const cells = new Map<string, { far: number; count: number; x: number; y: number }>();
  far.forEach((distance, v) => {
    const [x, y] = [Math.floor(places[2 * v]! / 12), Math.floor(places[2 * v + 1]! / 12)];
    const cell = cells.get(`${x} ${y}`) ?? { far: 0, count: 0, x: 12 * x + 6, y: 12 * y + 6 };
    cells.set(`${x} ${y}`, { ...cell, far: cell.far + distance, count: cell.count + 1 });
  });
  const full = [...cells.values()].filter(({ count }) => count > 12);
  expect(full.length).toBeGreaterThan(30);
  const shares = full.map(({ x, y }) => {
    const at = 4 * (y * width + x + offset);
    return shareOf([data[at]!, data[at + 1]!, data[at + 2]!]);
  });
  const distances = full.map(({ far: sum, count }) => sum / count);
  expect(correlation(distances, shares)).toBeGreaterThan(0.65);
  await app.setTime((await app.state()).doc.keys[1]!.time);
  await app.settled();
  expect(await now(app)).toBeLessThan(0.1);
  await app.expectNoProblems();
});

test('a few slivers do not set the scale of stretch, and the bar shows that some values exceed it', {
  tag: '@all',
}, async ({ app }) => {
  const files = [2, 5, 8].map((pose) => realFile(`turns/cat/cat${pose}.off`));
  test.skip(files.includes(null), 'no real data');
  await app.open();
  await app.by('file-input').setInputFiles(files as string[]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.by('faces').scrollIntoViewIfNeeded();
  await app.by('heat-stretch').check({ force: true });
  const [first, last] = (await app.state()).doc.keys.map(({ time }) => time) as [number, number, number];
  await app.setTime(first + 0.5 * (last - first));
  await app.settled();
  const end = app.by('colour-bar').locator('.ramp-ticks span').first();
  await expect(end).toHaveText(/^≥ \d+ %$/);
  const top = Number(/\d+/.exec((await end.textContent())!)![0]);
  expect(top).toBeLessThan(1000);
  expect(await now(app)).toBeGreaterThan(2 * top);
  // At the reference all amounts are zero.
  await app.setTime(first);
  await app.settled();
  await expect(end).toHaveText(`${top} %`);
  await app.expectNoProblems();
});

test('a face that is clicked shows its coordinates over time, with dots at the keys', async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  await app.by('faces').scrollIntoViewIfNeeded();
  await app.setTime(0.25);
  const [x, y] = await app.page.evaluate(() => {
    const all = window.__shapespline!.positions();
    const places = window.__shapespline!.project(all);
    // find the middle of the visible part
    let [sx, sy] = [0, 0];
    for (let i = 0; i < places.length; i += 2) [sx, sy] = [sx + places[i]!, sy + places[i + 1]!];
    return [(2 * sx) / places.length, (2 * sy) / places.length] as const;
  });
  const box = (await app.by('viewport').boundingBox())!;
  await app.page.mouse.click(box.x + x, box.y + y);
  await expect(app.by('plot-face-rotation')).toBeVisible();
  await expect(app.by('face-patch')).toHaveText(/^of patch \d+$/);
  await expect(app.by('plot-face-rotation').locator('circle.dot')).toHaveCount(9);
  const first = await app.by('face-number').inputValue();
  await app.by('face-number').fill('3');
  await app.by('face-number').press('Enter');
  await expect(app.by('face-number')).not.toHaveValue(first);
  await expect(app.by('plot-face-stretch').locator('path.curve')).toHaveCount(3);
  // With other ends, the natural spline is also drawn.
  await app.by('boundary-hermite').check();
  await app.by('start-speed-number').fill('0');
  await app.by('start-speed-number').press('Enter');
  await app.settled();
  const curves = app.by('plot-face-rotation').locator('path.curve');
  await expect(curves).toHaveCount(6);
  const [natural, own] = await Promise.all([0, 3].map((index) => curves.nth(index).getAttribute('d')));
  expect(natural).not.toBe(own);
  await expect(app.by('plot-face-rotation')).toContainText('natural');
  await app.expectNoProblems();
});

test('the shape keeps playing when another face is selected, and when none is', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&floor=0' });
  await app.by('faces').scrollIntoViewIfNeeded();
  for (const numbers of [['3', '30'], ['']]) {
    await app.setTime(0);
    for (const number of numbers) {
      await app.by('face-number').fill(number);
      await app.by('face-number').press('Enter');
      await app.picture(); // taking the image draws it
    }
    const first = await app.picture();
    await app.setTime(1);
    expect(changedShare(first, await app.picture()), `after “${numbers.at(-1)}”`).toBeGreaterThan(0.05);
  }
  await app.expectNoProblems();
});

test('a clicked patch shows its rotation relative to each neighbour', async ({ app }) => {
  await app.open({ hash: '#sample=twisted-bar' });
  await app.by('faces').scrollIntoViewIfNeeded();
  await app.by('part-patch').check({ force: true });
  await expect(app.by('face-number')).toBeHidden();
  const box = (await app.by('viewport').boundingBox())!;
  const [x, y] = await app.page.evaluate(() => {
    const places = window.__shapespline!.project(window.__shapespline!.positions());
    let [sx, sy] = [0, 0];
    for (let i = 0; i < places.length; i += 2) [sx, sy] = [sx + places[i]!, sy + places[i + 1]!];
    return [(2 * sx) / places.length, (2 * sy) / places.length] as const;
  });
  await app.page.mouse.click(box.x + x, box.y + y);
  await expect(app.by('plot-patch-angles')).toBeVisible();
  await expect(app.by('face-patch')).toHaveText(/^\d+ neighbours$/);
  const neighbours = Number((await app.by('face-patch').innerText()).split(' ')[0]);
  await expect(app.by('plot-patch-angles').locator('path.curve')).toHaveCount(neighbours);
  await expect(app.by('plot-patch-rotation').locator('path.curve')).toHaveCount(3);
  // A key dot on each curve.
  const keys = (await app.state()).doc.keys.length;
  await expect(app.by('plot-patch-rotation').locator('circle.dot')).toHaveCount(3 * keys);
  await expect(app.by('plot-patch-rotation').locator('rect.beyond')).toHaveCount(2);
  // Another neighbour is chosen.
  const choice = app.by('patch-neighbour');
  const other = (await choice.locator('option').allInnerTexts()).at(-1)!;
  await choice.selectOption({ label: other });
  await expect(app.by('plot-patch-rotation')).toContainText(`Rotation relative to ${other}`);
  await app.expectNoProblems();
});

test('a patch that the next shape does not have is dropped without a message; an invalid number is reported', {
  tag: '@all',
}, async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  await app.by('part-patch').check({ force: true });
  await app.by('patch-number').fill('120');
  await app.by('patch-number').press('Enter');
  await expect(app.by('plot-patch-angles')).toBeVisible();
  await app.pick('twisted-bar');
  await app.settled();
  await expect(app.by('patch-number')).toHaveValue('');
  await expect(app.by('plot-patch-angles')).toBeHidden();
  await expect(app.by('error')).toBeHidden();
  await app.by('patch-number').fill('5000');
  await app.by('patch-number').press('Enter');
  await expect(app.by('error')).toContainText('There is no patch 5000');
});

test('amounts can also be chosen in Display, and the panel follows', async ({ app }) => {
  await app.open({ hash: '#sample=twisted-bar&t=1' });
  await app.by('look-toggle').click();
  await app.by('colouring-rotation').check({ force: true });
  await app.settled();
  await expect(app.by('colour-bar')).toContainText('Rotation');
  expect(await now(app)).toBeGreaterThan(60);
  // The amount is zero at the reference.
  await app.setTime((await app.state()).doc.keys[0]!.time);
  await app.settled();
  expect(await now(app)).toBeLessThan(1);
  await app.by('faces').scrollIntoViewIfNeeded();
  await expect(app.by('heat-rotation')).toBeChecked();
  await app.by('heat-stretch').check({ force: true });
  await app.by('look-toggle').click();
  await expect(app.by('colouring-stretch')).toBeChecked();
  await app.by('colouring-texture').check({ force: true });
  await app.settled();
  await expect(app.by('colour-bar')).toBeHidden();
});

test('at 360 px the text of the colour bar overlaps no names of views or buttons', { tag: '@all' }, async ({ app }) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await app.open({ hash: '#figure=7' });
  await expect(app.by('colour-bar-now')).toContainText('at most');
  await expect(app.by('tile-0')).toContainText('250 faces');
  await app.nextFrame();
  const boxes = await app.page.evaluate(() => {
    const words = (selector: string): DOMRect[] => {
      const found = [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility());
      return found.map((one) => {
        const range = document.createRange();
        range.selectNodeContents(one);
        return range.getBoundingClientRect();
      });
    };
    const plain = (list: DOMRect[]) => list.map(({ left, right, top, bottom }) => ({ left, right, top, bottom }));
    return {
      bar: plain(words('.colour-bar strong, .colour-bar .muted, .ramp-ticks span')),
      others: plain(words('.tile-label strong, .view-buttons .button, .phase')),
    };
  });
  expect(boxes.bar.length).toBeGreaterThan(2);
  for (const a of boxes.bar)
    for (const b of boxes.others) {
      const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      expect(Math.min(across, down), JSON.stringify([a, b])).toBeLessThanOrEqual(1);
    }
});

test('at 360 px the text of the colour bar does not overlap the first of three shapes', { tag: '@all' }, async ({
  app,
}) => {
  await app.page.setViewportSize({ width: 360, height: 740 });
  await app.open({ hash: '#sample=hand&compare=linear,cubic-vertex&colour=stretch&t=0.3' });
  await expect(app.by('colour-bar-now')).toContainText('at most');
  await app.by('fit').click();
  await expect
    .poll(() =>
      app.page.evaluate(() => {
        const { left, top } = document.querySelector('[data-testid="viewport"]')!.getBoundingClientRect();
        const words = [...document.querySelectorAll('.colour-bar strong, .colour-bar .muted, .ramp-ticks span')]
          .filter((one) => one.checkVisibility())
          .map((one) => one.getBoundingClientRect());
        const points = window.__shapespline!.project(window.__shapespline!.positions());
        let over = 0;
        for (let i = 0; i < points.length; i += 2) {
          const [x, y] = [points[i]! + left, points[i + 1]! + top];
          if (words.some((box) => x > box.left && x < box.right && y > box.top && y < box.bottom)) over += 1;
        }
        return words.length > 3 ? over : -1;
      }),
    )
    .toBe(0);
});

test('coordinates can be reached and read with the keyboard alone', async ({ app }) => {
  await app.open({ hash: '#sample=cactus' });
  await app.by('face-number').focus();
  await app.page.keyboard.type('3');
  await app.page.keyboard.press('Enter');
  await expect(app.by('plot-face-rotation').locator('path.curve').first()).toBeVisible();
  await expect(app.by('face-patch')).toHaveText(/of patch \d+/); // screen readers also read out the patch
  const summary = app.by('face-rotation-values').locator('summary');
  for (let i = 0; i < 8 && !(await summary.evaluate((one) => one === document.activeElement)); i += 1)
    await app.page.keyboard.press('Tab');
  await expect(summary).toBeFocused();
  await app.page.keyboard.press('Enter');
  const table = app.by('face-rotation-values').getByRole('table', { name: 'Rotation within its patch' });
  await expect(table.getByRole('columnheader')).toHaveText(['Time', 'x', 'y', 'z']);
  await app.page.keyboard.press('Tab');
  await expect(app.by('face-rotation-svg')).toBeFocused();
});

test(
  'distances are relative to an animation of the same mesh after it is dropped on them',
  { tag: '@all' },
  async ({ app }, testInfo) => {
    const mesh = barMesh();
    const last = bent(mesh, 60).slice();
    const rows = (word: string, numbers: ArrayLike<number>, offset = 0): string =>
      Array.from(
        { length: numbers.length / 3 },
        (_, i) => `${word} ${[0, 1, 2].map((axis) => numbers[3 * i + axis]! + offset).join(' ')}\n`,
      ).join('');
    const file = (name: string, content: string | Buffer): string => {
      const at = testInfo.outputPath(name);
      writeFileSync(at, content);
      return at;
    };
    const obj = (pose: Float32Array): string => rows('v', pose) + rows('f', mesh.indices, 1);
    // The animation is straight between the poses, so the linear blend has no error.
    const count = 24;
    const head = Buffer.alloc(32);
    head.write('POINTCACHE2\0', 'latin1');
    [1, last.length / 3].forEach((value, i) => head.writeInt32LE(value, 12 + 4 * i));
    head.writeFloatLE(1, 24);
    head.writeInt32LE(count, 28);
    const frames = Array.from({ length: count }, (_, i) =>
      mesh.positions.map((value, at) => value + (i / (count - 1)) * (last[at]! - value)),
    );
    const cache = Buffer.concat([head, ...frames.map(({ buffer }) => Buffer.from(buffer as ArrayBuffer))]);
    await app.open();
    await app.by('file-input').setInputFiles([file('a.obj', obj(mesh.positions)), file('b.obj', obj(last))]);
    await expect.poll(async () => (await app.state()).doc.keys.map(({ name }) => name)).toEqual(['a', 'b']);
    await app.settled();
    await app.by('method').selectOption('linear');
    await app.by('heat-distance').check({ force: true });
    const drop = async (...files: string[]): Promise<void> => {
      // Releases where the page describes the drop, like a user; content above may grow until then.
      let at = { x: 0, y: 0 };
      await expect(async () => {
        await app.by('truth-pick').scrollIntoViewIfNeeded();
        const { x, y, width, height } = (await app.by('truth-pick').boundingBox())!;
        at = { x: x + width / 2, y: y + height / 2 };
        await app.dragOver(files, at);
        await expect(app.by('drop-zone')).toHaveText(/is compared with the motion$/, { timeout: 500 });
        // Plots above are complete, and panels that load once a frame has been timed have grown.
        await app.settled();
        await app.page.waitForTimeout(500);
        expect(await app.by('truth-pick').boundingBox()).toEqual({ x, y, width, height });
      }).toPass();
      await app.drop(files, at);
    };
    await drop(file('bar.obj', obj(mesh.positions)), file('bar.pc2', cache));
    await expect(app.by('tile-1')).toContainText('The animation');
    const kg = async (): Promise<number> =>
      Number(/KG error ([\d.]+)/.exec(await app.by('distance-kg').innerText())?.[1] ?? NaN);
    await expect.poll(kg).toBeLessThan(0.01);
    await expect(app.by('plot-distance')).toContainText('from “bar”');
    await expect(app.by('colour-bar')).toContainText('from the animation');
    await app.by('method').selectOption('lri');
    await expect.poll(kg).toBeGreaterThan(1);
    const shape = await app.positionsAt(0.5);
    const halfway = Array.from(mesh.positions, (value, at) => (value + last[at]!) / 2);
    expect(difference(await app.positions(1), halfway)).toBeLessThan(1e-3 * diagonal(shape));
    expect((await app.state()).doc.keys).toHaveLength(2);

    // A file without an animation is refused without losing anything.
    await drop(file('alone.obj', obj(last)));
    await expect(app.by('error-message')).toBeVisible();
    await app.by('error-close').click();
    await expect(app.by('tile-1')).toContainText('The animation');
    await app.by('truth-leave').click();
    await expect(app.by('tile-1')).toBeHidden();
    await expect(app.by('truth-leave')).toBeHidden();
    expect((await app.state()).doc.keys).toHaveLength(2);
  },
);
