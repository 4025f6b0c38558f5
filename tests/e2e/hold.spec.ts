/**
 * "Hold still parts": feet that rest between two keys stay in place, and the choice can be undone, stored and linked.
 */
import { writeFileSync } from 'node:fs';
import { diagonal, difference, expect, test, type App } from './support.ts';

/** A wall, as OBJ: it rests below height 2 and bends to either side above. */
function pose(bend: number): string {
  const lines: string[] = [];
  for (let row = 0; row <= 12; row++) {
    const above = Math.max(0, row / 3 - 2);
    const angle = bend * above;
    const [side, up] = bend === 0 ? [0, above] : [(1 - Math.cos(angle)) / bend, Math.sin(angle) / bend];
    for (const x of [-0.5, 0.5])
      for (const z of [-0.2, 0.2]) {
        const out = above === 0 ? 0 : x;
        const foot = above === 0 ? x : 0;
        lines.push(
          `v ${foot + side + out * Math.cos(angle)} ${Math.min(row / 3, 2) + up - out * Math.sin(angle)} ${z}`,
        );
      }
  }
  const ring = [0, 1, 3, 2];
  for (let row = 0; row < 12; row++)
    for (let side = 0; side < 4; side++) {
      const [a, b] = [ring[side]!, ring[(side + 1) % 4]!];
      lines.push(`f ${[4 * row + a, 4 * row + b, 4 * row + 4 + b, 4 * row + 4 + a].map((v) => v + 1).join(' ')}`);
    }
  return [...lines, 'f 1 3 4 2', 'f 49 50 52 51', ''].join('\n');
}

/** Largest distance of the foot's vertices from their rest positions, relative to the diagonal. */
async function slide(app: App): Promise<number> {
  const standing = await app.positionsAt(0);
  let most = 0;
  for (const t of [0.3, 0.7, 1.2, 1.5, 1.8, 2.4, 2.7]) {
    const at = await app.positionsAt(t);
    standing.forEach((_, index) => {
      const v = index - (index % 3);
      if (standing[v + 1]! < standing[1]! + 1.2) most = Math.max(most, Math.abs(at[index]! - standing[index]!));
    });
  }
  return most / diagonal(standing);
}

test('a resting foot stays in place', async ({ app }, testInfo) => {
  const files = [0, 0.5, -0.35, 0.3].map((bend, index) => {
    const path = testInfo.outputPath(`pose-${index}.obj`);
    writeFileSync(path, pose(bend));
    return path;
  });
  await app.open();
  await app.by('file-input').setInputFiles(files);
  await expect.poll(async () => (await app.state()).doc.keys.length).toBe(4);
  await app.settled();
  const plain = await slide(app);
  expect(plain).toBeGreaterThan(0.002);
  const keys = [await app.positionsAt(1), await app.positionsAt(2)];

  await app.by('hold').check();
  await app.settled();
  expect(await slide(app)).toBeLessThan(0.6 * plain);
  for (const [index, key] of keys.entries())
    expect(difference(await app.positionsAt(index + 1), key)).toBeLessThan(1e-5 * diagonal(key));
  await app.setTime(1.5);
  // Plots are computed only while visible.
  const value = async (): Promise<number> => {
    await app.by('plot-bending').scrollIntoViewIfNeeded();
    await expect(app.by('plot-sliding')).toBeVisible();
    return Number.parseFloat((await app.by('plot-sliding-value').textContent())!);
  };
  await expect.poll(value).toBeLessThan(0.6 * 100 * plain);
  await app.by('hold').uncheck();
  await expect.poll(value).toBeGreaterThan(0.05);
  await app.by('undo').click();
  await expect(app.by('hold')).toBeChecked();
  await app.settled();
  const held = await app.positionsAt(1.5);
  await app.reload();
  await expect(app.by('hold')).toBeChecked();
  expect(difference(await app.positionsAt(1.5), held)).toBeLessThan(1e-6);
});

test('a link turns holding on; other methods and two keys do not offer it', async ({ app }) => {
  await app.open({ hash: '#sample=gymnast&hold=contact&t=0.3' });
  await expect(app.by('hold')).toBeChecked();
  const held = await app.positionsAt(0.3);
  // Compared with the published method, which is not offered when nothing is held.
  await app.by('compare-lri').check();
  await app.settled();
  await expect(app.page.getByText('LRI), as published').first()).toBeVisible();
  expect(difference(await app.positionsAt(0.3, 1), held)).toBeGreaterThan(0);
  await app.by('hold').uncheck();
  await app.settled();
  expect(difference(await app.positionsAt(0.3), held)).toBeGreaterThan(0);
  await expect(app.by('compare-lri')).toBeHidden();
  await app.by('method').selectOption('linear');
  await expect(app.by('hold')).toBeHidden();
  await app.by('method').selectOption('lri');
  await expect(app.by('hold')).toBeVisible();
  for (let keys = 4; keys >= 2; keys--) {
    await app.by('key-0-go').focus();
    await app.page.keyboard.press('Delete');
    await expect.poll(async () => (await app.state()).doc.keys.length).toBe(keys);
  }
  await expect(app.by('hold')).toBeHidden();
});
