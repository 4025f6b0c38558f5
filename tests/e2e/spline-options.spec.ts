/**
 * Options of the shape spline. In a browser, because the panel is loaded while the real page plays, and its choice runs
 * in the page's workers; what rules an option out has unit tests.
 */
import { poseFiles } from '../engine/support/glb.ts';
import { rolledSheet } from '../engine/support/shapes.ts';
import { expect, test } from './support.ts';

test('lengths of a sheet are kept and released in the panel', async ({ app }) => {
  const { faces, poses } = rolledSheet(8, 3.5);
  const files = poseFiles({ positions: poses[0]!, indices: faces }, poses);
  await app.open();
  await app
    .by('file-input')
    .setInputFiles(
      files.map(({ name, bytes }) => ({ name, mimeType: 'model/gltf-binary', buffer: Buffer.from(bytes) })),
    );
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  const before = await app.positionsAt(0.5);
  await app.by('spline-options').click();
  await app.by('keep-lengths-1').check();
  await app.settled();
  expect(await app.positionsAt(0.5)).not.toEqual(before);
  await expect(app.by('spline-options')).toContainText('lengths kept');
  await app.by('keep-lengths-0').check();
  await app.settled();
  expect(await app.positionsAt(0.5)).toEqual(before);
  await app.by('boundary-periodic').check();
  await expect(app.by('keep-lengths-reason')).toContainText('free ends');
  await app.expectNoProblems();
});
