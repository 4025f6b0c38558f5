/** Files from other sources play after opening, without false warnings. */
import type { App } from './support.ts';
import { expect, realFile, test } from './support.ts';

async function opened(app: App, names: readonly string[]): Promise<void> {
  const files = names.map(realFile);
  test.skip(files.includes(null), 'the real files are not here');
  await app.page.emulateMedia({ reducedMotion: 'no-preference' });
  await app.open();
  await app.by('play').click();
  await app.by('file-input').setInputFiles(files as string[]);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
}

/** Loops, and the time advances without input. */
async function expectPlaying(app: App): Promise<void> {
  const { play, time } = await app.state();
  expect(play.playing).toBe(true);
  expect(['loop', 'bounce']).toContain(play.loop);
  await expect.poll(async () => (await app.state()).time).not.toBe(time);
}

/** At times between all keys, no inverted faces are reported. */
async function expectNoFolds(app: App): Promise<void> {
  const { keys } = (await app.state()).doc;
  for (let k = 1; k < keys.length; k += 1) {
    await app.setTime((keys[k - 1]!.time + keys[k]!.time) / 2);
    await expect(app.by('lost'), `between keys ${k} and ${k + 1}`).toBeHidden();
  }
}

test.describe('real motions', { tag: '@all' }, () => {
  test('a running wolf plays at once, without warnings', async ({ app }) => {
    await opened(
      app,
      [1, 4, 8, 12].map((number) => `obj/wolf/wolf-${number}.obj`),
    );
    await expectPlaying(app);
    await expectNoFolds(app);
    await expect(app.by('warning-count')).toBeHidden();
    await app.expectNoProblems();
  });

  test('a horse of morph targets plays at once, without a warning about folds', async ({ app }) => {
    await opened(app, ['morph/Horse.glb']);
    await expectPlaying(app);
    await expectNoFolds(app);
    await app.expectNoProblems();
  });

  test('three poses of a lion with large rotations: each warning names its keys and its location', async ({ app }) => {
    await opened(
      app,
      [1, 4, 7].map((number) => `turns/lion/${number}.obj`),
    );
    await app.by('warning-count').click();
    const turns = app.by('warnings').getByText(/regions rotate by/);
    await expect(turns.first()).toBeVisible();
    for (const text of await turns.allInnerTexts())
      expect(text).toMatch(
        /^Between key \d and key \d, (in the middle|at the [a-z ]+), neighbouring regions rotate by \d+/,
      );
    await app.expectNoProblems();
  });
});
