/** Poses as exporters write them, caches, numbered files, objects and axes: the page's result and messages. */
import { bent, bar } from '../engine/support/shapes.ts';
import { meshGlb } from '../engine/support/glb.ts';
import { rigFile } from '../engine/support/rig.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

const mesh = bar();
const vertices = mesh.positions.length / 3;
const frames = Array.from({ length: 40 }, (_, frame) => bent(mesh, 3 * frame).slice());

type Upload = { name: string; mimeType: string; buffer: Buffer };

const upload = (name: string, content: Uint8Array | string): Upload => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(content as Uint8Array),
});

async function opened(app: App, files: Upload[]): Promise<void> {
  await app.by('file-input').setInputFiles(files);
  await expect
    .poll(async () => (await app.state()).source)
    .toEqual({ kind: 'files', names: files.map(({ name }) => name) });
  await app.settled();
}

const names = async (app: App): Promise<string[]> => (await app.state()).doc.keys.map(({ name }) => name);

const lines = (word: string, numbers: ArrayLike<number>, offset = 0): string =>
  Array.from(
    { length: numbers.length / 3 },
    (_, i) => `${word} ${numbers[3 * i]! + offset} ${numbers[3 * i + 1]! + offset} ${numbers[3 * i + 2]! + offset}\n`,
  ).join('');
const obj = (pose: Float32Array): string => `o Body\n${lines('v', pose)}${lines('f', mesh.indices, 1)}`;

test('equal poses are reported, and for a different mesh the message says what to do', async ({ app }) => {
  await app.open();
  await opened(app, [upload('a.glb', meshGlb(mesh)), upload('b.glb', meshGlb(mesh))]);
  await expect(app.by('import-offer')).toContainText(/Keys 1 and 2 are the same pose.*Apply the modifiers/);
  await expect(app.by('import-offer-accept')).toBeHidden();
  await app.by('import-offer-later').click();
  await expect(app.by('import-offer')).toBeHidden();
  await app.by('file-input').setInputFiles([upload('a.glb', meshGlb(mesh)), upload('c.glb', meshGlb(bar(2, 9)))]);
  await expect(app.by('error-message')).toContainText(/c.glb \(key 2\) has .* vertices, but key 1 has .* In Blender/);
});

test('for files with an animation each, the page offers keys from it', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const { bytes } = await rigFile();
  await opened(app, [upload('a.glb', bytes), upload('b.glb', bytes)]);
  await expect(app.by('import-offer')).toContainText('Each file has its own animation');
  await app.by('import-offer-accept').click();
  await expect.poll(async () => (await names(app)).length).toBe(8);
  await app.settled();
  await expect(app.by('import-offer')).toBeHidden();
  // A time is not a name.
  expect((await names(app))[0]).toBe('');
});

test('objects are excluded and included again with their checkboxes', async ({ app }) => {
  await app.open();
  const floor = `o Floor\nv -9 -9 0\nv 9 -9 0\nv 9 9 0\nf ${vertices + 1} ${vertices + 2} ${vertices + 3}\n`;
  await opened(app, [upload('a.obj', obj(frames[0]!) + floor), upload('b.obj', obj(frames[20]!) + floor)]);
  const count = (more: number): Promise<void> =>
    expect(app.by('mesh-report')).toContainText((vertices + more).toLocaleString('en'));
  await count(3);
  await app.by('objects').getByLabel('Floor').uncheck();
  await count(0);
  await expect(app.by('objects').getByLabel('Body')).toBeDisabled();
  await app.by('objects').getByLabel('Floor').check();
  await count(3);
});

test('a shape that lies on its back is rotated upright', async ({ app }) => {
  await app.open();
  const ply = (height: number): string =>
    'ply\nformat ascii 1.0\ncomment Created in Blender version 4.5.4 LTS\nelement vertex 5\nproperty float x\n' +
    'property float y\nproperty float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n' +
    `-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n0 0 ${height}\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n`;
  await opened(app, [upload('a.ply', ply(2)), upload('b.ply', ply(3))]);
  await expect(app.by('import-offer')).toContainText('Z is used');
  await expect(app.by('up-axis-z')).toBeChecked();
  // Position of the tip.
  expect((await app.positionsAt(0))[13]).toBeCloseTo(2, 5);
  await app.by('import-offer-accept').click();
  await expect(app.by('import-offer')).toBeHidden();
  await expect(app.by('up-axis-y')).toBeChecked();
});
