/** Textures on the shape: with seams, repeated, and too large to be drawn. */
import { Document, WebIO } from '@gltf-transform/core';
import { blank, colourAt, columns, decode } from './png.ts';
import type { Colour } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

type Channel = 'red' | 'green' | 'blue' | 'none';
const RED = [255, 0, 0] as const;
const GREEN = [0, 255, 0] as const;
const BLUE = [0, 0, 255] as const;

/** The strongest colour channel on the screen at points of the shape. */
async function coloursAt(app: App, points: number[]): Promise<Channel[]> {
  const picture = decode(await app.picture());
  const at = await app.page.evaluate((xyz) => Array.from(window.__shapespline!.project(xyz)), points);
  return Array.from({ length: at.length / 2 }, (_, i) =>
    strongest(colourAt(picture, Math.round(at[2 * i]!), Math.round(at[2 * i + 1]!))),
  );
}

function strongest([r, g, b]: Colour): Channel {
  const [most, next] = [
    { name: 'red' as const, level: r },
    { name: 'green' as const, level: g },
    { name: 'blue' as const, level: b },
  ].sort((x, y) => y.level - x.level);
  return most!.level > next!.level + 60 ? most!.name : 'none';
}

async function openTextured(
  app: App,
  files: { name: string; mimeType: string; buffer: Buffer }[],
  keys: number,
): Promise<void> {
  const before = (await app.state()).source;
  await app.by('file-input').setInputFiles(files);
  await expect.poll(async () => (await app.state()).source).not.toEqual(before);
  await app.settled();
  expect((await app.state()).doc.keys).toHaveLength(keys);
  await app.page.keyboard.press('1');
  await app.page.keyboard.press('v');
  // By default a shape is shown with its own materials.
  await expect(app.by('colouring-texture')).toBeChecked();
  await app.by('floor').uncheck();
  await app.page.keyboard.press('v');
  await app.settled();
}

const given = (name: string, content: string | Buffer): { name: string; mimeType: string; buffer: Buffer } => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(content),
});

/** Two adjacent squares in the plane z = 0, or bent. They share an edge, but not its texture coordinates. */
function squares(bend: number): string {
  const places = [
    [-1, -1, 0],
    [0, -1, 0],
    [1, -1, bend],
    [1, 1, bend],
    [0, 1, 0],
    [-1, 1, 0],
  ];
  const coordinates = [
    [0.05, 0],
    [0.2, 0],
    [0.2, 1],
    [0.05, 1],
    [0.8, 0],
    [0.95, 0],
    [0.95, 1],
    [0.8, 1],
  ];
  return [
    'mtllib paint.mtl',
    ...places.map((p) => `v ${p.join(' ')}`),
    ...coordinates.map((c) => `vt ${c.join(' ')}`),
    'usemtl paint',
    'f 1/1 2/2 5/3 6/4',
    'f 2/5 3/6 4/7 5/8',
    '',
  ].join('\n');
}

/** Points along both squares and close to both sides of their common edge. */
const PLACES = [-0.9, -0.5, -0.03, 0.03, 0.5, 0.9].flatMap((x) => [x, 0.1, 0]);
const SIDES: Channel[] = ['red', 'red', 'red', 'blue', 'blue', 'blue'];

test('an OBJ with texture seams is drawn correctly on both sides', async ({ app }) => {
  await app.open();
  const files = [
    given('pose-1.obj', squares(0)),
    given('pose-2.obj', squares(0.4)),
    given('paint.mtl', 'newmtl paint\nmap_Kd paint.png\n'),
    given('paint.png', columns([RED, GREEN, GREEN, BLUE])),
  ];
  await openTextured(app, files, 2);
  await expect(app.by('status-vertices')).toHaveText('6 vertices');
  await app.setTime(0);
  await expect.poll(() => coloursAt(app, PLACES)).toEqual(SIDES);
  await app.expectNoProblems();
});

/** A square whose texture coordinates run from 0 to 2, as two keys. */
async function sampledSquare(sampler: { wrap: 10497 | 33071 | 33648; image: Buffer }): Promise<Buffer> {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (values: number[], type: 'VEC3' | 'VEC2') =>
    document.createAccessor().setArray(Float32Array.from(values)).setType(type).setBuffer(buffer);
  const texture = document.createTexture().setImage(new Uint8Array(sampler.image)).setMimeType('image/png');
  const material = document.createMaterial().setBaseColorTexture(texture).setMetallicFactor(0);
  material.getBaseColorTextureInfo()!.setWrapS(sampler.wrap).setWrapT(sampler.wrap);
  const primitive = document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(
      document
        .createAccessor()
        .setArray(Uint16Array.of(0, 1, 2, 0, 2, 3))
        .setType('SCALAR')
        .setBuffer(buffer),
    )
    .setAttribute('POSITION', accessor([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 'VEC3'))
    .setAttribute('TEXCOORD_0', accessor([0, 0.5, 2, 0.5, 2, 0.5, 0, 0.5], 'VEC2'))
    .addTarget(
      document
        .createPrimitiveTarget()
        .setAttribute('POSITION', accessor([0, 0, 0, 0, 0, 0, 0, 0, 0.5, 0, 0, 0.5], 'VEC3')),
    );
  document.createScene().addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  return Buffer.from(await new WebIO().writeBinary(document));
}

test('a texture is repeated, clamped or mirrored according to its sampler', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const places = [-0.75, -0.25, 0.25, 0.75].flatMap((x) => [x, 0, 0]); // these points have u = 0.25, 0.75, 1.25, 1.75
  const ways: [10497 | 33071 | 33648, Channel[]][] = [
    [10497, ['red', 'blue', 'red', 'blue']],
    [33071, ['red', 'blue', 'blue', 'blue']],
    [33648, ['red', 'blue', 'blue', 'red']],
  ];
  for (const [wrap, colours] of ways) {
    await openTextured(app, [given(`wrap-${wrap}.glb`, await sampledSquare({ wrap, image: columns([RED, BLUE]) }))], 2);
    await app.setTime(0);
    await expect.poll(() => coloursAt(app, places), `wrap mode ${wrap}`).toEqual(colours);
  }
  await app.expectNoProblems();
});

test('vertex colours of a file are shown', async ({ app }) => {
  await app.open();
  const ply = (z: number): string =>
    `ply\nformat ascii 1.0\nelement vertex 6\n${['x', 'y', 'z'].map((c) => `property float ${c}\n`).join('')}` +
    `${['red', 'green', 'blue'].map((c) => `property uchar ${c}\n`).join('')}element face 2\nproperty list uchar int vertex_indices\nend_header\n` +
    `-1 -1 0 255 0 0\n0 -1 0 255 0 0\n0 1 ${z} 255 0 0\n0 -1 0 0 0 255\n1 -1 0 0 0 255\n0 1 ${z} 0 0 255\n3 0 1 2\n3 3 4 5\n`;
  await openTextured(app, [given('a.ply', ply(0)), given('b.ply', ply(0.5))], 2);
  await app.setTime(0);
  await expect
    .poll(() => coloursAt(app, [-0.3, -0.5, 0, -0.05, 0.5, 0, 0.05, 0.5, 0, 0.3, -0.5, 0]))
    .toEqual(['red', 'red', 'blue', 'blue']);
  await app.expectNoProblems();
});

test('a small file with an image of 900 million pixels is drawn without it, with a message', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  const bytes = await sampledSquare({ wrap: 10497, image: blank(30_000) });
  expect(bytes.length).toBeLessThan(1_000_000);
  await openTextured(app, [given('huge.glb', bytes)], 2);
  await app.by('warning-count').click();
  await expect(app.page.getByText('The shape is drawn without some of its textures')).toBeVisible();
  expect(await app.positionsAt(0.5)).toHaveLength(12);
  await app.expectNoProblems();
});
