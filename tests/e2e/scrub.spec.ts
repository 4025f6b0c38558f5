/**
 * A shape that is a preview while it moves, exact when it rests. By itself the page draws so what is too large for 30
 * exact frames a second on the machine at hand (tests/unit/frame-loop); here its address asks for it.
 */
import { poseFiles } from '../engine/support/glb.ts';
import { bar, bent } from '../engine/support/shapes.ts';
import { changedShare } from './png.ts';
import { difference, expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const FACES = 40_000;

interface Sample {
  time: number;
  positions: Float32Array;
}

interface Collected {
  samples: Sample[];
  texts: string[];
}

/** Keeps some of the previews on the screen, and all that the status line says, until it is asked for them. */
async function collect(app: App): Promise<void> {
  await app.page.evaluate(() => {
    const hook = window.__shapespline!;
    const collected: Collected = { samples: [], texts: [] };
    const status = document.querySelector('[data-testid="status-ms"]')!;
    const look = (): void => {
      const { time, preview } = hook.shown;
      if (preview && collected.samples.length < 6 && collected.samples.at(-1)?.time !== time)
        collected.samples.push({ time, positions: hook.positions() });
      const text = status.textContent!.replace(/[\d.]+/, 'N');
      if (collected.texts.at(-1) !== text) collected.texts.push(text);
      requestAnimationFrame(look);
    };
    look();
    Object.assign(window, { collected });
  });
}

/** How far each sample is from the exact shape of its moment, in % of the diagonal. */
async function distances(app: App): Promise<{ time: number; mean: number; worst: number }[]> {
  return app.page.evaluate(async () => {
    const { samples } = (window as unknown as { collected: Collected }).collected;
    const results = [];
    for (const { time, positions } of samples) {
      const exact = await window.__shapespline!.evaluate(time);
      const low = [Infinity, Infinity, Infinity];
      const high = [-Infinity, -Infinity, -Infinity];
      let sum = 0;
      let worst = 0;
      for (let i = 0; i < exact.length; i += 3) {
        let squared = 0;
        for (let k = 0; k < 3; k += 1) {
          low[k] = Math.min(low[k]!, exact[i + k]!);
          high[k] = Math.max(high[k]!, exact[i + k]!);
          squared += (positions[i + k]! - exact[i + k]!) ** 2;
        }
        sum += Math.sqrt(squared);
        worst = Math.max(worst, Math.sqrt(squared));
      }
      const share = 100 / Math.hypot(...high.map((value, k) => value - low[k]!));
      results.push({ time, mean: (share * sum) / (exact.length / 3), worst: share * worst });
    }
    return results;
  });
}

/** Largest difference between what is drawn and the engine's own answer for the moment of the state. */
function distanceAtRest(app: App): Promise<number> {
  return app.page.evaluate(async () => {
    const hook = window.__shapespline!;
    const exact = await hook.evaluate(hook.state.time);
    const drawn = hook.positions();
    return exact.length === drawn.length
      ? exact.reduce((most, value, i) => Math.max(most, Math.abs(value - drawn[i]!)), 0)
      : NaN;
  });
}

const shown = (app: App): Promise<{ time: number; preview: boolean }> =>
  app.page.evaluate(() => window.__shapespline!.shown);

test('a shape is a preview while it is dragged or plays, and exact when it rests', async ({ app }) => {
  await app.open({ search: '?moving=preview' });
  await app.openGenerated(FACES);
  const status = app.by('status-ms');
  for (const t of [0.2, 0.3, 0.25]) await app.setTime(t);
  expect(await shown(app)).toEqual({ time: 0.25, preview: false });
  await expect(status).toHaveText(/ms per frame, exact$/);

  // Easing needs motion to be welcome.
  await app.page.emulateMedia({ reducedMotion: 'no-preference' });
  await collect(app);
  const box = (await app.by('timeline').locator('.track').boundingBox())!;
  const y = box.y + box.height / 2 - 22;
  await app.page.mouse.move(box.x + 0.3 * box.width, y);
  await app.page.mouse.down();
  for (
    let k = 0;
    k < 400 &&
    (await app.page.evaluate(() => (window as unknown as { collected: Collected }).collected.samples.length)) < 4;
    k += 1
  ) {
    await app.page.mouse.move(box.x + (0.1 + 0.8 * ((k * 0.013) % 1)) * box.width, y);
  }
  await app.page.mouse.up();
  await app.settled();
  const { time } = await app.state();
  expect(await shown(app)).toEqual({ time, preview: false });
  expect(await distanceAtRest(app)).toBe(0);
  await expect(status).toHaveText(/ms per frame, exact$/);

  const found = await distances(app);
  expect(found.length).toBeGreaterThanOrEqual(4);
  for (const { mean, worst } of found) {
    expect(mean).toBeGreaterThan(0);
    expect(mean).toBeLessThan(0.1);
    expect(worst).toBeLessThan(0.5);
  }
  const texts = await app.page.evaluate(() => (window as unknown as { collected: Collected }).collected.texts);
  expect(texts).toContain('N ms per frame, preview');

  // What was eased in is drawn as what is shown at once.
  const eased = await app.picture();
  await app.setTime(time > 0.5 ? 0.1 : 0.9);
  expect(changedShare(eased, await app.picture())).toBeGreaterThan(0.01);
  await app.setTime(time);
  expect(changedShare(eased, await app.picture())).toBeLessThan(0.001);

  const before = await app.positions();
  await app.by('play').click();
  await expect.poll(async () => (await shown(app)).preview).toBe(true);
  await expect.poll(async () => (await shown(app)).time).not.toBe(time);
  await app.by('play').click();
  await app.settled();
  expect(await shown(app)).toEqual({ time: (await app.state()).time, preview: false });
  expect(await distanceAtRest(app)).toBe(0);
  expect(difference(await app.positions(), before)).toBeGreaterThan(0);
  await app.expectNoProblems();
});

/**
 * Keys at 0, 1 and 2 s. Previews are off by 0.2 % of the diagonal before the middle key, 0.05 % after it
 * (tests/engine/preview).
 */
async function openRolledUp(app: App): Promise<void> {
  const mesh = bar();
  const files = poseFiles(
    mesh,
    [0, 420, 430].map((degrees) => bent(mesh, degrees)),
  );
  await app
    .by('file-input')
    .setInputFiles(
      files.map(({ name, bytes }) => ({ name, mimeType: 'model/gltf-binary', buffer: Buffer.from(bytes) })),
    );
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
}

/**
 * Drags to and fro between two moments, as shares of the keys' time, and says what was on the screen meanwhile; ends at
 * rest.
 */
async function drag(app: App, from: number, to: number): Promise<{ time: number; preview: boolean }[]> {
  await app.page.evaluate(() => {
    const seen: { time: number; preview: boolean }[] = [];
    const look = (): void => {
      const { time, preview } = window.__shapespline!.shown;
      if (seen.at(-1)?.time !== time || seen.at(-1)?.preview !== preview) seen.push({ time, preview });
      if ((window as { seen?: unknown }).seen === seen) requestAnimationFrame(look);
    };
    Object.assign(window, { seen });
    look();
  });
  const box = (await app.by('timeline').locator('.track').boundingBox())!;
  const y = box.y + box.height / 2 - 22;
  const x = (t: number): number => box.x + (box.width * (t + 0.4)) / 1.8;
  await app.page.mouse.move(x(from), y);
  await app.page.mouse.down();
  for (let k = 0; k <= 32; k += 1) await app.page.mouse.move(x(from + (to - from) * (1 - Math.abs(k / 16 - 1))), y);
  await app.page.mouse.up();
  await app.settled();
  const seen = await app.page.evaluate(
    () => (window as unknown as { seen: { time: number; preview: boolean }[] }).seen,
  );
  const end = (await app.state()).doc.keys.at(-1)!.time;
  return seen.filter(({ time }) => time / end > from && time / end < to);
}

test('a moving shape is a preview only where that was measured to be close', async ({ app }) => {
  await app.open({ search: '?moving=close' });
  await openRolledUp(app);
  // Measured while nothing moves, from the moment on the screen outwards: where the later stretch is known, so is the
  // earlier one.
  await expect(async () => {
    await app.setTime(0.5);
    await app.page.waitForTimeout(1000);
    expect((await drag(app, 0.55, 0.95)).some(({ preview }) => preview)).toBe(true);
  }).toPass({ timeout: 60_000 });

  const far = await drag(app, 0.05, 0.45);
  expect(new Set(far.map(({ time }) => time)).size).toBeGreaterThan(3);
  expect(far.filter(({ preview }) => preview)).toEqual([]);
  expect((await drag(app, 0.55, 0.95)).some(({ preview }) => preview)).toBe(true);
  expect(await shown(app)).toEqual({ time: (await app.state()).time, preview: false });
  expect(await distanceAtRest(app)).toBe(0);
  await app.expectNoProblems();
});

test('and always where the address asks for it', async ({ app }) => {
  await app.open({ search: '?moving=preview' });
  await openRolledUp(app);
  await app.setTime(0.5);
  expect((await drag(app, 0.05, 0.45)).some(({ preview }) => preview)).toBe(true);
  await app.expectNoProblems();
});
