/** Downloads of exported files and their names; tests/engine/export checks the contents. */
import { exported, stated, type } from './exporting.ts';
import { expect, test } from './support.ts';
import { unzip } from '../unzip.ts';

const namesIn = async (zip: Buffer): Promise<string[]> =>
  (await unzip(new Blob([new Uint8Array(zip)]))).map(({ name }) => name);

test('an animation is saved as OBJ, PC2 and MDD in a zip, or as keys and in-betweens for Blender', {
  tag: '@all',
}, async ({ app }) => {
  await app.open();
  const zipped = async (choose: () => Promise<void>): Promise<string[]> => {
    const { download, bytes } = await exported(app, choose);
    expect(download.suggestedFilename()).toBe('cactus.zip');
    return (await namesIn(bytes)).sort();
  };
  expect(
    await zipped(async () => {
      await app.by('export-animation-obj').check();
      await type(app, 'export-frames', '3');
    }),
  ).toEqual(['0000.obj', '0001.obj', '0002.obj', 'README.txt', 'cactus.mtl']);
  for (const format of ['pc2', 'mdd'])
    expect(await zipped(() => app.by(`export-animation-${format}`).check())).toEqual(
      ['README.txt', `cactus.${format}`, 'cactus.mtl', 'cactus.obj'].sort(),
    );
  const keys = await zipped(async () => {
    await app.by('export-animation-glb').check();
    await app.by('export-targets-principal').check();
  });
  expect(keys).toEqual(['cactus.csv', 'cactus.glb', 'cactus.py']);
});

test('the fewest morph targets for the tolerance are exported, and the dialog shows their number and the name', async ({
  app,
}) => {
  await app.open();
  const targetsIn = (text: string): number => Number(/(\d+) morph targets/.exec(text)![1]);
  const { download, bytes, stated: said } = await exported(app, () => app.by('export-bounce').check());
  expect(said).toMatch(
    /^8 s forwards and backwards, \d+ morph targets, playback error at most 0\.0\d+ % of the model's size, about /,
  );
  expect(download.suggestedFilename()).toBe('cactus.glb');
  const json = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
  expect(json.meshes[0].primitives[0].targets).toHaveLength(targetsIn(said));
  const rough = await stated(app, () => type(app, 'export-tolerance', '1'));
  expect(targetsIn(rough)).toBeLessThan(targetsIn(said));
  // The name of the file, or the default one.
  for (const [typed, name] of [
    ['a/b: c', 'ab- c'],
    ['  ', 'cactus'],
  ] as const) {
    await type(app, 'export-name', typed);
    await expect(app.by('export-name')).toHaveValue(name);
  }
  await app.expectNoProblems();
});

test('the current pose is saved as PLY, and as OBJ with its materials', async ({ app }) => {
  await app.open();
  await app.setTime(0.3);
  const ply = await exported(app, async () => {
    await app.by('export-kind-pose').check();
    await app.by('export-pose-ply').check();
  });
  expect(ply.download.suggestedFilename()).toBe('cactus.ply');
  expect(ply.bytes.toString('latin1').startsWith('ply')).toBe(true);
  const obj = await exported(app, () => app.by('export-pose-obj').check());
  expect(obj.download.suggestedFilename()).toBe('cactus.zip');
  expect(await namesIn(obj.bytes)).toEqual(expect.arrayContaining(['cactus.obj', 'cactus.mtl']));
});

test('measurements at the exported frames and of every face are saved as CSV with version, options and units', async ({
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

  const table = await exported(app, () => app.by('export-numbers-patches').check());
  const ofFaces = table.bytes
    .toString()
    .trim()
    .split('\n')
    .filter((line) => /^\d/.test(line));
  expect(ofFaces.length).toBe(Number((await app.by('status-faces').innerText()).replace(/\D/g, '')));
  expect(new Set(ofFaces.map((row) => row.split(',')[1])).size).toBe((await app.stats()).patches);
});

test('poses without times are one second apart, as the timeline shows, and play at that speed', async ({ app }) => {
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
  expect(text).toMatch(/^60 frames, 2 s, /);
  await expect(app.by('export-duration')).toHaveValue('2');
  await expect(app.by('export-speed')).toHaveText('as played here');
});
