/** Files of the user: real (if available), broken, dropped and picked. */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { columns } from './png.ts';
import { bytesOf, difference, expect, realFile, test } from './support.ts';

const cactus = ['cactus/cactus-3.glb', 'cactus/cactus-1.glb', 'cactus/cactus-2.glb'].map(realFile);

test('three files become three keys in natural order of their names, and can be scrubbed past both ends', async ({
  app,
}) => {
  test.skip(cactus.includes(null), 'the real inputs are not there');
  await app.open();
  await app.by('file-input').setInputFiles(cactus as string[]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const { doc } = await app.state();
  expect(doc.keys.map((key) => key.name)).toEqual(['cactus-1', 'cactus-2', 'cactus-3']);
  await expect(app.by('status-vertices')).toHaveText('5,261 vertices');
  await expect(app.by('status-faces')).toHaveText('10,518 faces');
  const shapes = [];
  for (const t of [-0.3, 0.25, 1.3]) shapes.push(await app.positionsAt(t));
  for (const shape of shapes) expect(shape.every(Number.isFinite)).toBe(true);
  for (let i = 1; i < shapes.length; i += 1) expect(difference(shapes[i]!, shapes[i - 1]!)).toBeGreaterThan(1e-3);
  await app.expectNoProblems();
});

test('an HTML page named like a model is refused with a message and leaves the shape', async ({ app }) => {
  await app.open();
  await app.setTime(0.3);
  const before = { state: await app.state(), positions: await app.positions() };
  const page = Buffer.from('<!doctype html><title>Not found</title>');
  await app.by('file-input').setInputFiles({ name: 'model.glb', mimeType: 'model/gltf-binary', buffer: page });
  await expect(app.by('error')).toBeVisible();
  const sentence = await app.by('error-message').innerText();
  expect(sentence).toContain('model.glb');
  expect(sentence).toMatch(/[.!?]$/);
  await app.settled();
  expect((await app.state()).doc).toEqual(before.state.doc);
  expect(await app.positions()).toEqual(before.positions);
  expect(difference(await app.positionsAt(0.6), before.positions)).toBeGreaterThan(0);
  await app.by('error-close').click();
  await expect(app.by('error')).toBeHidden();
  await app.expectNoProblems();
});

test('files can be dropped anywhere on the page, which reacts while they are dragged over it', async ({ app }) => {
  test.skip(cactus.includes(null), 'the real inputs are not there');
  await app.open();
  const files = cactus.map((file, index) => ({ name: `pose-${index}.glb`, text: bytesOf(file!).toString('base64') }));
  const transfer = await app.page.evaluateHandle((list) => {
    const data = new DataTransfer();
    for (const { name, text } of list)
      data.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
    return data;
  }, files);
  await app.page.dispatchEvent('body', 'dragenter', { dataTransfer: transfer });
  await expect(app.by('drop-zone')).toBeVisible();
  await app.page.dispatchEvent('body', 'drop', { dataTransfer: transfer });
  await expect(app.by('drop-zone')).toBeHidden();
  await expect
    .poll(async () => (await app.state()).doc.keys.map((key) => key.name))
    .toEqual(['pose-0', 'pose-1', 'pose-2']);
  await app.settled();
  await expect(app.by('status-vertices')).toHaveText('5,261 vertices');
});

test('poses in a dropped folder and its subfolders are opened with their textures', async ({ app }, testInfo) => {
  const folder = testInfo.outputPath('many poses');
  mkdirSync(path.join(folder, 'materials', 'images'), { recursive: true });
  const pose = (bend: number): string =>
    `mtllib materials/paint.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 ${bend}\nv 0 1 ${bend}\nvt 0 0\nusemtl paint\nf 1/1 2/1 3/1 4/1\n`;
  // A browser returns fewer entries per call. Names without numbers are no frames of an animation.
  const names = Array.from({ length: 120 }, (_, i) => `pose-${String.fromCharCode(97 + i / 26, 97 + (i % 26))}`);
  names.forEach((name, i) => writeFileSync(path.join(folder, `${name}.obj`), pose((i + 1) / names.length)));
  writeFileSync(path.join(folder, 'materials', 'paint.mtl'), 'newmtl paint\nmap_Kd images/red.png\n');
  writeFileSync(path.join(folder, 'materials', 'images', 'red.png'), columns([[255, 0, 0]]));
  for (const rubbish of ['.DS_Store', 'notes.docx', 'scene.blend'])
    writeFileSync(path.join(folder, rubbish), 'not a model');
  await app.open();
  await app.drop([folder]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const { doc, source } = await app.state();
  expect(doc.keys.map((key) => key.name)).toEqual(names);
  expect(source.kind === 'files' && source.names).toContain('many poses/materials/images/red.png');
  await expect(app.by('warning-count')).toBeHidden();
  await expect(app.by('colouring-texture')).toBeEnabled();
  await app.expectNoProblems();
});

test('ten files opened twice become ten keys once, and no progress remains', { tag: '@all' }, async ({ app }) => {
  test.skip(cactus.includes(null), 'the real inputs are not there');
  await app.open();
  const poses = Array.from({ length: 10 }, (_, index) => ({
    name: `pose-${index + 1}.glb`,
    mimeType: 'model/gltf-binary',
    buffer: bytesOf(cactus[index % 3]!),
  }));
  await app.by('file-input').setInputFiles(poses);
  await app.by('file-input').setInputFiles(poses);
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(10);
  await app.settled();
  expect((await app.state()).doc.keys.map((key) => key.name)).toEqual(
    poses.map(({ name }) => name.replace('.glb', '')),
  );
  await expect(app.by('progress')).toBeHidden();
  await expect(app.by('error')).toBeHidden();
  await app.expectNoProblems();
});

test('an added key with polygons is split like the open mesh, and has the chosen up axis and unit', async ({ app }) => {
  const pose = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`;
  const given = (name: string, x: number) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(pose(x)) });
  await app.open();
  await expect(app.by('orientation')).toBeHidden();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.4)]);
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(2);
  await app.settled();
  await app.setTime(0.5);
  await app.by('stand-up').click();
  await expect(app.by('up-axis-z')).toBeChecked();
  await app.settled();
  expect((await app.state()).time).toBe(0.5);
  await app.by('file-unit').selectOption('centimetres');
  await expect.poll(async () => (await app.positionsAt(0))[7]).toBeCloseTo(0.01, 6);
  await app.by('key-file-input').setInputFiles(given('c.obj', -0.5));
  await expect.poll(async () => (await app.state()).doc.keys.map(({ name }) => name)).toEqual(['a', 'b', 'c']);
  await app.settled();
  expect(difference(await app.positionsAt(2), [0, 0, 0, 0.01, 0, 0, 0.005, 0.01, 0, -0.005, 0.01, 0])).toBeLessThan(
    1e-6,
  );
  await expect(app.by('up-axis-z')).toBeChecked();
  await app.expectNoProblems();
});
