/** Each option shows in the numbers and on the screen; those that refit only neither encode nor factorise. */
import { writeFileSync } from 'node:fs';
import { changedShare } from './png.ts';
import { diagonal, difference, expect, test } from './support.ts';
import type { App } from './support.ts';

interface Shown {
  positions: number[];
  picture: Buffer;
}

async function shownAt(app: App, t: number): Promise<Shown> {
  await app.setTime(t);
  return { positions: await app.positions(), picture: await app.picture() };
}

async function expectChange(before: Shown, after: Shown): Promise<void> {
  expect(difference(before.positions, after.positions)).toBeGreaterThan(1e-3 * diagonal(before.positions));
  expect(changedShare(before.picture, after.picture)).toBeGreaterThan(2e-4);
}

test('the boundary changes the motion between the keys, not the keys', async ({ app }) => {
  await app.open();
  const keys = (await app.state()).doc.keys;
  const exact: number[][] = [];
  for (const key of keys) exact.push(await app.positionsAt(key.time));
  const size = diagonal(exact[0]!);
  const counters = await app.stats();
  const natural = await shownAt(app, 0.2);
  for (const boundary of ['hermite', 'periodic']) {
    await app.by(`boundary-${boundary}`).check();
    await app.settled();
    expect((await app.state()).doc.motion.boundary).toBe(boundary);
    if (boundary === 'periodic') await expect(app.by('timeline')).toHaveAttribute('data-periodic', '');
    await expectChange(natural, await shownAt(app, 0.2));
    for (const [index, key] of keys.entries())
      expect(difference(await app.positionsAt(key.time), exact[index]!)).toBeLessThan(1e-5 * size);
  }
  await app.by('boundary-natural').check();
  await app.settled();
  expect((await shownAt(app, 0.2)).positions).toEqual(natural.positions);
  const after = await app.stats();
  // What was made anew would have taken another time.
  expect([after.encodeMs, after.factorMs]).toEqual([counters.encodeMs, counters.factorMs]);
  expect(after.solves).toBeGreaterThan(counters.solves);
  await app.expectNoProblems();
});

test('a shape can be taken as end tangent', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.settled();
  const before = await shownAt(app, 0.2);
  await app.by('start-tangent').selectOption({ index: 3 });
  await app.settled();
  await expectChange(before, await shownAt(app, 0.2));
});

test('a shape from a file is taken as end tangent: chosen, dropped, undone, and kept in the project', async ({
  app,
}, testInfo) => {
  const bar = (bend: number, long: number): string => {
    const rings = Array.from({ length: 9 }, (_, i) => {
      const [x, z] = [Math.sin((bend * i) / 8) * 4, Math.cos((bend * i) / 8) * 4];
      return [-0.3, 0.3].map((y) => `v ${bend === 0 ? (i * long) / 8 : x} ${y} ${bend === 0 ? 0 : 4 - z}`);
    });
    const quads = Array.from({ length: 8 }, (_, i) => `f ${2 * i + 1} ${2 * i + 3} ${2 * i + 4} ${2 * i + 2}`);
    return [...rings.flat(), ...quads, ''].join('\n');
  };
  const file = (name: string, bend: number, long = 4): string => {
    const path = testInfo.outputPath(name);
    writeFileSync(path, bar(bend, long));
    return path;
  };
  await app.open();
  await app.by('file-input').setInputFiles([file('a.obj', 0), file('b.obj', 0.6)]);
  await expect.poll(async () => (await app.state()).doc.keys.map(({ name }) => name)).toEqual(['a', 'b']);
  await app.settled();
  await app.by('boundary-hermite').check();
  await app.settled();
  const before = await app.positionsAt(0.3);
  const chosen = app.page.waitForEvent('filechooser');
  await app.by('start-tangent').selectOption({ label: 'a shape from a file…' });
  await (await chosen).setFiles(file('far.obj', 1.4));
  await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');
  await app.settled();
  const towards = await app.positionsAt(0.3);
  expect(difference(towards, before)).toBeGreaterThan(0.005 * diagonal(before));
  expect((await app.state()).doc.keys).toHaveLength(2);
  // It lies in the shape plane, which two keys alone do not span.
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

  // A shape that lies close is offered greater speeds everywhere, and any speed can be typed.
  await expect(app.by('start-speed-handle')).toHaveAttribute('aria-valuemax', '4');
  await app.by('tangent-file-input').setInputFiles(file('near.obj', 0, 4.3));
  await expect(app.by('start-tangent').locator('option:checked')).toHaveText('near');
  const most = app.by('start-speed-handle');
  await expect(most).not.toHaveAttribute('aria-valuemax', '4');
  const fastest = Number(await most.getAttribute('aria-valuemax'));
  expect(fastest).toBeGreaterThan(4);
  await expect(most).toHaveAttribute('aria-valuetext', /from the first key to the shape of its tangent$/);
  await expect(app.by('start-speed')).toHaveAttribute('max', String(fastest));
  await expect(app.by('plane-start-speed')).toHaveAttribute('aria-valuemax', String(fastest));
  await app.by('plane-start-speed').press('End');
  expect((await app.state()).doc.motion.startSpeed).toBe(fastest);
  await expect(app.by('start-speed-number')).toHaveValue(String(fastest));
  await app.by('start-speed-number').fill('33');
  await app.by('start-speed-number').press('Enter');
  expect((await app.state()).doc.motion.startSpeed).toBe(33);
  await most.press('Delete');
  await app.by('tangent-file-input').setInputFiles(file('far.obj', 1.4));
  await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');

  // Several poses are no tangent, and another mesh is none either; nothing is lost.
  await app.by('tangent-file-input').setInputFiles([file('c.obj', 0.2), file('d.obj', 0.4)]);
  await expect(app.by('error-message')).toContainText('These files hold 2 poses, but a tangent is one shape.');
  await app.by('error-close').click();
  await app.reload();
  await expect(app.by('start-tangent').locator('option:checked')).toHaveText('far');
  expect(difference(await app.positionsAt(0.3), towards)).toBeLessThan(1e-6);
});

test('each method moves otherwise between the keys and refits only', async ({ app }) => {
  await app.open();
  const counters = await app.stats();
  const seen: Shown[] = [await shownAt(app, 0.3)];
  for (const method of ['geodesic', 'linear', 'cubic-vertex']) {
    await app.by('method').selectOption(method);
    await app.settled();
    const shown = await shownAt(app, 0.3);
    for (const other of seen) await expectChange(other, shown);
    seen.push(shown);
  }
  const after = await app.stats();
  // What was made anew would have taken another time.
  expect([after.encodeMs, after.factorMs]).toEqual([counters.encodeMs, counters.factorMs]);
});

test('Hermite is disabled with a reason where the motion is straight between the keys', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  for (const method of ['geodesic', 'linear']) {
    await app.by('method').selectOption(method);
    await app.settled();
    await expect(app.by('boundary-hermite')).toBeDisabled();
    await expect(app.by('boundary-periodic')).toBeEnabled();
    await expect(app.by('boundary-reason')).toHaveText(/straight from key to key/);
    expect((await app.state()).doc.motion.boundary).toBe('natural');
  }
  await app.by('method').selectOption('lri');
  await expect(app.by('boundary-hermite')).toBeEnabled();
  await expect(app.by('boundary-reason')).toBeHidden();
});

test('stretch, reference and patches change the encoding, and the old shape stays until the new one is there', async ({
  app,
}) => {
  await app.open();
  const patches = await app.stats();
  const before = await shownAt(app, 1.4);
  await app.by('stretch-log').check();
  await app.settled();
  const logarithmic = await shownAt(app, 1.4);
  expect(difference(before.positions, logarithmic.positions)).toBeGreaterThan(1e-4 * diagonal(before.positions));
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
  expect((await shownAt(app, 1.4)).positions).toEqual(before.positions);
  await app.expectNoProblems();
});

test('whole turns are added on the way to a key', async ({ app }) => {
  await app.open();
  const [between, key] = [await app.positionsAt(0.25), await app.positionsAt(0.5)];
  await app.by('key-0-edit').click();
  await expect(app.by('key-turns')).toBeHidden();
  await app.by('key-editor-close').click();
  await app.by('key-1-edit').click();
  await app.by('key-turns').fill('1');
  await app.by('key-turns').press('Enter');
  await app.by('key-editor-close').click();
  await app.settled();
  const turned = await app.positionsAt(0.25);
  expect(difference(turned, between)).toBeGreaterThan(0.1 * diagonal(between));
  expect(difference(await app.positionsAt(0.5), key)).toBeLessThan(1e-5 * diagonal(key));
  expect((await app.state()).doc.keys.map(({ shaping }) => shaping.turns)).toEqual([[], [{ turns: 1 }], []]);
});

for (const [name, value] of [
  ['tension', '1'],
  ['bias', '-1'],
] as const) {
  test(`the ${name} of a key changes the motion about it and not the key`, async ({ app }) => {
    await app.open();
    const [near, key] = [await app.positionsAt(0.45), await app.positionsAt(0.5)];
    await app.by('key-1-edit').click();
    await expect(app.by('key-bend')).toBeHidden();
    await app.by(`key-${name}`).fill(value);
    await expect(app.by('key-bend')).toContainText('acceleration jumps');
    await app.by('key-editor-close').click();
    await app.settled();
    expect((await app.state()).doc.keys.map(({ shaping }) => shaping[name])).toEqual([0, Number(value), 0]);
    expect(difference(await app.positionsAt(0.45), near)).toBeGreaterThan(1e-4 * diagonal(near));
    expect(difference(await app.positionsAt(0.5), key)).toBeLessThan(1e-5 * diagonal(key));
    await app.page.keyboard.press('Control+z');
    await app.settled();
    expect(await app.positionsAt(0.45)).toEqual(near);
  });
}
