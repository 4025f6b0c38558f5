/** Effects of the page's style and the user's settings, and the events of a loop. */
import { expect, it } from 'vitest';
import { KEYS, on, openElements, picture, seek, told, useElements, when } from './support/element.ts';

useElements();

const ONE = `<shape-spline id="a" src="${KEYS}" controls alt="A bar that bends"></shape-spline>`;
const CALM = { reducedMotion: 'reduce' } as const;

it('the phase colours are taken from the style when a shape is shown', async () => {
  const page = await openElements(ONE, CALM);
  await when(page, 'load');
  await on(page, (shape) => (shape.colour = 'phase'));
  for (const [kind, t] of [
    ['key', 0],
    ['between', 0.5],
    ['beyond', 1.3],
  ] as const) {
    await seek(page, t);
    const before = await picture(page);
    await on(page, (shape, name) => shape.style.setProperty(name, 'magenta'), `--shape-spline-${kind}`);
    await seek(page, t);
    expect(await picture(page), kind).not.toBe(before);
    await on(page, (shape, name) => shape.style.removeProperty(name), `--shape-spline-${kind}`);
    await seek(page, t);
    expect(await picture(page), kind).toBe(before);
  }
});

it('a loop reports the key and the time at which it ends', async () => {
  const page = await openElements(`<shape-spline id="a" src="${KEYS}" loop playback-rate="2"></shape-spline>`);
  await when(page, 'load');
  await seek(page, 0);
  await on(page, (shape) => {
    shape.range = [0, 1];
    shape.play();
  });
  expect(await when(page, 'loopend', 'a', 2)).toEqual({ currentTime: 1 });
  await on(page, (shape) => shape.pause());
  expect((await told(page, 'keychange')).slice(0, 4)).toEqual([{ index: 0 }, { index: 1 }, { index: 0 }, { index: 1 }]);
});

it('the timeline is visible in forced colours', async () => {
  const page = await openElements(ONE, { ...CALM, forcedColors: 'active' });
  await when(page, 'load');
  const grounds = await on(page, (shape) => {
    const root = shape.shadowRoot!;
    const ground = (part: string, pseudo?: string): string =>
      getComputedStyle(root.querySelector(`[part=${part}]`)!, pseudo).backgroundColor;
    return {
      page: 'rgb(255, 255, 255)',
      key: ground('key'),
      thumb: ground('thumb'),
      track: ground('timeline', '::before'),
    };
  });
  for (const part of ['key', 'thumb', 'track'] as const) expect(grounds[part], part).not.toBe(grounds.page);
});

it('on a zoomed page, the shape is drawn at the resolution of the screen', async () => {
  const page = await openElements(ONE, CALM);
  await when(page, 'load');
  /** Widths in drawn pixels and in page pixels. */
  const across = (): Promise<[number, number]> =>
    on(page, (shape) => [
      shape.shadowRoot!.querySelector('canvas')!.width,
      Math.round(shape.getBoundingClientRect().width),
    ]);
  const zoom = (text: string, width = ''): Promise<void> =>
    on(page, (shape, words) => void Object.assign(shape.style, words), { zoom: text, width });
  for (const [text, width, expected] of [
    ['', '', 600],
    ['2', '', 600],
    // The element has as many page pixels as before, each twice as large.
    ['', '200px', 200],
    ['2', '200px', 400],
    ['0.5', '200px', 100],
    ['', '', 600],
  ] as const) {
    await zoom(text, width);
    await expect.poll(across, { timeout: 30_000 }).toEqual([expected, expected]);
  }
});

it('an invalid URL or file is reported with its key', async () => {
  const page = await openElements('<shape-spline id="a"></shape-spline>');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  await on(page, (shape) => (shape.keys = [5 as never]));
  expect(await when(page, 'error')).toEqual({
    code: 'not-a-model',
    key: 0,
    message: 'Key 1 has an unsupported type. Use a URL, a File or Blob, an ArrayBuffer or a Uint8Array.',
  });
  await on(page, (shape) => {
    shape.keys = null;
    shape.src = 'pose-0.glb http://[bad';
  });
  expect(await when(page, 'error', 'a', 2)).toEqual({
    code: 'not-found',
    key: 1,
    message: '“http://[bad” is not a valid URL. Check the URL of key 2.',
  });
});

it('a single source and the files of an input count as lists', async () => {
  const page = await openElements('<shape-spline id="a"></shape-spline><input type="file" id="files" multiple />');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const shown = await on(page, async (shape) => {
    const seen: unknown[] = [];
    const files = new DataTransfer();
    for (const name of ['pose-0.glb', 'pose-1.glb'])
      files.items.add(new File([await (await fetch(name)).blob()], name));
    const input = document.getElementById('files') as HTMLInputElement;
    input.files = files.files;
    shape.keys = input.files as never;
    await shape.seek(0.5);
    const motion = await shape.exportGLB();
    for (const one of [motion, new Uint8Array(await motion.arrayBuffer()), 'pose-0.glb']) {
      shape.keys = one as never;
      seen.push(
        await shape.seek(0.25).then(
          () => shape.report!.vertices > 100,
          (error: { code: string }) => error.code,
        ),
      );
    }
    shape.keys = {} as never;
    const wrong = await shape.seek(0).catch((error: { code: string }) => error.code);
    return [...seen, wrong];
  });
  // A single pose is no motion.
  expect(shown).toEqual([true, true, 'too-few-keys', 'not-a-model']);
});

it('focus() focuses the shape; a text poster covers it until it is dismissed', async () => {
  const page = await openElements(
    `<shape-spline id="a" src="${KEYS}" controls reveal="manual"><b slot="poster">Soon</b></shape-spline>`,
    CALM,
  );
  await when(page, 'load');
  const inside = await on(page, (shape) => {
    shape.focus();
    return [document.activeElement === shape, shape.shadowRoot!.activeElement?.getAttribute('part')];
  });
  expect(inside).toEqual([true, 'viewport']);
  const ground = await page.locator('#a .poster').evaluate((poster) => getComputedStyle(poster).backgroundColor);
  expect(ground).toMatch(/^rgb\(/);
  await on(page, (shape) => shape.dismissPoster());
  expect(await page.locator('#a .poster').isVisible()).toBe(false);
});

it('a removed element has no report and no duration, and is paused', async () => {
  const page = await openElements(`<shape-spline id="a" src="${KEYS}" loop></shape-spline>`, CALM);
  await when(page, 'load');
  await on(page, (shape) => {
    shape.play();
    Object.assign(window, { left: shape });
    shape.remove();
  });
  const state = (): Promise<unknown> =>
    page.evaluate(() => {
      const shape = (window as never as { left: HTMLElementTagNameMap['shape-spline'] }).left;
      return { report: shape.report, duration: shape.duration, paused: shape.paused };
    });
  await expect.poll(state, { timeout: 30_000 }).toEqual({ report: null, duration: NaN, paused: true });
});
