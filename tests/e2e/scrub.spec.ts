/**
 * A shape that is a preview while it moves, exact when it rests. By itself the page draws so what is too large for 30
 * exact frames a second on the machine at hand (tests/unit/frame-loop); here its address asks for it.
 */
import { expect, test } from './support.ts';
import type { App } from './support.ts';

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

test('a shape is a preview while it plays, and exact when it rests', async ({ app }) => {
  await app.open({ search: '?moving=preview' });
  await app.setTime(0.25);
  expect(await shown(app)).toEqual({ time: 0.25, preview: false });
  await expect(app.by('status-ms')).toHaveText(/ms per frame, exact$/);
  await app.by('play').click();
  await expect.poll(async () => (await shown(app)).preview).toBe(true);
  await expect.poll(async () => (await shown(app)).time).not.toBe(0.25);
  await app.by('play').click();
  await app.settled();
  expect(await shown(app)).toEqual({ time: (await app.state()).time, preview: false });
  expect(await distanceAtRest(app)).toBe(0);
  await app.expectNoProblems();
});
