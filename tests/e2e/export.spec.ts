/** What is taken along: it comes down, and what can come back does. */
import { exported, stated, type } from './exporting.ts';
import { diagonal, difference, expect, test } from './support.ts';
import { unzip } from '../unzip.ts';

function statedBytes(text: string): number {
  const [, value, unit] = /about ([\d.]+) (B|kB|MB)/.exec(text)!;
  return Number(value) * { B: 1, kB: 1e3, MB: 1e6 }[unit as 'B' | 'kB' | 'MB'];
}

function verticesOf(obj: string): number[] {
  return obj
    .split('\n')
    .filter((line) => line.startsWith('v '))
    .flatMap((line) => line.split(' ').slice(1, 4).map(Number));
}

test('the animation is saved as a GLB of the stated size and opens again as the same project', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('start-speed-number').fill('2');
  await app.by('start-speed-number').press('Enter');
  await app.settled();
  const { doc } = await app.state();
  const middle = await app.positionsAt(0.3);
  const { download, bytes, stated } = await exported(app, async () => {
    await app.by('export-targets-every').check();
    await app.by('export-frames').fill('20');
    await app.by('export-frames').press('Enter');
  });
  expect(download.suggestedFilename()).toBe('cactus.glb');
  expect(bytes.subarray(0, 4).toString()).toBe('glTF');
  expect(bytes.readUInt32LE(8)).toBe(bytes.length);
  expect(Math.abs(statedBytes(stated) / bytes.length - 1)).toBeLessThan(0.1);

  await app.by('file-input').setInputFiles({ name: 'project.glb', mimeType: 'model/gltf-binary', buffer: bytes });
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const again = (await app.state()).doc;
  expect(again.keys.map((key) => key.time)).toEqual(doc.keys.map((key) => key.time));
  expect(again.motion).toEqual(doc.motion);
  expect(difference(await app.positionsAt(0.3), middle)).toBeLessThan(1e-3 * diagonal(middle));
  await app.expectNoProblems();
});

test('frames come as OBJ files in a zip', async ({ app }) => {
  await app.open();
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-animation-obj').check();
    await app.by('export-frames').fill('3');
    await app.by('export-frames').press('Enter');
  });
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const frames = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(frames.map(({ name }) => name)).toEqual(['0000.obj', '0001.obj', '0002.obj', 'cactus.mtl', 'README.txt']);
  const vertices = frames.slice(0, 3).map((frame) => verticesOf(Buffer.from(frame.bytes).toString()));
  expect(difference(vertices[0]!, await app.positionsAt(0))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
  expect(difference(vertices[2]!, await app.positionsAt(1))).toBeLessThan(1e-5 * diagonal(vertices[0]!));
});

test('as few morph targets as the tolerance needs are exported, with the error that results', async ({ app }) => {
  await app.open();
  const targetsIn = (stated: string): number => Number(/(\d+) morph targets/.exec(stated)![1]);
  const { bytes, stated } = await exported(app, async () => {});
  expect(stated).toMatch(
    /^8 s there and back, \d+ morph targets, off by at most 0\.0\d+ % of the diagonal between them, about /,
  );
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString());
  expect(json.meshes[0].primitives[0].targets).toHaveLength(targetsIn(stated));
  expect(json.meshes[0].extras.targetNames).toHaveLength(targetsIn(stated));
  expect(json.nodes[0].name).toBe('cactus');
  expect(json.extras.shapespline.mesh.error).toBeLessThan(1e-3);

  const rough = await exported(app, async () => {
    await app.by('export-tolerance').fill('1');
    await app.by('export-tolerance').press('Enter');
  });
  expect(targetsIn(rough.stated)).toBeLessThan(targetsIn(stated));
  const small = await exported(app, () => app.by('export-compression-meshopt').check());
  expect(small.bytes.length).toBeLessThan(0.6 * rough.bytes.length);
  await app.expectNoProblems();
});

test('keys and in-betweens come with a table of weights and drivers for Blender', async ({ app }) => {
  await app.open();
  const { download, bytes } = await exported(app, () => app.by('export-targets-principal').check());
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const files = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(files.map(({ name }) => name)).toEqual(['cactus.glb', 'cactus.csv', 'cactus.py']);
  expect(Buffer.from(files[1]!.bytes).toString()).toMatch(/^slider,.*"in-between 1"/);
});

for (const format of ['pc2', 'mdd'] as const) {
  test(`a point cache comes as ${format.toUpperCase()} beside its OBJ`, async ({ app }) => {
    await app.open();
    const { bytes } = await exported(app, async () => {
      await app.by(`export-animation-${format}`).check();
      await app.by('export-frames').fill('5');
      await app.by('export-frames').press('Enter');
    });
    const files = await unzip(new Blob([new Uint8Array(bytes)]));
    expect(files.map(({ name }) => name)).toEqual(
      expect.arrayContaining([`cactus.${format}`, 'cactus.obj', 'README.txt']),
    );
    const obj = verticesOf(Buffer.from(files.find(({ name }) => name === 'cactus.obj')!.bytes).toString());
    const cache = Buffer.from(files[0]!.bytes);
    const header = format === 'pc2' ? 32 : 8 + 4 * 5;
    expect(cache.length).toBe(header + 5 * 4 * obj.length);
    const first = obj.map((_, i) =>
      format === 'pc2' ? cache.readFloatLE(header + 4 * i) : cache.readFloatBE(header + 4 * i),
    );
    expect(difference(first, obj)).toBeLessThan(1e-6 * diagonal(obj));
  });
}

for (const [format, start] of [
  ['glb', 'glTF'],
  ['ply', 'ply'],
] as const) {
  test(`the current pose is saved as ${format.toUpperCase()}`, async ({ app }) => {
    await app.open();
    await app.setTime(0.3);
    const { download, bytes } = await exported(app, async () => {
      await app.by('export-kind-pose').check();
      await app.by(`export-pose-${format}`).check();
    });
    expect(download.suggestedFilename()).toBe(`cactus.${format}`);
    expect(bytes.toString('latin1').startsWith(start)).toBe(true);
  });
}

test('the current pose is saved as OBJ, with its materials', async ({ app }) => {
  await app.open();
  const positions = await app.positionsAt(0.3);
  const { download, bytes } = await exported(app, async () => {
    await app.by('export-kind-pose').check();
    await app.by('export-pose-obj').check();
  });
  expect(download.suggestedFilename()).toBe('cactus.zip');
  const files = await unzip(new Blob([new Uint8Array(bytes)]));
  expect(files.map(({ name }) => name)).toEqual(expect.arrayContaining(['cactus.obj', 'cactus.mtl']));
  const obj = Buffer.from(files.find(({ name }) => name === 'cactus.obj')!.bytes).toString();
  expect(obj).toMatch(/^mtllib cactus\.mtl$/m);
  expect(difference(verticesOf(obj), positions)).toBeLessThan(1e-5 * diagonal(positions));
});

test('the view is saved as a PNG', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, () => app.by('export-kind-picture').check());
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(bytes.length).toBeGreaterThan(5000);
});

test('numbers are saved as CSV at the frames that are exported, rounded, with version, options and units', async ({
  app,
}) => {
  await app.open();
  const { bytes, stated: text } = await exported(app, async () => {
    await app.by('export-kind-numbers').check();
    await type(app, 'export-rate', '10');
  });
  expect(text).toBe('A table of 41 frames');
  const lines = bytes.toString().trim().split('\n');
  expect(lines[0]).toMatch(/^# shapespline \d+\.\d+\.\d+$/);
  expect(lines[2]).toContain('"boundary":"natural"');
  expect(lines[3]).toMatch(/^# units: time s .* volume m\^3/);
  const header = lines.find((line) => line.startsWith('time,'))!.split(',');
  expect(header.slice(0, 3)).toEqual(['time', 'seconds', 'lri volume']);
  const cells = lines.slice(lines.indexOf(header.join(',')) + 1).map((line) => line.split(','));
  const rows = cells.map((row) => row.map(Number));
  expect(rows).toHaveLength(41);
  for (const row of rows) {
    expect(row.length).toBe(header.length);
    expect(row.every(Number.isFinite)).toBe(true);
  }
  rows.forEach((row, frame) => {
    expect(row[0]).toBeCloseTo(frame / 40, 9);
    expect(row[1]).toBeCloseTo(frame / 10, 9);
  });
  for (const cell of cells.flat()) expect(cell.replace(/e.*|[-.]/g, '').replace(/^0+/, '').length).toBeLessThan(13);
});

test('what is exported takes the time that was watched, and opens again at the same speed', async ({ app }) => {
  await app.open();
  const text = await stated(app, () => app.by('export-targets-every').check());
  // 121 frames at 30 a second fill 4 s, and it bounces; the keys are among them.
  expect(text).toMatch(/^8 s there and back, 121 frames, off by /);
  await expect(app.by('export-frames')).toHaveValue('121');
  await type(app, 'export-frames', '60');
  await app.nextFrame();
  await expect(app.by('export-size')).toHaveText(/^8\ss there and back, 61 frames \(60, and 1 at keys between them\)/);
  await expect(app.by('export-rate')).toHaveValue('14.75');
  await app.by('export-close').click();

  const { bytes } = await exported(app, () => app.by('export-targets-few').check());
  const once = animationOf(bytes);
  expect(once.times[0]).toBe(0);
  expect(once.times.at(-1)).toBeCloseTo(8, 6);
  await app.by('file-input').setInputFiles({ name: 'again.glb', mimeType: 'model/gltf-binary', buffer: bytes });
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  const { doc, play } = await app.state();
  expect(doc.keys.map(({ time }) => time)).toEqual([0, 0.5, 1]);
  expect(play.speed).toBe(0.25);
  await app.expectNoProblems();
});

test('a GLB goes there and back with the same targets, and opens again as the same project', async ({ app }) => {
  await app.open();
  const oneWay = animationOf((await exported(app, () => app.by('export-bounce').uncheck())).bytes);
  const { bytes, stated: text } = await exported(app, () => app.by('export-bounce').check());
  expect(text).toMatch(/^8 s there and back, \d+ morph targets/);
  const both = animationOf(bytes);
  expect(both.targets).toBe(oneWay.targets);
  expect(both.times).toHaveLength(2 * oneWay.times.length - 1);
  expect(both.times.at(-1)).toBeCloseTo(8, 6);
  both.times.forEach((time, index) => {
    expect(time + both.times[both.times.length - 1 - index]!).toBeCloseTo(8, 5);
    if (index > 0) expect(time).toBeGreaterThan(both.times[index - 1]!);
  });
  both.weights.forEach((row, index) => {
    expect(row).toEqual(both.weights[both.weights.length - 1 - index]);
    if (index < oneWay.weights.length) expect(row).toEqual(oneWay.weights[index]);
  });
  await app.by('file-input').setInputFiles({ name: 'again.glb', mimeType: 'model/gltf-binary', buffer: bytes });
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  expect((await app.state()).doc.keys.map(({ time }) => time)).toEqual([0, 0.5, 1]);
  await app.expectNoProblems();
});

/** Times of the one animation of a GLB, and a row of weights for each. */
function animationOf(glb: Buffer): { times: number[]; weights: number[][]; targets: number } {
  const length = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + length).toString());
  const binary = glb.subarray(20 + length + 8);
  const floats = (accessor: number): number[] => {
    const { bufferView, byteOffset = 0, count } = json.accessors[accessor];
    const start = (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return Array.from({ length: count }, (_, i) => binary.readFloatLE(start + 4 * i));
  };
  const [{ input, output }] = json.animations[0].samplers;
  const targets = json.meshes[0].primitives[0].targets.length;
  const times = floats(input);
  const all = floats(output);
  return { times, targets, weights: times.map((_, row) => all.slice(row * targets, (row + 1) * targets)) };
}

test('poses without times get a second each, which the timeline says, and play in it', async ({ app }) => {
  const pose = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`;
  const given = (name: string, x: number) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(pose(x)) });
  await app.open();
  await app.by('file-input').setInputFiles([given('a.obj', 0.5), given('b.obj', 0.4), given('c.obj', 0.1)]);
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(3);
  await app.settled();
  const { doc, play } = await app.state();
  expect(doc.keys.map(({ time }) => time)).toEqual([0, 1, 2]);
  expect(play.speed).toBe(1);
  await expect(app.page.locator('.ruler .mark', { hasText: /^2(\.0)? s$/ })).toBeVisible();
  await expect(app.by('time-unit')).toHaveText('s');
  await expect(app.by('timeline')).toHaveAttribute('aria-valuetext', /^0\.000 s, At key 1/);
  const text = await stated(app, () => app.by('export-animation-video').check());
  expect(text).toMatch(/^120 frames, 4 s, /);
  await expect(app.by('export-duration')).toHaveValue('2');
  await expect(app.by('export-pace')).toHaveText('as it plays here');
});

test('the patch of every face is saved as CSV', async ({ app }) => {
  await app.open();
  const { bytes } = await exported(app, async () => {
    await app.by('export-kind-numbers').check();
    await app.by('export-numbers-patches').check();
  });
  const rows = bytes
    .toString()
    .trim()
    .split('\n')
    .filter((line) => /^\d/.test(line));
  const faces = Number((await app.by('status-faces').innerText()).replace(/\D/g, ''));
  expect(rows.length).toBe(faces);
  expect(new Set(rows.map((row) => row.split(',')[1])).size).toBe((await app.stats()).patches);
});

test('a link brings the whole view back', async ({ app, page }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.by('method').selectOption('cubic-vertex');
  await app.by('view-right').click();
  await app.setTime(0.37);
  await app.settled();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('t=0.37');
  const [state, positions] = [await app.state(), await app.positions()];
  const { hash } = new URL(page.url());
  await page.goto('about:blank');
  await app.open({ hash });
  const again = await app.state();
  expect(again.doc).toEqual(state.doc);
  expect(again.time).toBe(0.37);
  expect(await app.positions()).toEqual(positions);
  again.view.camera!.position.forEach((value, axis) =>
    expect(value).toBeCloseTo(state.view.camera!.position[axis]!, 3),
  );
});
