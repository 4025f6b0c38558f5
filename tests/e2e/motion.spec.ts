/** Each option changes the numbers and the screen; options that only refit neither encode nor factor. */
import { writeFileSync } from 'node:fs';
import type { TestInfo } from '@playwright/test';
import { changedShare } from './png.ts';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

/** Distance relative to the diagonal. */
const apart = (a: number[], b: number[]): number => difference(a, b) / diagonal(a);

test('the boundary changes the motion between the keys and its image, but not the keys', async ({ app }) => {
  await app.open();
  const key = await app.positionsAt(0.5);
  const natural = await app.positionsAt(0.2);
  const picture = await app.picture();
  await app.by('boundary-periodic').check();
  await app.settled();
  await expect(app.by('timeline')).toHaveAttribute('data-periodic', '');
  expect(apart(natural, await app.positionsAt(0.2))).toBeGreaterThan(1e-3);
  await app.by('boundary-hermite').check();
  await app.settled();
  // Easing ends come to rest, until another speed is chosen.
  expect((await app.state()).doc.motion).toMatchObject({ boundary: 'hermite', startSpeed: 0, endSpeed: 0 });
  const hermite = await app.positionsAt(0.2);
  expect(apart(natural, hermite)).toBeGreaterThan(1e-3);
  expect(changedShare(picture, await app.picture())).toBeGreaterThan(2e-4);
  expect(apart(key, await app.positionsAt(0.5))).toBeLessThan(1e-5);
  // A key can be the tangent pose.
  await app.by('start-tangent').selectOption({ index: 3 });
  await app.settled();
  expect(apart(hermite, await app.positionsAt(0.2))).toBeGreaterThan(1e-3);
  await app.by('boundary-natural').check();
  await app.settled();
  expect(await app.positionsAt(0.2)).toEqual(natural);
  await app.expectNoProblems();
});

test('a fitted method runs next to others, and offers only supported options', async ({ app }) => {
  await app.open({ hash: '#sample=twisted-bar&boundary=hermite' });
  const key = await app.positionsAt(0);
  const modules = async (): Promise<string[]> =>
    app.page.evaluate(() =>
      performance.getEntriesByType('resource').flatMap(({ name }) => /shapespline_shells[^/]*wasm$/.exec(name) ?? []),
    );
  expect(await modules()).toEqual([]);
  await app.by('method').selectOption('lengths');
  await app.settled();
  expect(await modules()).toHaveLength(1);
  expect((await app.state()).doc.motion).toMatchObject({ method: 'lengths', boundary: 'natural' });
  expect(apart(key, await app.positionsAt(0))).toBeLessThan(1e-5);
  const fitted = await app.positionsAt(0.3);
  await expect(app.by('boundary-hermite')).toBeDisabled();
  await expect(app.by('boundary-periodic')).toBeDisabled();
  for (const control of ['hold', 'tightness']) await expect(app.by(control)).toBeHidden();
  await app.by('compare-lri').check();
  await app.settled();
  expect(await app.positionsAt(0.3)).toEqual(fitted);
  const plain = await app.positions(1);
  expect(apart(fitted, plain)).toBeGreaterThan(1e-5);
  expect(apart(fitted, plain)).toBeLessThan(0.05);
  expect(app.page.url()).toContain('method=lengths');
  await app.expectNoProblems();
});

/** A strip with a given length, or bent by an angle in radians. */
function strip(bend: number, long: number): string {
  const rings = Array.from({ length: 9 }, (_, i) => {
    const [x, z] = [Math.sin((bend * i) / 8) * 4, Math.cos((bend * i) / 8) * 4];
    return [-0.3, 0.3].map((y) => `v ${bend === 0 ? (i * long) / 8 : x} ${y} ${bend === 0 ? 0 : 4 - z}`);
  });
  const quads = Array.from({ length: 8 }, (_, i) => `f ${2 * i + 1} ${2 * i + 3} ${2 * i + 4} ${2 * i + 2}`);
  return [...rings.flat(), ...quads, ''].join('\n');
}

type MakeFile = (name: string, bend: number, long?: number) => string;

const filesIn =
  (info: TestInfo): MakeFile =>
  (name, bend, long = 4) => {
    const path = info.outputPath(name);
    writeFileSync(path, strip(bend, long));
    return path;
  };

/** Opens two key files with Hermite ends. */
async function openTwo(app: App, file: MakeFile): Promise<void> {
  await app.open();
  await app.by('file-input').setInputFiles([file('a.obj', 0), file('b.obj', 0.6)]);
  await expect.poll(async () => (await app.state()).doc.keys.map(({ name }) => name)).toEqual(['a', 'b']);
  await app.settled();
  await app.by('boundary-hermite').check();
  await app.settled();
}

test(
  'a shape from a file becomes the end tangent pose: chosen, dropped, undone, and stored in the project',
  { tag: '@all' },
  async ({ app }, testInfo) => {
    const file = filesIn(testInfo);
    await openTwo(app, file);
    const before = await app.positionsAt(0.3);
    const chosen = app.page.waitForEvent('filechooser');
    await app.by('start-tangent').selectOption({ label: 'a shape from a file…' });
    await (await chosen).setFiles(file('far.obj', 1.4));
    await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');
    await app.settled();
    const towards = await app.positionsAt(0.3);
    expect(difference(towards, before)).toBeGreaterThan(0.005 * diagonal(before));
    expect((await app.state()).doc.keys).toHaveLength(2);
    // The tangent pose is shown in the shape plane, which two keys alone do not span.
    await app.by('plot-plane').scrollIntoViewIfNeeded();
    await expect(app.by('plane-start-tangent')).toBeAttached();
    await expect(app.by('plane-end-tangent')).toHaveCount(0);

    await app.by('end-tangent').scrollIntoViewIfNeeded();
    const at = (await app.by('end-tangent').boundingBox())!;
    await app.drop([file('back.obj', -0.9)], { x: at.x + at.width / 2, y: at.y + at.height / 2 });
    await expect(app.by('end-tangent').locator('option:checked')).toHaveText('back');
    await app.settled();
    expect(difference(await app.positionsAt(0.8), towards)).toBeGreaterThan(0);
    expect((await app.state()).doc.keys).toHaveLength(2);
    await app.by('undo').click();
    await expect(app.by('end-tangent')).toHaveValue('');
    await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');
    await app.settled();
    expect(difference(await app.positionsAt(0.3), towards)).toBeLessThan(1e-6);

    // Several poses, or a different mesh, are refused as a tangent without losing anything.
    await app.by('tangent-file-input').setInputFiles([file('c.obj', 0.2), file('d.obj', 0.4)]);
    await expect(app.by('error-message')).toContainText('These files have 2 poses, but a tangent is one shape.');
    await app.by('error-close').click();
    await app.reload();
    await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');
    expect(difference(await app.positionsAt(0.3), towards)).toBeLessThan(1e-6);
  },
);

test(
  'for a close tangent pose, larger speeds are offered everywhere, and any speed can be typed',
  {
    tag: '@all',
  },
  async ({ app }, testInfo) => {
    const file = filesIn(testInfo);
    await openTwo(app, file);
    await app.by('plot-plane').scrollIntoViewIfNeeded();
    const most = app.by('start-speed-handle');
    await expect(most).toHaveAttribute('aria-valuemax', '4');
    await app.by('start-tangent').scrollIntoViewIfNeeded();
    const chosen = app.page.waitForEvent('filechooser');
    await app.by('start-tangent').selectOption({ label: 'a shape from a file…' });
    await (await chosen).setFiles(file('near.obj', 0, 4.3));
    await expect(app.by('start-tangent').locator('option:checked')).toHaveText('near');
    await expect(most).not.toHaveAttribute('aria-valuemax', '4');
    const fastest = Number(await most.getAttribute('aria-valuemax'));
    expect(fastest).toBeGreaterThan(4);
    await expect(most).toHaveAttribute('aria-valuetext', /from the first key to the start tangent pose$/);
    await expect(app.by('start-speed')).toHaveAttribute('max', String(fastest));
    await app.by('plot-plane').scrollIntoViewIfNeeded();
    await expect(app.by('plane-start-speed')).toHaveAttribute('aria-valuemax', String(fastest));
    await app.by('plane-start-speed').press('End');
    expect((await app.state()).doc.motion.startSpeed).toBe(fastest);
    await expect(app.by('start-speed-number')).toHaveValue(String(fastest));
    await app.by('start-speed-number').fill('33');
    await app.by('start-speed-number').press('Enter');
    expect((await app.state()).doc.motion.startSpeed).toBe(33);
  },
);

test('stretch, reference and patches change the encoding, and the old shape stays until the new one is ready', async ({
  app,
}) => {
  await app.open();
  const patches = await app.stats();
  const before = await app.positionsAt(1.4);
  await app.by('stretch-log').check();
  await app.settled();
  expect(apart(before, await app.positionsAt(1.4))).toBeGreaterThan(1e-4);
  await app.by('patches').fill('12');
  await app.by('patches').press('Enter');
  await app.settled();
  const fewer = await app.stats();
  expect(fewer.patches).not.toBe(patches.patches);
  await app.by('patches').fill('');
  await app.by('patches').press('Enter');
  await app.settled();
  expect((await app.state()).doc.encoding.patches, 'nothing: as many as are good').toBe(0);
  await expect(app.by('patches')).toHaveAttribute('placeholder', `Auto (${patches.patches})`);
  await app.by('reference').selectOption({ index: 1 });
  await app.settled();
  expect((await app.state()).doc.encoding.referencePose).toBe(1);
  await app.by('shape-reset').click();
  await app.settled();
  expect(await app.positionsAt(1.4)).toEqual(before);
  await app.expectNoProblems();
});

test('tension and bias of a key change the motion near it, but not the key', async ({ app }) => {
  await app.open();
  const [near, key] = [await app.positionsAt(0.45), await app.positionsAt(0.5)];
  for (const [name, value] of [
    ['tension', '1'],
    ['bias', '-1'],
  ] as const) {
    await app.by('key-1-edit').click();
    await expect(app.by('key-bend')).toBeHidden();
    await app.by(`key-${name}`).fill(value);
    await expect(app.by('key-bend')).toContainText('acceleration jumps');
    await app.by('key-editor-close').click();
    await app.settled();
    expect((await app.state()).doc.keys.map(({ shaping }) => shaping[name])).toEqual([0, Number(value), 0]);
    expect(apart(near, await app.positionsAt(0.45)), name).toBeGreaterThan(1e-4);
    expect(apart(key, await app.positionsAt(0.5)), name).toBeLessThan(1e-5);
    await app.page.keyboard.press('Control+z');
    await app.settled();
    expect(await app.positionsAt(0.45)).toEqual(near);
  }
});

// No cheaper test shows that the buttons of the key editor set the timing of the interval after the key.
test('buttons set the timing between two keys, as one undo step', async ({ app }) => {
  await app.open();
  const times = [0.25, 0.5, 0.75];
  const shown = async (): Promise<number[][]> => {
    const shapes: number[][] = [];
    for (const t of times) shapes.push(await app.positionsAt(t));
    return shapes;
  };
  const plain = await shown();
  await app.by('key-0-edit').click();
  await app.by('key-timing-summary').click();
  await app.by('key-timing-straight').click();
  await expect(app.by('key-swing')).toHaveValue('-1');
  await expect(app.by('key-timing-summary')).toContainText('straight');
  await app.by('key-editor-close').click();
  await app.settled();
  const timed = await shown();
  expect(apart(plain[0]!, timed[0]!)).toBeGreaterThan(1e-4);
  expect(apart(plain[1]!, timed[1]!)).toBeLessThan(1e-5);
  await app.page.keyboard.press('Control+z');
  await app.settled();
  expect(await app.positionsAt(0.25)).toEqual(plain[0]);
  await app.by('key-2-edit').click();
  await expect(app.by('key-timing')).toBeHidden();
  await app.expectNoProblems();
});
