/** Poses opened one after the other: the first waits for the next; another becomes a key. */
import { writeFileSync } from 'node:fs';
import type { App } from './support.ts';
import { expect, test } from './support.ts';

const QUAD = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`;
const TRIANGLE = (x: number): string => `v 0 0 0\nv 1 0 0\nv ${x} 1 0\nf 1 2 3\n`;

const given = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

async function pick(app: App, name: string, text: string): Promise<void> {
  await app.by('file-input').setInputFiles(given(name, text));
}

const keys = async (app: App): Promise<[string, number][]> =>
  (await app.state()).doc.keys.map(({ name, time }) => [name, time]);

/** Opens a motion of the user's own. */
async function openTwo(app: App): Promise<void> {
  await app.by('file-input').setInputFiles([given('a.obj', QUAD(0.5)), given('b.obj', QUAD(0.2))]);
  await expect.poll(async () => (await keys(app)).length).toBe(2);
  await app.settled();
}

test('poses are picked one by one: the first waits, the second opens the motion, further ones are keys', async ({
  app,
}) => {
  await app.open();
  // One click discards a waiting pose.
  await pick(app, 'other.obj', TRIANGLE(0));
  await app.by('pose-offer-later').click();
  await expect(app.by('pose-offer')).toBeHidden();
  await pick(app, 'a.obj', QUAD(0.5));
  await expect(app.by('pose-offer')).toContainText('“a.obj” is the first pose');
  await expect(app.by('error')).toBeHidden();
  expect((await app.state()).source.kind).toBe('sample');
  await pick(app, 'b.obj', QUAD(0.2));
  await expect
    .poll(() => keys(app))
    .toEqual([
      ['a', 0],
      ['b', 1],
    ]);
  await expect(app.by('pose-offer')).toBeHidden();
  await app.settled();
  await pick(app, 'c.obj', QUAD(-0.5));
  await expect
    .poll(() => keys(app))
    .toEqual([
      ['a', 0],
      ['b', 1],
      ['c', 2],
    ]);
  await app.settled();
  const corner = (await app.positionsAt(2)).slice(6, 9);
  [0.5, 0, 1].forEach((value, axis) => expect(corner[axis]).toBeCloseTo(value, 5));
  await app.by('undo').click();
  await expect.poll(async () => (await keys(app)).length).toBe(2);
  await app.expectNoProblems();
});

test('a pose dropped between two keys becomes a key between them', async ({ app }, info) => {
  await app.open();
  await openTwo(app);
  const file = info.outputPath('between.obj');
  writeFileSync(file, QUAD(0.9));
  const [first, second] = [(await app.by('key-0').boundingBox())!, (await app.by('key-1').boundingBox())!];
  const between = { x: (first.x + first.width + second.x) / 2, y: first.y + first.height / 2 };
  // Before the drop, a mark shows the position of the new key, and the keys are visible.
  await app.dragOver([file], between);
  await expect(app.by('drop-zone')).toHaveText(/becomes key 2$/);
  await expect(app.by('key-1')).toHaveAttribute('data-drop', 'before');
  await app.drop([file], between);
  await expect(app.by('key-1')).not.toHaveAttribute('data-drop');
  await expect
    .poll(() => keys(app))
    .toEqual([
      ['a', 0],
      ['between', 0.5],
      ['b', 1],
    ]);
  await app.settled();
  await expect(app.by('toast')).toContainText('“between.obj” was added as a key');
  await app.expectNoProblems();
});

test(
  'a pose dropped in a corner of a phone, where no keys are shown, becomes the last key',
  { tag: '@all' },
  async ({ app }, info) => {
    await app.page.setViewportSize({ width: 360, height: 740 });
    await app.open();
    await openTwo(app);
    const file = info.outputPath('next.obj');
    writeFileSync(file, QUAD(0.9));
    await app.drop([file], { x: 0, y: 0 });
    await expect.poll(async () => (await keys(app)).map(([name]) => name)).toEqual(['a', 'b', 'next']);
    await app.expectNoProblems();
  },
);

test('a pose of another mesh waits for the next; Undo in the message restores the earlier work', async ({ app }) => {
  await app.open();
  await openTwo(app);
  await pick(app, 'other.obj', TRIANGLE(0));
  await expect(app.by('pose-offer')).toContainText(
    'other.obj has 3 vertices, but key 1 has 4. “other.obj” is the first pose',
  );
  expect(await keys(app)).toHaveLength(2);
  // A pose that matches neither mesh: the waiting pose keeps waiting.
  await pick(app, 'wrong.obj', 'v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 0 2\nf 1 2 3\nf 3 4 5\n');
  await expect(app.by('error-message')).toContainText('wrong.obj');
  await pick(app, 'next.obj', TRIANGLE(0.5));
  await expect.poll(async () => (await keys(app)).map(([name]) => name)).toEqual(['other', 'next']);
  await app.settled();
  await expect(app.by('error')).toBeHidden();
  await expect(app.by('pose-offer')).toBeHidden();
  await app.by('toast-undo').click();
  await expect.poll(async () => (await keys(app)).map(([name]) => name)).toEqual(['a', 'b']);
  await app.settled();
  await app.expectNoProblems();
});

test('a pose that fits is added also while another waits, and Esc drops the waiting one', async ({ app }) => {
  await app.open();
  await openTwo(app);
  await pick(app, 'other.obj', TRIANGLE(0));
  await expect(app.by('pose-offer')).toBeVisible();
  await pick(app, 'fits.obj', QUAD(0.1));
  await expect.poll(async () => (await keys(app)).map(([name]) => name)).toEqual(['a', 'b', 'fits']);
  await expect(app.by('pose-offer')).toBeHidden();
  await app.settled();
  await pick(app, 'other.obj', TRIANGLE(0));
  await expect(app.by('pose-offer')).toBeVisible();
  await app.page.keyboard.press('Escape');
  await expect(app.by('pose-offer')).toBeHidden();
  await app.expectNoProblems();
});

test('Undo in a message disappears when something else opens', async ({ app }) => {
  await app.open();
  await openTwo(app);
  await expect(app.by('toast-undo')).toBeVisible();
  await app.pick('cactus');
  await app.settled();
  await expect(app.by('toast-undo')).toHaveCount(0);
});

test('a pose dropped on the timeline becomes a key at that time', async ({ app }, info) => {
  await app.open();
  await openTwo(app);
  const file = info.outputPath('there.obj');
  writeFileSync(file, QUAD(0.9));
  const [first, last] = [(await app.by('tick-0').boundingBox())!, (await app.by('tick-1').boundingBox())!];
  const at = { x: first.x + first.width / 2 + 0.25 * (last.x - first.x), y: first.y + first.height / 2 };
  await app.dragOver([file], at);
  await expect(app.by('drop-zone')).toHaveText(/becomes a key at 0\.2\d* s$/);
  await app.drop([file], at);
  await expect.poll(async () => (await keys(app)).map(([name]) => name)).toEqual(['a', 'there', 'b']);
  expect((await keys(app))[1]![1]).toBeCloseTo(0.25, 1);
  await app.settled();
  await app.expectNoProblems();
});

// Only this test combines the picked files, the question and the result.
test('for two numbered sequences, the page asks which to open, or uses all files as keys', {
  tag: '@all',
}, async ({ app }) => {
  const run = [0, 1].map((i) => given(`run_000${i}.obj`, QUAD(0.1 * i)));
  const sim = [-1, -2, 0].map((i) => given(`sim.${i}.obj`, QUAD(0.5 + 0.1 * i)));
  await app.open();
  await app
    .by('file-input')
    .setInputFiles([...run, ...sim, given('Thumbs.db', 'x'), given('scene.blend', 'BLENDER-v405')]);
  await expect(app.by('pose-offer')).toContainText('There are 2 numbered sequences.');
  await expect(app.by('pose-offer-accept')).toHaveText('run_0000.obj to run_0001.obj (2 files)');
  expect((await app.state()).source.kind).toBe('sample');
  await app.by('pose-offer-other-0').click();
  await expect
    .poll(() => keys(app))
    .toEqual([
      ['sim.-2', 0],
      ['sim.-1', 1],
      ['sim.0', 2],
    ]);
  await expect(app.by('pose-offer')).toBeHidden();
  await app.settled();
  await app.by('file-input').setInputFiles([...run, ...sim]);
  await app.by('pose-offer-other-1').click();
  await expect.poll(async () => (await keys(app)).length).toBe(5);
});
