/**
 * Warnings with their text and location, and full turns of parts. The test adds the engine's warnings to its answers.
 */
import type { Locator, Page } from '@playwright/test';
import type { Warning } from '../../web/engine/api/types.ts';
import { changedShare, matching } from './png.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

test.use({ sharpness: 1 });

const LONG =
  'Neighbouring parts rotate by over 150 degrees against each other. Add a key in between if they go the wrong way.';
const WARNINGS: Warning[] = [
  {
    code: 'ambiguous-component-turn',
    message: LONG,
    count: 2,
    key: 1,
    face: 40,
    patches: Array.from({ length: 40 }, (_, patch) => patch),
  },
  { code: 'mirrored-pose', message: 'Key 3 is mirrored.', count: 0, key: 2, face: -1, patches: [] },
  {
    code: 'winding',
    message: 'Some parts turn on by a whole turn in each period.',
    count: 0,
    key: -1,
    face: -1,
    patches: [],
  },
];

/** Adds to the workers' replies before the page receives them. */
async function withChangedResults(
  page: Page,
  change: { warnings?: Warning[]; indefiniteFaces?: number; indefiniteFace?: number },
): Promise<void> {
  await page.addInitScript(({ warnings, indefiniteFaces, indefiniteFace }) => {
    const Original = window.Worker;
    window.Worker = class extends Original {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        this.addEventListener('message', ({ data }: MessageEvent<{ value?: Record<string, unknown> }>) => {
          const { value } = data;
          if (!value) return;
          if (warnings && 'range' in value) value['warnings'] = structuredClone(warnings);
          if (indefiniteFaces !== undefined && 'indefiniteFaces' in value)
            Object.assign(value, { indefiniteFaces, indefiniteFace });
        });
      }
    };
  }, change);
}

/** Share of the image in the mark's colour. */
async function markedShare(app: App): Promise<number> {
  return matching(await app.picture(), ([r, g, b]) => r - g > 60 && b - g > 25).share;
}

/** A share above that of the colour sample on a button. */
const SEEN = 0.0006;

async function expectWithin(inner: Locator, outer: Locator): Promise<void> {
  const [a, b] = [(await inner.boundingBox())!, (await outer.boundingBox())!];
  expect(a.x).toBeGreaterThanOrEqual(b.x);
  expect(a.x + a.width).toBeLessThanOrEqual(b.x + b.width + 0.5);
}

test.describe('with changed replies of the workers', () => {
  // The test changes the workers while the page is loaded.
  test.use({ fresh: true });

  test('warnings can be read at 360 px', async ({ app }) => {
    await app.page.setViewportSize({ width: 360, height: 740 });
    await withChangedResults(app.page, { warnings: WARNINGS });
    await app.open();
    await expect(app.by('warning-count')).toHaveText('3 warnings');
    await app.by('warning-count').click();
    const panel = app.by('warnings');
    await expect(panel.getByRole('heading')).toBeInViewport();
    const sentence = panel.getByText(LONG);
    await expect(sentence).toBeInViewport();
    await expect(sentence).toHaveText(LONG);
    await expect(panel.getByText('Key 3 is mirrored.')).toHaveText('Key 3 is mirrored.');
    await expectWithin(sentence, panel);
    expect(await panel.evaluate((element) => element.scrollWidth <= element.clientWidth)).toBe(true);
    await app.expectNoProblems();
  });

  test('a warning marks its location and shows its time, until the user does something else', async ({ app }) => {
    await withChangedResults(app.page, { warnings: WARNINGS });
    await app.open();
    const { keys } = (await app.state()).doc;
    await app.by('warning-count').click();
    expect(await markedShare(app)).toBeLessThan(SEEN);

    const show = app.by('warning-0-show');
    await show.click();
    await expect(show).toHaveAttribute('aria-pressed', 'true');
    await app.settled();
    expect((await app.state()).time).toBeCloseTo((keys[0]!.time + keys[1]!.time) / 2, 9);
    await expect.poll(() => markedShare(app)).toBeGreaterThan(SEEN);

    // A warning without a location removes the mark.
    await app.by('warning-1-show').click();
    await expect(show).toHaveAttribute('aria-pressed', 'false');
    await app.settled();
    expect((await app.state()).time).toBe(keys[2]!.time);
    expect(await markedShare(app)).toBeLessThan(SEEN);
    await expect(app.by('warning-2-show')).toHaveCount(0);

    await show.click();
    await app.by('boundary-hermite').check();
    await app.settled();
    await expect(app.by('warning-0-show')).toHaveAttribute('aria-pressed', 'false');

    await app.by('warning-0-show').click();
    await expect.poll(() => markedShare(app)).toBeGreaterThan(SEEN);
    await app.by('warnings').press('Escape');
    await expect(app.by('warnings')).toBeHidden();
    await expect(app.by('warning-count')).toBeFocused();
    expect(await markedShare(app)).toBeLessThan(SEEN);
    await app.expectNoProblems();
  });

  test('inverted faces are reported once, when visible, and shown', async ({ app }) => {
    await withChangedResults(app.page, { indefiniteFaces: 200, indefiniteFace: 40 });
    await app.open();
    await app.setTime(0.25);
    await expect(app.by('lost')).toContainText(/^\d+\s% of the faces fold over here\.Show/);
    await expect(app.page.getByText('fold over')).toHaveCount(1);
    const before = await app.picture();
    await app.by('lost-show').click();
    // Faintly, where the shape hides the mark.
    await expect.poll(async () => changedShare(before, await app.picture())).toBeGreaterThan(0.0003);
    await app.setTime(1.2);
    await expect(app.by('lost')).toContainText('this far from the keys');
    await app.expectNoProblems();
  });

  test('are not reported for one in ten thousand', { tag: '@all' }, async ({ app }) => {
    await withChangedResults(app.page, { indefiniteFaces: 1, indefiniteFace: 40 });
    await app.open();
    await app.setTime(0.25);
    await expect(app.by('phase')).toBeVisible();
    await expect(app.by('lost')).toBeHidden();
  });
});

/** Two bars, rotated by `turn` radians about their own axes. */
function bars(turn: number): Buffer {
  const lines: string[] = [];
  for (const x of [-1, 1]) {
    for (let ring = 0; ring <= 6; ring += 1) {
      for (let corner = 0; corner < 6; corner += 1) {
        const angle = (corner * Math.PI) / 3 + (x > 0 ? (turn * ring) / 6 : 0);
        lines.push(`v ${x + 0.4 * Math.cos(angle)} ${ring / 2} ${0.4 * Math.sin(angle)}`);
      }
    }
  }
  for (const base of [1, 43]) {
    for (let ring = 0; ring < 6; ring += 1) {
      for (let corner = 0; corner < 6; corner += 1) {
        const [a, b] = [base + 6 * ring + corner, base + 6 * ring + ((corner + 1) % 6)];
        lines.push(`f ${a} ${a + 6} ${b + 6}`, `f ${a} ${b + 6} ${b}`);
      }
    }
  }
  return Buffer.from(lines.join('\n'));
}

test('full turns are added to the shape or to a part, which is marked, and can be undone', async ({ app }) => {
  const turns = async () => (await app.state()).doc.keys.map(({ shaping }) => shaping.turns);
  await app.open();
  await app.by('key-0-edit').click();
  await expect(app.by('key-turns')).toBeHidden();
  await app.by('key-editor-close').click();
  await app.by('key-1-edit').click();
  await expect(app.by('key-turns')).toBeVisible();
  await expect(app.by('key-turns-component')).toBeHidden();
  await app.by('key-editor-close').click();

  const poses = [0, 0.5, 1].map((turn, index) => ({
    name: `bars-${index}.obj`,
    mimeType: 'text/plain',
    buffer: bars(turn),
  }));
  await app.by('file-input').setInputFiles(poses);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  await app.by('key-1-edit').click();
  const part = app.by('key-turns-component');
  await expect(part.locator('option')).toHaveText(['Whole shape', 'Component 1', 'Component 2']);
  await part.selectOption('Component 2');
  await expect.poll(() => markedShare(app)).toBeGreaterThan(SEEN);
  await app.by('key-turns').fill('1');
  await app.by('key-turns').press('Enter');
  await app.settled();
  expect(await turns()).toEqual([[], [{ component: 1, turns: 1 }], []]);
  await expect(part.locator('option')).toHaveText(['Whole shape', 'Component 1', 'Component 2: +1']);
  await part.selectOption('Whole shape');
  await expect(app.by('key-turns')).toHaveValue('0');
  expect(await markedShare(app)).toBeLessThan(SEEN);

  await app.page.keyboard.press('Escape');
  await app.page.keyboard.press('Control+z');
  await app.settled();
  expect((await turns()).flat()).toEqual([]);
  // Not every method supports added turns.
  await app.by('method').selectOption('rimd');
  await app.settled();
  await app.by('key-1-edit').click();
  await expect(app.by('key-name')).toBeVisible();
  await expect(app.by('key-turns')).toBeHidden();
  await app.expectNoProblems();
});
