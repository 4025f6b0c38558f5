/**
 * The offer of an option that suits the keys. In a browser, because the offer comes while the real page plays, runs
 * in its workers, and is accepted by a click; its conditions have unit and engine tests.
 */
import { poseFiles } from '../engine/support/glb.ts';
import { rolledSheet } from '../engine/support/shapes.ts';
import { expect, test } from './support.ts';

test('for a sheet, the page offers to keep its lengths; the panel shows the option and resets it', async ({ app }) => {
  const { faces, poses } = rolledSheet(8, 3.5);
  const files = poseFiles({ positions: poses[0]!, indices: faces }, poses);
  await app.open();
  await app
    .by('file-input')
    .setInputFiles(
      files.map(({ name, bytes }) => ({ name, mimeType: 'model/gltf-binary', buffer: Buffer.from(bytes) })),
    );
  await expect(app.by('option-offer')).toContainText('lengths of edges');
  const before = await app.positionsAt(0.5);
  await app.by('option-offer-accept').click();
  await expect(app.by('option-offer')).toBeHidden();
  await app.settled();
  expect((await app.state()).doc.motion.keepLengths).toBe(1);
  expect(await app.positionsAt(0.5)).not.toEqual(before);
  await expect(app.by('spline-options')).toContainText('lengths kept');
  await app.by('spline-options').click();
  await app.by('keep-lengths-0').check();
  await app.settled();
  expect(await app.positionsAt(0.5)).toEqual(before);
  await app.by('boundary-periodic').check();
  await expect(app.by('keep-lengths-reason')).toContainText('free ends');
  await app.expectNoProblems();
});
