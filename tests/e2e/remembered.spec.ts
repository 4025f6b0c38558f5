/** Files that the browser stores between visits: with several tabs, after failures, and with full storage. */
import { randomBytes } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page, TestInfo } from '@playwright/test';
import { App, expect, test } from './support.ts';

// Each test starts with empty storage.
test.use({ fresh: true });

const sample = (name: string): string => fileURLToPath(new URL(`../../public/samples/${name}.glb`, import.meta.url));
const BAR = sample('twisted-bar');
const OTHER = sample('cactus');

interface Kept {
  project: { id: string; opening: boolean; version: number; state: { time: number; source: { names: string[] } } };
  files?: { name: string }[];
}

/** The model with this many additional incompressible bytes. */
function padded(file: string, bytes: number, info: TestInfo): string {
  const glb = readFileSync(file);
  const end = 20 + glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, end)) as { extras?: unknown };
  json.extras = randomBytes(bytes / 2).toString('hex');
  const text = JSON.stringify(json);
  const padding = Buffer.from(text + ' '.repeat((4 - (text.length % 4)) % 4));
  const head = Buffer.from(glb.subarray(0, 20));
  head.writeUInt32LE(glb.length - end + 20 + padding.length, 8);
  head.writeUInt32LE(padding.length, 12);
  const to = info.outputPath(path.basename(file));
  writeFileSync(to, Buffer.concat([head, padding, glb.subarray(end)]));
  return to;
}

/** Everything in the storage, by key. */
const shelf = (page: Page): Promise<Record<string, unknown>> =>
  page.evaluate(
    () =>
      new Promise<Record<string, unknown>>((resolve, reject) => {
        const open = indexedDB.open('shapespline');
        open.onerror = () => reject(open.error);
        open.onsuccess = () => {
          const store = open.result.transaction('remembered').objectStore('remembered');
          const [keys, values] = [store.getAllKeys(), store.getAll()];
          store.transaction.oncomplete = () => {
            open.result.close();
            resolve(Object.fromEntries(keys.result.map((key, index) => [key, values.result[index]])));
          };
        };
      }),
  );

/** The stored projects with their files, by the name of the first file. */
async function kept(page: Page): Promise<Record<string, Kept>> {
  const all = await shelf(page);
  const projects = Object.entries(all).filter(([key]) => key.startsWith('project '));
  return Object.fromEntries(
    projects.map(([, value]) => {
      const project = value as Kept['project'];
      return [project.state.source.names[0], { project, files: all[`files ${project.id}`] as Kept['files'] }];
    }),
  );
}

const keptTime = async (page: Page, name: string): Promise<number | undefined> =>
  (await kept(page))[name]?.project.state.time;

/** The project that the next visit opens first. */
async function lastKept(page: Page): Promise<string | undefined> {
  const all = Object.entries(await kept(page)) as [string, { project: { changed?: number } }][];
  return all.sort(([, a], [, b]) => (b.project.changed ?? 0) - (a.project.changed ?? 0))[0]?.[0];
}

/** Writes a record as another version, or an accident, might have left it. */
const leave = (page: Page, records: Record<string, unknown>): Promise<void> =>
  page.evaluate(
    (entries) =>
      new Promise<void>((resolve, reject) => {
        const open = indexedDB.open('shapespline');
        open.onerror = () => reject(open.error);
        open.onsuccess = () => {
          const store = open.result.transaction('remembered', 'readwrite').objectStore('remembered');
          for (const [key, value] of Object.entries(entries)) {
            if (value === undefined) store.delete(key);
            else store.put(value, key);
          }
          store.transaction.oncomplete = () => {
            open.result.close();
            resolve();
          };
        };
      }),
    records,
  );

async function drop(app: App, file: string): Promise<void> {
  await app.by('file-input').setInputFiles(file);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
}

/** The page stores files automatically, some time after opening. */
const isRemembered = (app: App, is = true): Promise<void> =>
  expect(app.by('remember')).toHaveAttribute('aria-pressed', String(is));

const names = async (app: App): Promise<string[] | null> => {
  const { source } = await app.state();
  return source.kind === 'files' ? source.names : null;
};

/** Waits longer than the delay before a change is written. */
const untilWritten = (app: App): Promise<void> => app.page.waitForTimeout(700);

/** The next visit, with an empty URL fragment. */
const visitAgain = (app: App): Promise<unknown> => app.open();

/** Chooses from the list of the user's files. */
async function choose(app: App, name: string): Promise<void> {
  await app.by('sample').click();
  await app.page.getByRole('group', { name: 'Your files' }).getByRole('button', { name }).click();
  await expect.poll(() => names(app)).toContain(name);
  await app.settled();
}

test('files of the user are stored with all edits', async ({ app }) => {
  await app.open();
  await expect(app.by('remember')).toBeHidden();
  await drop(app, BAR);
  await isRemembered(app);
  await expect(app.by('toast')).toContainText('remembered on this computer');
  await app.setTime(0.3);
  await app.by('add-current').click();
  await app.settled();
  await app.by('boundary-hermite').check();
  await app.settled();
  const before = { ...(await app.state()), shape: await app.positionsAt(0.2) };
  await expect.poll(() => keptTime(app.page, 'twisted-bar.glb')).toBe(0.2);

  await visitAgain(app);
  const after = await app.state();
  expect(after.source).toEqual(before.source);
  expect(after.doc).toEqual(before.doc);
  expect(after.time).toBe(0.2);
  expect(await app.positions()).toEqual(before.shape);
  await isRemembered(app);
  await app.expectNoProblems();
});

test('nothing is stored if the user declines, and the browser asks before edits are lost', async ({ app }) => {
  await app.open();
  await drop(app, BAR);
  await isRemembered(app);
  await app.by('remember').click();
  await isRemembered(app, false);
  let asked = 0;
  app.page.on('dialog', (dialog) => {
    asked += dialog.type() === 'beforeunload' ? 1 : 0;
    void dialog.accept();
  });
  await visitAgain(app);
  expect(asked).toBe(0);
  expect((await app.state()).source.kind).toBe('sample');
  await drop(app, BAR);
  await untilWritten(app);
  await isRemembered(app, false);
  expect(await shelf(app.page)).toEqual({});
  await app.by('boundary-hermite').check();
  await app.settled();
  await app.page.reload();
  expect(asked).toBe(1);
  await app.expectNoProblems();
});

test('continuous changes are stored, and so is the last change before the page closes', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  await drop(app, BAR);
  await isRemembered(app);
  const began = Date.now();
  for (let step = 1; Date.now() - began < 2500; step++) await app.setTime((step % 90) / 100);
  expect(await keptTime(app.page, 'twisted-bar.glb')).toBeGreaterThan(0);
  await app.by('boundary-hermite').check();
  await visitAgain(app);
  expect((await app.state()).doc.motion.boundary).toBe('hermite');
});

test('earlier content returns by undo, from the list, and on the next visit', async ({ app }) => {
  await app.open();
  await drop(app, BAR);
  await app.by('boundary-hermite').check();
  await app.settled();
  const bar = await app.state();
  await isRemembered(app);
  await app.pick('octopus');
  await app.settled();
  await expect(app.by('undo')).toHaveAttribute('aria-label', 'Undo: open Octopus');
  await app.by('undo').click();
  await expect.poll(() => names(app)).toEqual(['twisted-bar.glb']);
  await app.settled();
  expect((await app.state()).doc).toEqual(bar.doc);
  await expect(app.by('redo')).toHaveAttribute('aria-label', 'Redo: open Octopus');
  // Undo first removes its edits, then its opening.
  await app.by('undo').click();
  await app.settled();
  expect((await app.state()).doc.motion.boundary).toBe('natural');
  await expect(app.by('undo')).toHaveAttribute('aria-label', 'Undo: open twisted-bar.glb');
  await app.by('redo').click();
  await app.settled();
  await untilWritten(app);

  await drop(app, OTHER);
  await isRemembered(app);
  await choose(app, 'twisted-bar.glb');
  expect((await app.state()).doc).toEqual(bar.doc);
  await expect.poll(() => lastKept(app.page)).toBe('twisted-bar.glb');
  await visitAgain(app);
  expect(await names(app)).toEqual(['twisted-bar.glb']);
  expect((await app.state()).doc).toEqual(bar.doc);
  await app.expectNoProblems();
});

test.describe('two tabs', () => {
  test('store a project each, and never mix the files of one with the state of the other', { tag: '@all' }, async ({
    app,
    context,
  }) => {
    await app.open();
    await drop(app, BAR);
    await isRemembered(app);
    const other = await new App(await context.newPage()).open();
    await drop(other, OTHER);
    await isRemembered(other);
    await app.setTime(0.7);
    await other.setTime(0.3);
    await expect.poll(() => keptTime(app.page, 'twisted-bar.glb')).toBe(0.7);
    await expect.poll(() => keptTime(app.page, 'cactus.glb')).toBe(0.3);
    for (const [name, { project, files }] of Object.entries(await kept(app.page))) {
      expect(project.state.source.names).toEqual([name]);
      expect(files?.map((file) => file.name)).toEqual([name]);
    }

    // Deleting everything waits until both tabs have closed the storage; then they store their files again.
    const deleted = await app.page.evaluate(
      () =>
        new Promise<string>((resolve) => {
          const request = indexedDB.deleteDatabase('shapespline');
          request.onsuccess = () => resolve('deleted');
          request.onblocked = () => resolve('blocked');
        }),
    );
    expect(deleted).toBe('deleted');
    await expect.poll(() => keptTime(app.page, 'twisted-bar.glb')).toBe(0.7);
    await expect.poll(() => keptTime(app.page, 'cactus.glb')).toBe(0.3);
    await isRemembered(app);
  });

  test('that change the same files store both versions', { tag: '@all' }, async ({ app, context }) => {
    await app.open();
    await drop(app, BAR);
    await isRemembered(app);
    await untilWritten(app);
    const other = await new App(await context.newPage()).open();
    expect(await names(other)).toEqual(['twisted-bar.glb']);
    await other.setTime(0.3);
    await expect.poll(() => keptTime(app.page, 'twisted-bar.glb')).toBe(0.3);
    await app.setTime(0.7);
    await expect(app.by('toast')).toContainText('Both versions were kept');
    const projects = Object.entries(await shelf(app.page)).filter(([key]) => key.startsWith('project '));
    expect(projects.map(([, project]) => (project as Kept['project']).state.time).sort()).toEqual([0.3, 0.7]);
  });

  test('forget for both', { tag: '@all' }, async ({ app, context }) => {
    await app.open();
    await drop(app, BAR);
    await isRemembered(app);
    await untilWritten(app);
    const other = await new App(await context.newPage()).open();
    expect(await names(other)).toEqual(['twisted-bar.glb']);
    await other.by('remember').click();
    await isRemembered(app, false);
    await app.setTime(0.7);
    await app.by('boundary-hermite').check();
    await app.settled();
    await untilWritten(app);
    expect(await shelf(app.page)).toEqual({});
  });
});

test('unreadable records of an earlier visit are set aside with a message', { tag: '@all' }, async ({ app }) => {
  await app.open();
  const project = { format: 3, id: 'x', opening: false, poses: [], state: {} };
  await leave(app.page, { 'project x': project, 'files x': [] });
  await visitAgain(app);
  expect((await app.state()).source.kind).toBe('sample');
  await expect(app.by('toast')).toContainText('can no longer be read');
  await expect(app.by('error')).toBeHidden();
  const after = await shelf(app.page);
  expect(after['set aside x']).toMatchObject({ project });
  expect(after).not.toHaveProperty(['project x']);
  await visitAgain(app);
  await expect(app.by('toast')).toHaveText('');
});

/** Typed arrays of the fixture, which JSON stores as `{ "Float32Array": [...] }`. */
const typed = (_: string, value: unknown): unknown => {
  const { Float32Array: floats, Uint8Array: bytes } = (value ?? {}) as {
    Float32Array?: number[];
    Uint8Array?: number[];
  };
  return floats ? Float32Array.from(floats) : bytes ? Uint8Array.from(bytes) : value;
};

// Only a browser's storage holds such a record.
test('a project that commit 4f00d434 stored opens with its edits', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await drop(app, BAR); // makes the storage
  await untilWritten(app);
  const stored = readFileSync(new URL('../saved/browser.json', import.meta.url), 'utf8');
  await leave(app.page, JSON.parse(stored, typed) as Record<string, unknown>);
  await visitAgain(app);
  await choose(app, 'a.obj');
  const { doc, time } = await app.state();
  expect(doc.keys.map(({ name, time }) => [name, time])).toEqual([
    ['a', 0],
    ['other', 0.7],
    ['b', 1],
    ['c', 2],
  ]);
  expect(doc.motion).toMatchObject({ boundary: 'hermite', endSpeed: 2 });
  expect(doc.motion).not.toHaveProperty('ownPaths');
  expect(time).toBe(0.25);
  // The added key is the stored pose.
  await app.setTime(0.7);
  const positions = await app.page.evaluate(() => [...window.__shapespline!.positions()]);
  const { poses } = Object.values(JSON.parse(stored) as object)[1] as {
    poses: { positions: { Float32Array: number[] } }[];
  };
  poses[0]!.positions.Float32Array.forEach((value, i) => expect(positions[i]).toBeCloseTo(value, 4));
  await app.expectNoProblems();
});

test('files during whose opening the last visit ended are opened on request only', { tag: '@all' }, async ({ app }) => {
  await app.open();
  await drop(app, BAR);
  await isRemembered(app);
  await untilWritten(app);
  const { project } = (await kept(app.page))['twisted-bar.glb']!;
  await leave(app.page, { [`project ${project.id}`]: { ...project, opening: true } });
  await visitAgain(app);
  expect((await app.state()).source.kind).toBe('sample');
  await expect(app.by('not-reopened')).toContainText('“twisted-bar.glb” was not reopened');
  await app.by('not-reopened-accept').click();
  await expect.poll(() => names(app)).toEqual(['twisted-bar.glb']);
  await app.settled();
  await expect(app.by('not-reopened')).toBeHidden();
  await isRemembered(app);
  await expect.poll(async () => (await kept(app.page))['twisted-bar.glb']?.project.opening).toBe(false);
});

test('files whose opening was interrupted by a reload are opened by the next visit', { tag: '@all' }, async ({
  app,
}) => {
  await app.open();
  await drop(app, BAR);
  await isRemembered(app);
  await untilWritten(app);
  // Reloads the page as soon as it has recorded the start of opening.
  await app.page.addInitScript(() => {
    const visit = Number(sessionStorage.getItem('visit')) + 1;
    sessionStorage.setItem('visit', String(visit));
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (value: { opening?: boolean }, key) {
      if (value.opening && visit <= 3) this.transaction.addEventListener('complete', () => location.reload());
      return put.call(this, value, key);
    };
  });
  await app.page.reload({ waitUntil: 'commit' });
  await app.page.waitForFunction(() => sessionStorage.getItem('visit') === '4');
  await app.started();
  expect(await names(app)).toEqual(['twisted-bar.glb']);
  await expect(app.by('not-reopened')).toBeHidden();
});

test.describe('with a service worker', () => {
  test.use({ ownProfile: true });

  test('a full disk gives a message, and earlier records are kept', { tag: '@all' }, async ({ app, context }, info) => {
    test.skip(info.project.name === 'dev', 'the room is measured once the files of the page are kept');
    await app.open();
    await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    // Storage for the first files only. The browser checks its limit before the first write, then rarely.
    const session = await context.newCDPSession(app.page);
    const { origin } = new URL(app.page.url());
    const { usage } = await session.send('Storage.getUsageAndQuota', { origin });
    await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: usage + 600_000 });
    const [first, next] = [padded(BAR, 50_000, info), padded(OTHER, 800_000, info)];
    await drop(app, first);
    await isRemembered(app);
    const before = await kept(app.page);
    await drop(app, next);
    await expect(app.by('error-message')).toContainText('no room');
    await isRemembered(app, false);
    expect(Object.keys(await kept(app.page))).toEqual(Object.keys(before));
    await app.by('remember').click();
    await expect(app.by('error-message')).toContainText('no room');
    expect((await kept(app.page))['twisted-bar.glb']?.files?.map(({ name }) => name)).toEqual(['twisted-bar.glb']);
  });
});
