/** The element on a page: drawing, laziness, events, methods, keys, and styling. */
import { expect, it } from 'vitest';
import { embedSnippet } from '../../web/app/export/embed-snippet.ts';
import { PROPERTIES, ROWS, attributeOf } from '../../web/embed/attributes.ts';
import { customElementsManifest } from '../../web/embed/manifest.ts';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';
import { METHODS } from '../../web/engine/api/methods.ts';
import type { SequenceOptions } from '../../web/engine/api/types.ts';
import { withEngine } from '../../web/engine/node.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { samples } from '../element-samples.ts';
import { bar, bent } from '../engine/support/shapes.ts';
import {
  KEYS,
  libraryAddress,
  on,
  openElements,
  picture,
  refused,
  seek,
  statsAtRest,
  told,
  useElements,
  when,
  write,
} from './support/element.ts';

useElements();

const ONE = `<shape-spline id="a" src="${KEYS}" alt="A bar that bends"></shape-spline>`;
const CALM = { reducedMotion: 'reduce' } as const;

it('two of them from another host under a strict policy; a seek resolves when its shape is drawn', async () => {
  const page = await openElements(`${ONE}<shape-spline id="b" src="pose-1.glb pose-0.glb" controls></shape-spline>`);
  await Promise.all([when(page, 'load', 'a'), when(page, 'load', 'b')]);
  await seek(page, 0);
  const first = await picture(page);
  await seek(page, 0.8);
  expect(await picture(page)).not.toBe(first);
  await seek(page, 0);
  expect(await picture(page)).toBe(first);
  await seek(page, 2.5);
  expect(await on(page, (shape) => shape.currentTime)).toBe(2.5);
  expect(await refused(page)).toEqual([]);
  expect(await page.evaluate(() => window.contexts.length)).toBe(1);
  expect(await page.evaluate(() => document.querySelectorAll('style, [style]').length)).toBe(0);
});

it('fetches nothing until it is near the view, and neither computes nor draws out of view', async () => {
  const far = `<shape-spline id="b" src="pose-0.glb?far pose-1.glb?far"></shape-spline>`;
  const eager = `<shape-spline id="c" src="pose-0.glb?eager pose-1.glb?eager" loading="eager"></shape-spline>`;
  const playing = `<shape-spline id="a" src="${KEYS}" autoplay loop></shape-spline>`;
  const page = await openElements(`${playing}<i id="gap"></i>${far}${eager}`);
  await when(page, 'load', 'c');
  const asked = (word: string): Promise<number> =>
    page.evaluate(
      (end) => performance.getEntriesByType('resource').filter((one) => one.name.endsWith(end)).length,
      word,
    );
  expect(await asked('?eager')).toBe(2);
  expect(await asked('?far')).toBe(0);
  await page.waitForFunction(() => (document.getElementById('a') as ShapeSplineElement).stats.framesDrawn > 3);
  await page.evaluate(() => scrollTo(0, 2000));
  const before = (await statsAtRest(page)) as ShapeSplineElement['stats'];
  await page.waitForTimeout(700);
  expect(await statsAtRest(page)).toEqual(before);
  await page.evaluate(() => scrollTo(0, 5000));
  await when(page, 'load', 'b');
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForFunction(
    (n) => (document.getElementById('a') as ShapeSplineElement).stats.framesDrawn > n + 3,
    before.framesDrawn,
  );
});

it('loads out of view as soon as `loading` is set to "eager", also after changes', async () => {
  const page = await openElements(`<i id="gap"></i><shape-spline id="a" src="${KEYS}"></shape-spline>`);
  await on(page, (shape) => new Promise((done) => setTimeout(done, 300, shape)));
  expect(await on(page, (shape) => (shape.loading = 'eager'))).toBe('eager');
  await when(page, 'load');
  // Lazy again: another source waits until it is eager.
  await on(page, async (shape) => {
    shape.loading = 'lazy';
    await null;
    shape.src = 'pose-1.glb pose-0.glb';
    await new Promise((done) => setTimeout(done, 300));
  });
  expect(await told(page, 'load')).toHaveLength(1);
  await on(page, (shape) => shape.setAttribute('loading', 'eager'));
  await when(page, 'load', 'a', 2);
  await on(page, (shape, keys) => (shape.src = keys), KEYS);
  await when(page, 'load', 'a', 3);
  await on(page, (shape) => (shape.controls = true));
  expect(await told(page, 'load')).toHaveLength(3);
});

it('reports loading, playing, seeking and keys, each with its detail, and lets no event bubble', async () => {
  const page = await openElements(ONE);
  expect(await when(page, 'load')).toEqual({
    vertices: expect.any(Number),
    faces: expect.any(Number),
    keyTimes: [0, 1],
  });
  const progress = (await told(page, 'progress')) as { stage: string; fraction: number }[];
  const shares = progress.map(({ fraction }) => fraction);
  expect(shares).toEqual([...shares].sort((a, b) => a - b));
  expect(shares.at(-1)).toBe(1);
  expect(progress.every(({ stage }) => stage.length > 0)).toBe(true);
  expect(await told(page, 'pause')).toEqual([]);
  await seek(page, 0.5);
  expect(await told(page, 'seeked')).toEqual([{ currentTime: 0.5 }]);
  expect((await told(page, 'timeupdate')).at(-1)).toEqual({ currentTime: 0.5 });
  expect((await told(page, 'keychange')).at(-1)).toEqual({ index: 0 });
  await on(page, (shape) => {
    shape.playbackRate = 4;
    shape.play();
  });
  expect(await when(page, 'play')).toBeNull();
  expect(await when(page, 'loopend')).toEqual({ currentTime: 1 });
  expect(await when(page, 'pause')).toBeNull();
  // The last shape is drawn slightly later.
  await expect.poll(() => told(page, 'keychange'), { timeout: 30_000 }).toContainEqual({ index: 1 });
  expect(await on(page, (shape) => ({ paused: shape.paused, duration: shape.duration }))).toEqual({
    paused: true,
    duration: 1,
  });
  await on(page, (shape) => {
    shape.loop = 'bounce';
    shape.play();
  });
  await when(page, 'loopend', 'a', 3);
  expect(await page.evaluate(() => window.told.filter(({ bubbles }) => bubbles))).toEqual([]);
});

it('returns shapes, images and files', async () => {
  const page = await openElements(ONE);
  const got = await on(page, async (shape) => {
    const frame = await shape.evaluate(0.5);
    const vertices = frame.positions.length / 3;
    const [png, webp] = [await shape.toBlob(), await shape.toBlob({ type: 'image/webp', quality: 0.5 })];
    const unknown = await shape.toBlob({ type: 'image/x-none' }).catch((error: Error) => error.message);
    const glb = await shape.exportGLB();
    const magic = new TextDecoder().decode((await glb.arrayBuffer()).slice(0, 4));
    const report = shape.report!.vertices;
    const again: number[] = [];
    // The page's policy forbids evaluating text as code.
    const small = [
      await shape.exportGLB({ compression: 'quantized' }),
      await shape.exportGLB({ compression: 'meshopt' }),
    ];
    for (const file of [glb, ...small]) {
      shape.keys = [file];
      await shape.seek(0.25);
      again.push(shape.report!.vertices);
    }
    return {
      vertices,
      report,
      again,
      sizes: [glb, ...small].map((file) => file.size),
      magic,
      unknown,
      types: [png.type, webp.type, glb.type],
      size: png.size,
    };
  });
  expect(got).toMatchObject({
    magic: 'glTF',
    unknown: 'This browser cannot write image/x-none.',
    types: ['image/png', 'image/webp', 'model/gltf-binary'],
  });
  expect(got.vertices).toBe(got.report);
  expect(got.again).toEqual([got.report, got.report, got.report]);
  expect(got.sizes).toEqual([...got.sizes].sort((a, b) => b - a));
  expect(await refused(page)).toEqual([]);
  expect(got.size).toBeGreaterThan(2000);
});

it('other keys start at their own first time, also during playback', async () => {
  const page = await openElements(`<shape-spline id="a" src="${KEYS}" autoplay loop></shape-spline>`);
  await page.waitForFunction(() => (document.getElementById('a') as ShapeSplineElement).currentTime > 0.2);
  const time = await on(page, async (shape) => {
    shape.pause();
    shape.removeAttribute('autoplay');
    shape.innerHTML = '<source src="pose-1.glb" time="5"><source src="pose-0.glb" time="7">';
    shape.removeAttribute('src');
    await shape.evaluate(6);
    return shape.currentTime;
  });
  expect(time).toBe(5);
});

it('autoplay starts by itself, but not after pause(), and not with reduced motion', async () => {
  const playing = `<shape-spline id="a" src="${KEYS}" autoplay loop controls></shape-spline>`;
  const page = await openElements(playing);
  await when(page, 'play');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await when(page, 'pause');
  expect(await page.locator('#a [part=play]').getAttribute('aria-label')).toBe('Play');
  const paused = await openElements(playing);
  await paused.evaluate(() => (document.getElementById('a') as ShapeSplineElement).pause());
  await seek(paused, 0.5);
  await paused.waitForTimeout(300);
  expect(await on(paused, (shape) => ({ paused: shape.paused, t: shape.currentTime }))).toEqual({
    paused: true,
    t: 0.5,
  });
  expect(await paused.locator('#a [part=play]').getAttribute('aria-label')).toBe('Play');
  const calm = await openElements(playing, CALM);
  await when(calm, 'load');
  await calm.waitForTimeout(300);
  expect(await told(calm, 'play')).toEqual([]);
  await calm.locator('#a [part=play]').click();
  await when(calm, 'play');
});

it('is a labelled region with keyboard control, and an image without controls', async () => {
  const page = await openElements(
    `<shape-spline id="a" src="${KEYS}" controls camera-controls="false" alt="A bar"></shape-spline>` +
      `<shape-spline id="b" src="${KEYS}" alt="A still bar"></shape-spline>`,
    CALM,
  );
  await Promise.all([when(page, 'load', 'a'), when(page, 'load', 'b')]);
  const region = page.getByRole('region', { name: 'A bar' });
  await region.focus();
  const time = (): Promise<number> => on(page, (shape) => shape.currentTime);
  await page.keyboard.press('End');
  expect(await time()).toBe(1);
  await page.keyboard.press('[');
  expect(await time()).toBe(0);
  await page.keyboard.press('ArrowRight');
  const stepped = await time();
  expect(stepped).toBeGreaterThan(0);
  await page.keyboard.press('ArrowLeft');
  expect(await time()).toBeCloseTo(0, 6);
  await page.keyboard.press(' ');
  await when(page, 'play');
  await expect.poll(time, { timeout: 30_000 }).toBeGreaterThan(0.02);
  await page.keyboard.press(' ');
  await when(page, 'pause');
  await page.keyboard.press('Home');
  expect(await time()).toBe(0);
  await page.keyboard.press('Home');
  expect(await time()).toBe(0);
  const slider = page.getByRole('slider', { name: 'Time' }).first();
  // A slider's text is updated with the frame that it describes.
  await expect.poll(() => slider.getAttribute('aria-valuetext'), { timeout: 30_000 }).toMatch(/^0(\.0+)? s, /);
  expect(await page.getByRole('img', { name: 'A still bar' }).count()).toBe(1);
  expect(await page.locator('#b [part=viewport]').getAttribute('tabindex')).toBeNull();
});

it('the poster is shown before the shape, and longer if the page requests it', async () => {
  const page = await openElements(
    `<shape-spline id="a" src="${KEYS}" poster="missing.png" reveal="manual"></shape-spline>` +
      `<shape-spline id="b" src="${KEYS}"><b slot="poster" id="own">Soon</b>A bar</shape-spline>`,
  );
  await Promise.all([when(page, 'load', 'a'), when(page, 'load', 'b')]);
  const shown = (): Promise<boolean> => page.locator('#a .poster').isVisible();
  expect(await shown()).toBe(true);
  expect(await page.locator('#a .poster img').getAttribute('src')).toBe('missing.png');
  await on(page, (shape) => shape.dismissPoster());
  expect(await shown()).toBe(false);
  expect(await page.locator('#own').isVisible()).toBe(false);
  expect(await page.locator('#b .caption').evaluate((caption) => getComputedStyle(caption).position)).toBe('absolute');
});

it('pages can fill its slots and style its parts', async () => {
  const page = await openElements('');
  let answer = (): void => undefined;
  const held = new Promise<void>((resolve) => {
    answer = resolve;
  });
  await page.route('**/pose-1.glb?slow', (route) => held.then(() => route.continue()));
  await page.waitForFunction(() => customElements.get('shape-spline'));
  await page.evaluate((markup) => {
    document.body.innerHTML = markup;
  }, `<shape-spline id="a" src="${KEYS}?slow" controls><button slot="controls" id="own">Go</button>` +
    `<progress slot="progress" id="bar"></progress></shape-spline><shape-spline id="b" src="${KEYS}" controls></shape-spline>`);
  await page.locator('#bar').waitFor({ state: 'visible' });
  answer();
  await Promise.all([when(page, 'load', 'a'), when(page, 'load', 'b')]);
  expect(await page.locator('#own').isVisible()).toBe(true);
  expect(await page.locator('#a [part=play]').isVisible()).toBe(false);
  expect(await page.locator('#bar').isVisible()).toBe(false);
  const parts = await on(
    page,
    (shape) =>
      [...new Set([...shape.shadowRoot!.querySelectorAll('[part]')].map((one) => one.getAttribute('part')))].sort(),
    null,
    'b',
  );
  expect(parts).toEqual(['controls', 'key', 'message', 'play', 'progress', 'thumb', 'timeline', 'viewport']);
  const dressed = await page.evaluate(() => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`shape-spline { --shape-spline-background: rgb(1, 2, 3); --shape-spline-foreground: rgb(4, 5, 6);
      --shape-spline-progress: rgb(7, 8, 9); } ::part(play) { border: 3px solid }`);
    document.adoptedStyleSheets = [sheet];
    const b = document.getElementById('b')!;
    const part = (name: string): CSSStyleDeclaration =>
      getComputedStyle(b.shadowRoot!.querySelector(`[part=${name}]`)!);
    return {
      background: getComputedStyle(b).backgroundColor,
      foreground: part('play').color,
      border: part('play').borderTopWidth,
      progress: part('progress').backgroundColor,
      shape: ((box) => box.width / box.height)(b.getBoundingClientRect()),
    };
  });
  expect(dressed).toEqual({
    background: 'rgb(1, 2, 3)',
    foreground: 'rgb(4, 5, 6)',
    border: '3px',
    progress: 'rgb(7, 8, 9)',
    shape: expect.closeTo(1.5, 3),
  });
});

it('camera, colours, motion and range follow the attributes, and a camera moved by the user stays', async () => {
  const page = await openElements(`<shape-spline id="a" src="${KEYS}" controls></shape-spline>`, CALM);
  await when(page, 'load');
  const look = async (change: (shape: ShapeSplineElement) => void, t = 0.4): Promise<string> => {
    await on(page, change);
    await seek(page, t);
    await on(page, (shape) => shape.toBlob().then(() => undefined));
    return picture(page);
  };
  const plain = await look(() => undefined);
  for (const change of [
    (shape: ShapeSplineElement) => (shape.cameraOrbit = '80deg 40deg 130%'),
    (shape: ShapeSplineElement) => (shape.cameraTarget = '1m 0m 0m'),
    (shape: ShapeSplineElement) => (shape.colour = 'phase'),
    (shape: ShapeSplineElement) => (shape.colour = 'patches'),
    (shape: ShapeSplineElement) => (shape.color = 'phase'),
    (shape: ShapeSplineElement) => (shape.method = 'linear'),
    (shape: ShapeSplineElement) => (shape.compare = ['linear']),
    (shape: ShapeSplineElement) => shape.setAttribute('start-speed', '3') ?? shape.setAttribute('boundary', 'hermite'),
  ]) {
    const changed = await look(change as never);
    expect(changed, String(change)).not.toBe(plain);
    const back = await look((shape) => {
      for (const name of [
        'camera-orbit',
        'camera-target',
        'colour',
        'color',
        'method',
        'compare',
        'start-speed',
        'boundary',
      ])
        shape.removeAttribute(name);
    });
    expect(back, String(change)).toBe(plain);
  }
  await page.locator('#a [part=viewport]').focus();
  await page.keyboard.press('ArrowRight');
  const turned = await look(() => undefined);
  expect(turned).not.toBe(plain);
  expect(await look((shape) => (shape.playbackRate = 2))).toBe(turned);
  await on(page, (shape) => (shape.range = [-0.5, 1.5]));
  await seek(page, 0);
  expect(await on(page, (shape) => shape.duration)).toBe(2);
  expect(await page.locator('#a [part=timeline]').getAttribute('aria-valuemin')).toBe('-0.5');
});

it.each<[string, Partial<SequenceOptions>]>([
  ['hold', { hold: 'on', pins: [{ vertex: 0, radius: 0.1 }], tension: [0, 1, 0], turns: [{ key: 2, turns: 1 }] }],
  ['loop', { boundary: 'periodic' }],
  ['kept', { keepLengths: 1 }],
  ['ghost', { ghostFaces: 60, transfer: 'paper' }],
])('opens what the embed dialog writes for every method beside a project: %s', async (name, options) => {
  const mesh = bar();
  await withEngine(async (engine) => {
    const poses = [0, 60, 0].map((angle, time) => ({ name: `${time}`, time, positions: bent(mesh, angle) }));
    const sequence = await engine.createSequence(await engine.createKeys({ faces: mesh.indices, poses }), options);
    write(`${name}.glb`, (await sequence.export())[0]!.bytes);
  });
  const { doc, view, play } = EMPTY_STATE;
  const state = { ...EMPTY_STATE, doc, play, view: { ...view, compare: [...METHODS] } };
  const snippet = embedSnippet(state, `${name}.glb`, 'A bar bends');
  const page = await openElements(
    snippet.replace('shapespline/', libraryAddress()).replace('<shape-spline', '<shape-spline id="a"'),
    { script: 'none' },
  );
  await page.waitForFunction(() => window.told.some(({ type }) => type === 'load' || type === 'error'));
  expect(await told(page, 'error')).toEqual([]);
  expect(await page.locator('#a [part=name]').allTextContents()).toHaveLength(METHODS.length);
});

it('leaves out what a project sets and the given method lacks, and says so', async () => {
  const mesh = bar();
  await withEngine(async (engine) => {
    const poses = [0, 60, 0].map((angle, time) => ({ name: `${time}`, time, positions: bent(mesh, angle) }));
    const keys = await engine.createKeys({ faces: mesh.indices, poses });
    const sequence = await engine.createSequence(keys, { hold: 'on', pins: [{ vertex: 0, radius: 0.1 }] });
    write('held-bar.glb', (await sequence.export())[0]!.bytes);
  });
  const page = await openElements('<shape-spline id="a" src="held-bar.glb"></shape-spline>');
  const warnings: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'warning') warnings.push(message.text());
  });
  await when(page, 'load');
  await on(page, (shape) => (shape.method = 'rimd'));
  await expect.poll(() => warnings.filter((text) => text.includes('left out'))).toHaveLength(2);
  await seek(page, 0.5);
  expect(await told(page, 'error')).toEqual([]);
});

it('follows changes of the colour scheme', async () => {
  const page = await openElements(ONE, { colorScheme: 'light' });
  await when(page, 'load');
  await seek(page, 0);
  const light = await picture(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await expect.poll(() => picture(page), { timeout: 30_000 }).not.toBe(light);
  await page.emulateMedia({ colorScheme: 'light' });
  await expect.poll(() => picture(page), { timeout: 30_000 }).toBe(light);
});

it('has right-to-left layout on such pages, except for the timeline', async () => {
  const page = await openElements(
    `<div dir="rtl"><shape-spline id="a" src="${KEYS}" controls></shape-spline></div>`,
    CALM,
  );
  await when(page, 'load');
  await seek(page, 1);
  const places = await on(page, (shape) => {
    const left = (part: string): number =>
      shape.shadowRoot!.querySelector(`[part=${part}]`)!.getBoundingClientRect().left;
    return { play: left('play'), timeline: left('timeline'), thumb: left('thumb') };
  });
  expect(places.play).toBeGreaterThan(places.thumb);
  expect(places.thumb).toBeGreaterThan(places.timeline + 100);
  await page.locator('#a [part=timeline]').focus();
  await page.keyboard.press('ArrowLeft');
  expect(await on(page, (shape) => shape.currentTime)).toBeLessThan(1);
});

it('"false" counts as false, and a wrong value is ignored; each is reported once', async () => {
  const said: string[] = [];
  const page = await openElements('', { script: 'first' });
  page.on('console', (message) => {
    if (message.text().startsWith('<shape-spline>')) said.push(message.text());
  });
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const read = await page.evaluate(() => {
    const shape = document.createElement('shape-spline');
    shape.setAttribute('autoplay', 'false');
    shape.setAttribute('boundary', 'round');
    document.body.append(shape);
    return [shape.autoplay, shape.autoplay, shape.boundary, shape.boundary];
  });
  expect(read).toEqual([false, false, 'natural', 'natural']);
  await expect.poll(() => said.length, { timeout: 30_000 }).toBe(2);
  expect(said).toEqual([
    '<shape-spline>: autoplay="false" is "false", which counts as false; omit the attribute instead.',
    '<shape-spline>: boundary="round" must be one of natural, hermite, periodic.',
  ]);
});

it('every attribute and property keeps its value when read back', async () => {
  const page = await openElements('');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const rows = PROPERTIES.flatMap((property) =>
    samples(ROWS[property]).map((value) => ({ property, attribute: attributeOf(property), value })),
  );
  const wrong = await page.evaluate((all) => {
    const make = () => document.createElement('shape-spline') as unknown as HTMLElement & Record<string, unknown>;
    return all.filter(({ property, attribute, value }) => {
      const [by, to] = [make(), make()];
      to[property] = value;
      // The time is a property, not an attribute.
      by.setAttribute(attribute, property === 'currentTime' ? String(value) : (to.getAttribute(attribute) ?? ''));
      return [by, to].some((shape) => JSON.stringify(shape[property]) !== JSON.stringify(value));
    });
  }, rows);
  expect(wrong).toEqual([]);
  // Invalid times are handled as by HTMLMediaElement.
  const times = await page.evaluate(async () => {
    const shape = document.createElement('shape-spline');
    shape.setAttribute('current-time', '3');
    const seen: unknown[] = [];
    for (const value of [NaN, Infinity, 'soon', {}, '0.5', 0.25, undefined, null] as never[])
      try {
        shape.currentTime = value;
        seen.push(shape.currentTime);
      } catch (error) {
        seen.push((error as Error).name);
      }
    seen.push(shape.hasAttribute('current-time'), await shape.seek(NaN).catch((error: Error) => error.name));
    return seen;
  });
  const refusals = Array.from({ length: 4 }, () => 'TypeError');
  expect(times).toEqual([...refusals, 0.5, 0.25, 0.25, 0.25, false, 'RangeError']);
  const { modules } = customElementsManifest() as { modules: { declarations: { members: { name: string }[] }[] }[] };
  const missing = await page.evaluate(
    (names) => names.filter((name) => !(name in document.createElement('shape-spline'))),
    modules[0]!.declarations[0]!.members.map(({ name }) => name),
  );
  expect(missing).toEqual([]);
});
