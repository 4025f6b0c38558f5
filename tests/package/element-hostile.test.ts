/** The element on difficult pages: changes at any time, unusual places, missing files, old browsers. */
import { readFileSync } from 'node:fs';
import type { CDPSession, Page } from '@playwright/test';
import { expect, inject, it } from 'vitest';
import type { ShapeSplineElement } from '../../web/embed/shape-spline.ts';
import { host } from './support/browser.ts';
import { packageIn } from './support/project.ts';
import {
  KEYS,
  POLICY,
  libraryAddress,
  on,
  openElements,
  picture,
  refused,
  seek,
  told,
  useElements,
  when,
  write,
} from './support/element.ts';

useElements();

const ONE = `<shape-spline id="a" src="${KEYS}" poster="poster.png"></shape-spline>`;
const shown = (words: string, rest = ''): string => `<shape-spline id="a" src="${words}" ${rest}></shape-spline>`;

it.each([
  ['a missing file', 'pose-0.glb gone.glb', 'not-found', 1, /Could not fetch .*gone\.glb \(404 Not Found\)\. Check/],
  ['a web page', 'pose-0.glb page.glb', 'not-a-model', 1, /page\.glb returned a web page instead of a model/],
  ['a GLB of nothing', 'pose-0.glb bad.glb', expect.any(String), 1, /bad\.glb/],
  ['another host', 'http://127.0.0.1:9/a.glb pose-0.glb', 'not-found', 0, /CORS|Could not fetch/],
])('%s is reported in a sentence, and the next source is shown', async (_, src, code, key, words) => {
  write('page.glb', '<!DOCTYPE html><title>Not found</title>');
  write('bad.glb', new Uint8Array([...new TextEncoder().encode('glTF'), 2, 0, 0, 0, 99, 0, 0, 0, 1, 2]));
  const page = await openElements(shown(src));
  const detail = await when(page, 'error');
  expect(detail).toEqual({ code, key, message: expect.stringMatching(words) });
  const message = page.locator('#a [part=message]');
  expect(await message.isVisible()).toBe(true);
  expect(await message.textContent()).toBe(detail!.message);
  expect(await on(page, (shape): Promise<unknown> => shape.seek(0.5).catch((error: Error) => error.message))).toBe(
    detail!.message,
  );
  await on(page, (shape, keys) => (shape.src = keys), KEYS);
  await seek(page, 0.5);
  expect(await message.isVisible()).toBe(false);
});

it('a web page instead of WebAssembly, until the server is repaired', async () => {
  const copy = (name: string): void => write(name, readFileSync(`${packageIn(inject('installed'))}/${name}`));
  for (const name of ['cdn.js', 'codecs.js', 'shapespline_files.wasm', 'draco_decoder_gltf.wasm']) copy(name);
  write('shapespline.wasm', '<!doctype html><title>Home</title>');
  const page = await openElements(`${shown(KEYS)}<script type="module" src="cdn.js"></script>`, { script: 'none' });
  const detail = await when(page, 'error');
  expect(detail).toMatchObject({ code: 'not-loaded', key: -1 });
  expect(detail!.message).toMatch(/shapespline\.wasm returned .*configure\(\{ wasmUrl \}\)/);
  copy('shapespline.wasm');
  await page.locator('#a [part=retry]').click();
  await when(page, 'load');
  expect(await page.locator('#a [part=message]').isVisible()).toBe(false);
});

const LACKING: [what: string, before: () => void, policy: string, code: string, words: RegExp][] = [
  [
    'without WebGL 2',
    () => {
      HTMLCanvasElement.prototype.getContext = ((get) =>
        function (this: HTMLCanvasElement, kind: string, ...more: unknown[]) {
          return kind.startsWith('webgl') ? null : get.call(this, kind as '2d', ...(more as []));
        })(HTMLCanvasElement.prototype.getContext) as never;
    },
    POLICY,
    'no-webgl',
    /^This browser cannot draw the shape: it does not support WebGL 2\.$/,
  ],
  [
    'without WebAssembly',
    () => {
      delete (globalThis as { WebAssembly?: unknown }).WebAssembly;
    },
    POLICY,
    'no-simd',
    /^This browser cannot run the computation/,
  ],
  [
    'whose policy forbids WebAssembly',
    () => undefined,
    POLICY.replace("'wasm-unsafe-eval'", ''),
    'not-loaded',
    /^The page's policy forbids WebAssembly.*'wasm-unsafe-eval'/,
  ],
  [
    'whose policy lets no worker start',
    () => undefined,
    POLICY.replace('blob: LIBRARY;', "'none';"),
    'not-loaded',
    /worker did not start/,
  ],
];

it.each(LACKING)('a page %s reports it', async (_, before, policy, code, words) => {
  const page = await openElements(ONE, { before, policy });
  expect(await when(page, 'error')).toEqual({ code, key: -1, message: expect.stringMatching(words) });
  expect(await page.locator('#a .poster').isVisible()).toBe(true);
});

it('without keys it reports an error, at once for method calls, and shows keys that are set later', async () => {
  const page = await openElements('<shape-spline id="a" controls autoplay></shape-spline>');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const refusal = await on(
    page,
    (shape): Promise<unknown> => shape.evaluate(0).catch((error: { code: string }) => error.code),
  );
  expect(refusal).toBe('no-source');
  // Scripts may set keys slightly later.
  expect(await told(page, 'error')).toEqual([]);
  expect(await when(page, 'error')).toMatchObject({ code: 'no-source', key: -1 });
  const message = page.locator('#a [part=message]');
  await expect.poll(() => message.textContent()).toContain('Nothing to show: set src');
  const away = await page.evaluate(
    (): Promise<unknown> =>
      document
        .createElement('shape-spline')
        .seek(1)
        .catch((error) => error.code),
  );
  expect(away).toBe('not-connected');
  await on(page, (shape) => (shape.src = 'pose-0.glb pose-1.glb'));
  await when(page, 'load');
  expect(await message.isVisible()).toBe(false);
});

it('properties set before the element is defined are used; children can have the times of their keys', async () => {
  const children = '<source src="pose-0.glb" time="1"><source src="pose-1.glb" time="4">';
  const page = await openElements(
    `<shape-spline id="a"></shape-spline><shape-spline id="b">${children}</shape-spline>`,
    { script: 'none' },
  );
  const said: string[] = [];
  page.on('console', (message) => void said.push(message.text()));
  await page.evaluate((keys) => {
    const shape = document.getElementById('a') as ShapeSplineElement;
    Object.assign(shape, { src: keys, controls: true, currentTime: 0.5, keyTimes: [0, 2] });
    // Later errors are reported, and the rest is shown.
    Object.assign(document.getElementById('b')!, { currentTime: NaN });
  }, KEYS);
  await page.addScriptTag({ url: `${libraryAddress()}cdn.js`, type: 'module' });
  expect(await when(page, 'load', 'a')).toMatchObject({ keyTimes: [0, 2] });
  expect(await on(page, (shape) => [shape.controls, shape.currentTime])).toEqual([true, 0.5]);
  expect(await when(page, 'load', 'b')).toMatchObject({ keyTimes: [1, 4] });
  expect(await on(page, (shape) => [shape.currentTime, shape.duration], null, 'b')).toEqual([1, 3]);
  expect(said.filter((text) => text.startsWith('<shape-spline>'))).toEqual([
    '<shape-spline>: currentTime must be a finite number.',
  ]);
  await page.evaluate(() => document.querySelector('#b source:last-child')!.setAttribute('time', '3'));
  expect(await when(page, 'load', 'b', 2)).toMatchObject({ keyTimes: [1, 3] });
});

/** Unused objects are disposed of after a delay. */
const fewWorkers = (page: Page): Promise<void> =>
  expect.poll(() => page.workers().length, { timeout: 30_000 }).toBeLessThanOrEqual(3);

it('twenty elements on a page share their content and one renderer', async () => {
  const many = Array.from(
    { length: 20 },
    (_, i) => `<shape-spline id="n${i}" src="${KEYS}" loading="eager"></shape-spline>`,
  );
  const page = await openElements(many.join(''));
  for (let i = 0; i < 20; i += 1) await when(page, 'load', `n${i}`);
  expect(await page.evaluate(() => window.contexts.length)).toBe(1);
  // All elements share two workers: one for the keys and one for the motion.
  await fewWorkers(page);
});

it('quick changes of attributes give one motion, with the last values', async () => {
  const page = await openElements(shown(KEYS));
  await on(page, async (shape) => {
    for (let i = 0; i < 30; i += 1) {
      shape.boundary = i % 2 === 0 ? 'hermite' : 'periodic';
      shape.stretch = i % 3 === 0 ? 'linear' : shape.stretch;
      if (i % 5 === 0) await new Promise((later) => setTimeout(later, 7));
    }
    shape.removeAttribute('stretch');
    shape.boundary = 'natural';
    await shape.seek(0.3);
  });
  const quick = await picture(page);
  const calm = await openElements(shown(KEYS));
  await seek(calm, 0.3);
  expect(await picture(calm)).toBe(quick);
  expect(await told(page, 'error')).toEqual([]);
  await fewWorkers(page);
});

it('another src, removal and a seek while the first src is loaded', async () => {
  const page = await openElements('<div id="place"></div>');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const outcome = await page.evaluate(async (keys) => {
    const place = document.getElementById('place')!;
    const shape = document.createElement('shape-spline');
    shape.id = 'a';
    shape.src = 'gone.glb';
    place.append(shape);
    const early = shape.seek(0.25);
    shape.src = keys;
    await early;
    const t = shape.currentTime;
    const other = document.createElement('shape-spline');
    other.src = `${keys}?2`;
    place.append(other);
    const late = other.seek(1).then(
      () => 'drawn',
      (error: { code: string }) => error.code,
    );
    await new Promise((later) => setTimeout(later, 20));
    other.remove();
    return { t, late: await late };
  }, KEYS);
  expect(outcome.t).toBe(0.25);
  expect(['not-connected', 'drawn']).toContain(outcome.late);
  expect(await told(page, 'error')).toEqual([]);
});

it('a seek settles if the element is removed at any time before its first shape', async () => {
  const page = await openElements('<div id="place"></div>');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const outcomes = await page.evaluate(async (keys) => {
    const removed = async (_: unknown, i: number): Promise<string> => {
      const shape = document.createElement('shape-spline');
      shape.src = `${keys}?${i % 2}`;
      document.getElementById('place')!.append(shape);
      const sought = shape.seek(0.5).then(
        () => 'drawn',
        (error: { code: string }) => error.code,
      );
      await new Promise((later) => setTimeout(later, 60 * i));
      shape.remove();
      return Promise.race([sought, new Promise<string>((late) => setTimeout(late, 10_000, `open after ${60 * i} ms`))]);
    };
    return Promise.all(Array.from({ length: 24 }, removed));
  }, KEYS);
  for (const outcome of outcomes) expect(['not-connected', 'drawn']).toContain(outcome);
});

it('keeps its state when moved in the document, and starts again after a while outside', async () => {
  const page = await openElements(`<div id="first">${shown(KEYS, 'controls')}</div><div id="second"></div>`);
  await when(page, 'load');
  await seek(page, 0.5);
  const before = await picture(page);
  await page.evaluate(() => document.getElementById('second')!.append(document.getElementById('a')!));
  await page.waitForTimeout(900);
  expect(await told(page, 'load')).toHaveLength(1);
  expect(await picture(page)).toBe(before);
  await page.evaluate(async () => {
    const shape = document.getElementById('a')!;
    shape.remove();
    await new Promise((later) => setTimeout(later, 2000));
    document.getElementById('first')!.append(shape);
  });
  await when(page, 'load', 'a', 2);
  expect(await on(page, (shape) => shape.currentTime)).toBe(0.5);
  expect(await picture(page)).toBe(before);
});

it('works in a frame, in a shadow root, in a dialog, without a size and with a new one', async () => {
  write('frame.html', '<!doctype html><title>A frame</title><body>');
  const page = await openElements(
    `${shown(KEYS)}<iframe id="frame" src="frame.html" width="400" height="300"></iframe>`,
  );
  await when(page, 'load');
  await seek(page, 0.5);
  const outcome = await page.evaluate(async (keys) => {
    const shape = document.getElementById('a') as ShapeSplineElement;
    const pixels = (one: ShapeSplineElement): number => one.shadowRoot!.querySelector('canvas')!.width;
    /** The element is drawn in its new place at its new size. */
    const drawn = async (t: number, done: () => boolean): Promise<void> => {
      for (let i = 0; i < 300 && !done(); i += 1) {
        await new Promise((later) => setTimeout(later, 100));
        await shape.seek(t);
      }
    };
    const styles = (one: ShapeSplineElement): number => one.shadowRoot!.adoptedStyleSheets.length;
    (document.getElementById('frame') as HTMLIFrameElement).contentDocument!.body.append(shape);
    await drawn(0.75, () => pixels(shape) !== 600);
    const framed = [styles(shape), pixels(shape), getComputedStyle(shape).display];
    document.body.append(shape);
    await drawn(0.75, () => pixels(shape) === 600);
    const back = [styles(shape), pixels(shape)];
    shape.style.display = 'none';
    await shape.seek(0.1);
    shape.style.display = '';
    shape.style.width = '240px';
    await drawn(0.2, () => pixels(shape) === 240);
    const resized = pixels(shape);
    Object.assign(shape.style, { width: '0px', height: '0px', minHeight: '0px' });
    await shape.seek(0.3);
    const root = document.body.appendChild(document.createElement('div')).attachShadow({ mode: 'closed' });
    const dialog = document.body.appendChild(document.createElement('dialog'));
    const inside = [root, dialog].map((place) => {
      const one = document.createElement('shape-spline');
      one.src = keys;
      one.style.width = '200px';
      place.append(one);
      return one;
    });
    const closed = inside[1]!.stats.framesComputed;
    dialog.showModal();
    await Promise.all(inside.map((one) => one.seek(0.5)));
    return { framed, back, resized, closed, inside: inside.map(pixels), t: shape.currentTime };
  }, KEYS);
  expect(outcome).toEqual({
    framed: [1, expect.any(Number), 'block'],
    back: [1, 600],
    resized: 240,
    closed: 0,
    inside: [200, 200],
    t: 0.3,
  });
  expect(outcome.framed[1]).toBeGreaterThan(300);
  expect(await told(page, 'error')).toEqual([]);
});

it('a second copy of the script changes nothing and gives a warning', async () => {
  const other = await host([packageIn(inject('installed'))], {
    name: '127.0.0.1',
    headers: { 'access-control-allow-origin': '*' },
  });
  const said: string[] = [];
  const page = await openElements(shown(KEYS), {
    policy: POLICY.replaceAll('LIBRARY', `LIBRARY ${new URL(other).origin}`),
  });
  page.on('console', (message) => {
    if (message.text().startsWith('<shape-spline>')) said.push(message.text());
  });
  await when(page, 'load');
  await page.addScriptTag({ url: `${other}cdn.js`, type: 'module' });
  await expect
    .poll(() => said, { timeout: 30_000 })
    .toEqual(['<shape-spline> is already registered by another copy of shapespline; this copy is not used.']);
  await seek(page, 0.5);
});

/** Adds enumerable methods to arrays, and replaces built-in ones, as Prototype 1.6 does. */
function asPrototype(): void {
  const arrays = Array.prototype as unknown as Record<string, unknown> & { toArray(): unknown[] };
  const stringify = JSON.stringify;
  Object.assign(arrays, {
    each: Array.prototype.forEach,
    toArray: function (this: unknown[]) {
      return this.slice(0);
    },
    toJSON: function (this: unknown[]) {
      return `[${this.map((item) => stringify(item)).join(', ')}]`;
    },
    find: function (this: unknown[], matches: (item: unknown, index: number) => boolean) {
      for (let i = 0; i < this.length; i += 1) if (matches(this[i], i)) return this[i];
      return undefined;
    },
  });
  Object.assign(arrays, { entries: arrays.toArray, size: () => 0, first: () => undefined, inspect: () => '' });
  Array.from = ((list: { length?: number; [index: number]: unknown }) => {
    if ('toArray' in Object(list)) return (list as { toArray?: () => unknown[] }).toArray!();
    const copy: unknown[] = new Array(list.length || 0);
    for (let i = 0; i < copy.length; i += 1) copy[i] = list[i];
    return copy;
  }) as never;
  Function.prototype.bind = function (this: (...given: unknown[]) => unknown, context: unknown, ...first: unknown[]) {
    return (...given: unknown[]) => this.apply(context, [...first, ...given]);
  } as never;
}

/** As MooTools 1.4 does. */
function asMooTools(): void {
  Array.from = ((item: unknown) => (Array.isArray(item) ? item : item === null ? [] : [item])) as never;
  for (const name of ['clean', 'invoke', 'associate', 'link', 'append', 'getLast', 'combine', 'erase', 'pick'])
    Object.assign(Array.prototype, { [name]: () => 'a method of MooTools' });
  Object.assign(Function.prototype, { extend: () => null, implement: () => null, pass: () => null });
  Object.assign(Element.prototype, { set: () => null, get: () => null, getElements: () => [] });
  Object.assign(globalThis, { Event: class DomEvent {}, Request: class {} });
}

/** The JSON of the GLB that the element exports. */
async function exportedOn(before?: () => void): Promise<{ animations: unknown[] }> {
  const page = await openElements(shown(KEYS, 'compare="linear lengths" controls ghost colour="patches"'), { before });
  await when(page, 'load');
  await seek(page, 0.5);
  expect(await page.locator('#a [part=name]').count()).toBe(3);
  expect(await page.locator('#a [part=key]').count()).toBe(2);
  const text = await on(page, async (shape) => {
    const bytes = await (await shape.exportGLB()).arrayBuffer();
    return new TextDecoder().decode(new Uint8Array(bytes, 20, new DataView(bytes).getUint32(12, true)));
  });
  return JSON.parse(text) as { animations: unknown[] };
}

it('shows, compares and exports the same on pages with Prototype or MooTools', async () => {
  const usual = await exportedOn();
  expect(usual.animations).toHaveLength(1);
  expect(await exportedOn(asPrototype)).toEqual(usual);
  expect(await exportedOn(asMooTools)).toEqual(usual);
});

it('a lost graphics context shows the poster, and the shape again when it is back', async () => {
  const page = await openElements(ONE);
  await when(page, 'load');
  await seek(page, 0.5);
  const before = await picture(page);
  const poster = page.locator('#a .poster');
  expect(await poster.isVisible()).toBe(false);
  await page.evaluate(() => {
    const [context] = window.contexts;
    Object.assign(window, { lost: context!.getExtension('WEBGL_lose_context') });
    (window as never as { lost: WEBGL_lose_context }).lost.loseContext();
  });
  await poster.waitFor({ state: 'visible' });
  await page.evaluate(() => (window as never as { lost: WEBGL_lose_context }).lost.restoreContext());
  await poster.waitFor({ state: 'hidden' });
  await seek(page, 0.7);
  expect(await picture(page)).not.toBe(before);
  await seek(page, 0.5);
  expect(await picture(page)).toBe(before);
  expect(await refused(page)).toEqual([]);
});

/** The browser's own records about a page. */
const NOTED =
  /^(Performance|LayoutShift|DOMRect|ScriptTiming|TaskAttribution|CSSNumeric|CSSUnit|blink::|system \/|CppGC)/;

const ELEMENTS = 80;
/** Bytes that the elements may leave. Measured: 72 for 200 elements, and 323 for each element that leaks a geometry. */
const MAX_KEPT = 10_000;

interface Heap {
  /** Numbers of objects created by scripts or pages, by kind and class. */
  counts: Map<string, number>;
  /** Memory used by scripts, without compiled code. */
  bytes: number;
}

/** Remaining objects after garbage collection. */
async function heapOf(client: CDPSession): Promise<Heap> {
  const chunks: string[] = [];
  const take = ({ chunk }: { chunk: string }): void => void chunks.push(chunk);
  client.on('HeapProfiler.addHeapSnapshotChunk', take);
  for (let i = 0; i < 3; i += 1) await client.send('HeapProfiler.collectGarbage');
  await client.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  client.off('HeapProfiler.addHeapSnapshotChunk', take);
  const { snapshot, nodes, strings } = JSON.parse(chunks.join('')) as {
    snapshot: { meta: { node_fields: string[]; node_types: [string[]] } };
    nodes: number[];
    strings: string[];
  };
  const { node_fields: fields, node_types: types } = snapshot.meta;
  const [typeAt, nameAt, sizeAt] = ['type', 'name', 'self_size'].map((field) => fields.indexOf(field));
  const heap: Heap = { counts: new Map(), bytes: 0 };
  for (let i = 0; i < nodes.length; i += fields.length) {
    const type = types[0][nodes[i + typeAt!]!]!;
    const name = strings[nodes[i + nameAt!]!]!;
    if (['object', 'closure', 'array', 'string', 'number'].includes(type) || name === 'system / JSArrayBufferData')
      heap.bytes += nodes[i + sizeAt!]!;
    if (!['object', 'closure', 'native'].includes(type) || NOTED.test(name)) continue;
    const kind = `${type} ${name.slice(0, 60)}`;
    heap.counts.set(kind, (heap.counts.get(kind) ?? 0) + 1);
  }
  return heap;
}

it('many elements leave no memory behind after removal', { timeout: 600_000 }, async () => {
  const page = await openElements('');
  await page.waitForFunction(() => customElements.get('shape-spline'));
  const client = await page.context().newCDPSession(page);
  const comeAndGo = (times: number): Promise<void> =>
    page.evaluate(
      async ([keys, count]) => {
        for (let i = 0; i < (count as number); i += 1) {
          const shape = document.createElement('shape-spline');
          Object.assign(shape, { src: keys, controls: true, currentTime: i / (count as number) });
          document.body.append(shape);
          await shape.seek(i / (count as number));
          shape.remove();
        }
        // Records of the test and the browser per element.
        window.told.length = 0;
        performance.clearResourceTimings();
      },
      [KEYS, times] as const,
    );
  /** The heap once the last content is disposed of. */
  const kept = async (): Promise<Heap> => {
    await expect.poll(() => page.workers().length, { timeout: 60_000 }).toBeLessThanOrEqual(idle);
    return heapOf(client);
  };
  // The engine keeps one worker for the next import.
  await comeAndGo(20);
  await page.waitForTimeout(2500);
  const idle = page.workers().length;
  const before = await kept();
  await comeAndGo(ELEMENTS);
  await page.waitForTimeout(2500);
  const grown = async (): Promise<string[]> => {
    const after = await kept();
    const more = [...after.counts].map(([kind, n]) => [kind, n - (before.counts.get(kind) ?? 0)] as const);
    const bytes = after.bytes - before.bytes;
    return [
      // A leak in every second element would be detected.
      ...more.filter(([, n]) => n >= ELEMENTS / 2).map(([kind, n]) => `${n} ${kind}`),
      ...(bytes >= MAX_KEPT ? [`${bytes} bytes`] : []),
    ];
  };
  await expect.poll(grown, { timeout: 60_000, interval: 2000 }).toEqual([]);
});
