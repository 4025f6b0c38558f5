/** Failures on users' machines: no work is lost, and the page stays responsive. */
import { difference, expect, test } from './support.ts';
import type { App } from './support.ts';

// The test ends the page's workers.
test.use({ fresh: true });

/** Ends every worker from inside, which sends the page no event. */
async function killWorkers(app: App): Promise<void> {
  const workers = app.page.workers();
  expect(workers.length).toBeGreaterThan(0);
  for (const worker of workers) await worker.evaluate(() => self.close()).catch(() => undefined);
}

test('a worker that the browser ended is started again with the same content', async ({ app }) => {
  await app.open();
  await app.by('boundary-hermite').check();
  await app.settled();
  await app.by('add-current').scrollIntoViewIfNeeded();
  await app.setTime(1.2);
  await app.by('add-current').click();
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(4);
  await app.settled();
  const { doc } = await app.state();
  const before = await app.positionsAt(0.3);
  await killWorkers(app);
  await expect(app.by('toast')).toContainText('nothing was lost');
  expect(await app.positionsAt(0.3)).toEqual(before);
  expect((await app.state()).doc).toEqual(doc);
  expect(difference(await app.positionsAt(0.8), before)).toBeGreaterThan(0);
  await app.by('undo').click();
  await app.settled();
  expect((await app.state()).doc.keys.length).toBe(3);
  await expect(app.by('error')).toBeHidden();
});

test('a worker that ends during playback is restarted automatically', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const before = await app.positionsAt(0.3);
  await app.by('play').click();
  await killWorkers(app);
  await expect(app.by('toast')).toContainText('nothing was lost');
  await expect.poll(async () => difference(await app.positions(), before)).toBeGreaterThan(0);
  await app.by('play').click();
  expect(await app.positionsAt(0.3)).toEqual(before);
  await expect(app.by('error')).toBeHidden();
});

test('the end of a worker is also detected on a page without https, which has no locks', { tag: '@all' }, async ({
  app,
  baseURL,
}) => {
  await app.page.goto(`http://insecure.test:${new URL(baseURL!).port}${new URL(baseURL!).pathname}`);
  await app.started();
  expect(await app.page.evaluate(() => [isSecureContext, 'locks' in navigator])).toEqual([false, false]);
  const before = await app.positionsAt(0.3);
  await killWorkers(app);
  await expect(app.by('toast')).toContainText('nothing was lost');
  expect(await app.positionsAt(0.3)).toEqual(before);
  expect(difference(await app.positionsAt(0.8), before)).toBeGreaterThan(0);
  await expect(app.by('error')).toBeHidden();
  await app.expectNoProblems();
});

interface Big {
  /** Number of heartbeats during the work. */
  beats: number;
  longest: number;
  /** Whether the page showed its progress. */
  progress: boolean;
}

/** Gives the page a file made inside it, and counts heartbeats until `done`. */
async function openBig(app: App, kind: 'model' | 'junk', size: number): Promise<void> {
  await app.page.evaluate(
    ([what, bytes]) => {
      const file = (): File => {
        if (what === 'junk') return new File([new Uint8Array(bytes as number).fill(65)], 'big.glb');
        // A triangle strip and a bent copy, in a buffer much larger than needed.
        const points = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0.3, 1, 2, 0.3];
        const moved = points.map((_, i) => (i % 3 === 2 ? points[i - 1]! * 0.4 : 0));
        const faces = [0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5];
        const head = new Uint8Array(72 + 72 + 24);
        new Float32Array(head.buffer, 0, 18).set(points);
        new Float32Array(head.buffer, 72, 18).set(moved);
        new Uint16Array(head.buffer, 144, 12).set(faces);
        const json = {
          asset: { version: '2.0' },
          scene: 0,
          scenes: [{ nodes: [0] }],
          nodes: [{ mesh: 0 }],
          meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 2, targets: [{ POSITION: 1 }] }] }],
          buffers: [{ byteLength: bytes }],
          bufferViews: [
            { buffer: 0, byteLength: 72 },
            { buffer: 0, byteOffset: 72, byteLength: 72 },
            { buffer: 0, byteOffset: 144, byteLength: 24 },
          ],
          accessors: [
            { bufferView: 0, componentType: 5126, count: 6, type: 'VEC3', min: [0, 0, 0], max: [1, 2, 0.3] },
            { bufferView: 1, componentType: 5126, count: 6, type: 'VEC3', min: [0, 0, 0], max: [0, 0, 0.8] },
            { bufferView: 2, componentType: 5123, count: 12, type: 'SCALAR' },
          ],
        };
        let text = JSON.stringify(json);
        while (text.length % 4 !== 0) text += ' ';
        const chunk = new TextEncoder().encode(text);
        const header = new DataView(new ArrayBuffer(20));
        [0x46546c67, 2, 20 + chunk.length + 8 + (bytes as number), chunk.length, 0x4e4f534a].forEach((word, i) =>
          header.setUint32(4 * i, word, true),
        );
        const second = new DataView(new ArrayBuffer(8));
        [bytes as number, 0x004e4942].forEach((word, i) => second.setUint32(4 * i, word, true));
        return new File([header, chunk, second, head, new Uint8Array((bytes as number) - head.length)], 'big.glb');
      };
      const transfer = new DataTransfer();
      transfer.items.add(file());
      const input = document.querySelector<HTMLInputElement>('[data-testid="file-input"]')!;
      input.files = transfer.files;
      const heart = { beats: 0, longest: 0, progress: false };
      const progress = document.querySelector('[data-testid="progress"]')!;
      let last = performance.now();
      setInterval(() => {
        heart.beats += 1;
        heart.longest = Math.max(heart.longest, performance.now() - last);
        last = performance.now();
        heart.progress ||= progress.checkVisibility();
      }, 20);
      Object.assign(window, { heart });
      input.dispatchEvent(new Event('change'));
    },
    [kind, size] as const,
  );
}

const heart = (app: App): Promise<Big> => app.page.evaluate(() => (window as unknown as { heart: Big }).heart);

test('the page responds while a file of 200 MB is opened', { tag: '@all' }, async ({ app }) => {
  test.setTimeout(240_000);
  await app.open();
  await openBig(app, 'model', 200_000_000);
  // The earlier shape can still be moved. In one call, because a fast machine opens the file quickly.
  const [shown, moved] = await app.page.evaluate(async () => {
    const hook = window.__shapespline!;
    const before = Array.from(hook.positions());
    await hook.setTime(0.8);
    return [before, Array.from(hook.positions())] as const;
  });
  expect(difference(moved, shown)).toBeGreaterThan(0);
  await expect.poll(async () => (await app.state()).source.kind, { timeout: 120_000 }).toBe('files');
  expect((await heart(app)).progress).toBe(true);
  await app.settled();
  await expect(app.by('status-vertices')).toHaveText('6 vertices');
  expect((await app.positionsAt(0.5)).every(Number.isFinite)).toBe(true);
  // Far below a delay that a user would notice, even on a slow machine.
  expect((await heart(app)).longest).toBeLessThan(5000);
  await app.expectNoProblems();
});

test('the page responds while an invalid file of 200 MB is refused', { tag: '@all' }, async ({ app }) => {
  test.setTimeout(240_000);
  await app.open();
  const before = await app.positions();
  await openBig(app, 'junk', 200_000_000);
  await expect(app.by('error-message')).toContainText('big.glb', { timeout: 120_000 });
  await app.settled();
  expect(await app.positions()).toEqual(before);
  expect((await heart(app)).longest).toBeLessThan(5000);
  await app.expectNoProblems();
});
