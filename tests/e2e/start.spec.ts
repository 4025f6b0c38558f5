/** The first visit loads only what the first image needs before it is shown. */
import { poseFiles } from '../engine/support/glb.ts';
import { bar, bent } from '../engine/support/shapes.ts';
import { stated } from './exporting.ts';
import { expect, test } from './support.ts';
import type { App } from './support.ts';

// The test changes browser functions before the page is loaded.
test.use({ fresh: true });

test('nothing is drawn before the import of the first sample, and the start is marked', async ({ app }) => {
  await app.page.addInitScript(() => {
    const { linkProgram } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.linkProgram = function (program) {
      performance.mark('linked');
      linkProgram.call(this, program);
    };
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (this: Worker, ...given: [unknown, StructuredSerializeOptions?]) {
      if ((given[0] as { type?: string }).type === 'import') performance.mark('asked');
      postMessage.apply(this, given);
    } as typeof postMessage;
  });
  await app.open();
  const at = (name: string): Promise<number[]> =>
    app.page.evaluate((of) => performance.getEntriesByName(of).map(({ startTime }) => startTime), name);
  const [linked, asked] = [await at('linked'), await at('asked')];
  expect(linked.length).toBeGreaterThan(1);
  expect(Math.min(...linked)).toBeGreaterThan(asked[0]!);
  const marks = await Promise.all(['scripts', 'read', 'made', 'seen'].map((name) => at(`shapespline ${name}`)));
  expect(marks.flat()).toEqual(marks.flat().sort((a, b) => a - b));
  expect(marks.every((times) => times.length > 0)).toBe(true);
});

test('the first image waits for its shape only: not for the floor, a second motion or the panels', async ({ app }) => {
  await app.page.addInitScript(() => {
    const { linkProgram } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.linkProgram = function (program) {
      performance.mark('linked');
      linkProgram.call(this, program);
    };
    const { width } = Object.getOwnPropertyDescriptors(HTMLCanvasElement.prototype);
    Object.defineProperty(HTMLCanvasElement.prototype, 'width', {
      ...width,
      set(value: number) {
        if (this.isConnected) performance.mark('canvas made again');
        width.set!.call(this, value);
      },
    });
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (this: Worker, ...given: [unknown, StructuredSerializeOptions?]) {
      performance.mark(`asked: ${(given[0] as { type?: string }).type}`);
      postMessage.apply(this, given);
    } as typeof postMessage;
  });
  await app.open({ first: true });
  await app.settled();
  const at = (name: string): Promise<number[]> =>
    app.page.evaluate((of) => performance.getEntriesByName(of).map(({ startTime }) => startTime), name);
  const [[read], [seen]] = [await at('shapespline read'), await at('shapespline seen')];
  const linked = await at('linked');
  expect(linked.filter((time) => time < seen!)).toHaveLength(1);
  expect(linked.length).toBeGreaterThan(3);
  // The second motion uses the same shape.
  const motions = await at('asked: motion');
  expect(motions.filter((time) => time < seen!)).toHaveLength(1);
  expect(motions).toHaveLength(2);
  expect(await at('asked: encode')).toHaveLength(1);
  expect((await at('canvas made again')).filter((time) => time > read! && time < seen!)).toHaveLength(0);
  const panels = await app.page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .filter(({ name }) => /(panel|figure|playground)-/.test(name))
      .map(({ startTime }) => startTime),
  );
  expect(panels.length).toBeGreaterThan(0);
  expect(Math.min(...panels)).toBeGreaterThan(seen!);
});

const wasmOf = ({ requests }: App, module: string): string[] =>
  requests.filter((url) => new RegExp(`/${module}(-[^/]*)?\\.wasm$`).test(url));

test('the module for files is fetched for the first file, and again after a failure', async ({ app }) => {
  const mesh = bar();
  const poses = [0, 60].map((degrees) => bent(mesh, degrees));
  const upload = poseFiles(mesh, poses).map(({ name, bytes }) => ({
    name,
    mimeType: 'model/gltf-binary',
    buffer: Buffer.from(bytes),
  }));
  await app.open({ first: true });
  await app.settled();
  expect(wasmOf(app, 'shapespline').length).toBeGreaterThan(0);
  expect(wasmOf(app, 'shapespline_files')).toEqual([]);
  await app.page.route(/shapespline_files[^/]*\.wasm$/, (route) => route.abort());
  await app.by('file-input').setInputFiles(upload);
  await expect(app.by('error')).toContainText('The computation could not be loaded');
  expect((await app.state()).source).toEqual({ kind: 'sample', id: 'column' });
  await app.page.unrouteAll();
  await app.by('file-input').setInputFiles(upload);
  await expect.poll(async () => (await app.state()).source.kind).toBe('files');
  await app.settled();
  expect(wasmOf(app, 'shapespline_files')).toHaveLength(2);
});

test('the module for files is fetched for the first export', async ({ app }) => {
  await app.open({ first: true });
  expect(wasmOf(app, 'shapespline_files')).toEqual([]);
  expect(await stated(app, async () => undefined)).toContain('morph targets');
  expect(wasmOf(app, 'shapespline_files')).toHaveLength(1);
});
