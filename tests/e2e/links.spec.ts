/** Links are untrusted. Whatever a link contains, a sample opens and only valid numbers are drawn. */
import { expect, test } from './support.ts';

test('a number out of range in a link is ignored, with a message', { tag: '@all' }, async ({ app }) => {
  await app.open({ hash: '#sample=cactus&patches=1e300&camera=1e300,0,0,0,0,0' });
  await expect(app.by('toast')).toContainText('ignored: patches, camera.');
  expect((await app.positions()).every(Number.isFinite)).toBe(true);
  await expect(app.by('error')).toBeHidden();
  await app.expectNoProblems();
});

test('a link to an unknown sample gives a message and shows another sample', async ({ app }) => {
  await app.open({ hash: '#sample=nosuch' });
  await expect(app.by('toast')).toContainText('There is no sample named “nosuch”.');
  expect((await app.state()).source.kind).toBe('sample');
});

test('an invalid link gives a message, and a camera that misses the shape can be reset', async ({ app }) => {
  await app.open({ hash: '#t=0.5' });
  await expect(app.by('toast')).toContainText('The link does not name a sample or tour page');
  await app.page.goto('about:blank');
  await app.open({ hash: '#sample=octopus&camera=0,0,5,0,0,10' });
  await expect(app.by('out-of-view')).toBeVisible();
  await app.by('fit-hint').click();
  await expect(app.by('out-of-view')).toBeHidden();
  await app.expectNoProblems();
});

test('a typed time beyond the zoom is shown on the timeline', async ({ app }) => {
  await app.open({ hash: '#sample=octopus&window=0,0.25' });
  await app.by('time').fill('0.75');
  await app.by('time').press('Enter');
  await expect.poll(async () => (await app.state()).view.window).toEqual([0, 0.75 + 0.05 * 0.75]);
  expect((await app.state()).time).toBe(0.75);
  await app.expectNoProblems();
});
