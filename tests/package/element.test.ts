/** The custom element from the tarball: its one-file build from another host, bundled, and its types. */
import { execFile } from 'node:child_process';
import { cpSync, existsSync, readFileSync, readdirSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';
import * as esbuild from 'esbuild';
import * as vite7 from 'vite';
import * as vite8 from 'vite8';
import { describe, expect, inject, it } from 'vitest';
import webpack from 'webpack';
import { host, outcomeOf } from './support/browser.ts';
import { newProject, packageIn } from './support/project.ts';

const there = existsSync(path.join(packageIn(inject('installed')), 'element.js'));

const MARKUP = '<shape-spline src="pose-0.glb pose-1.glb" loading="eager" alt="A bar"></shape-spline>';

const BUNDLED = `<!doctype html>${MARKUP}<script type="module" src="./main.js"></script>`;

/** Prints the size of the evaluated shape once a time has been drawn. */
const WATCH = `
  const element = document.querySelector('shape-spline');
  const say = (outcome) => { window.outcome ??= outcome; };
  element.addEventListener('error', ({ detail }) => say({ error: detail?.message ?? 'an error without details' }));
  element.addEventListener('load', async () => {
    await element.seek(0.5);
    const frame = await element.evaluate(0.5);
    say({ vertices: frame.positions.length / 3, time: element.currentTime });
  });
`;
const SHOWN = { vertices: expect.any(Number), time: 0.5 };

/** The additional packages that a bundled page with the element needs. */
async function withPeers(files: Record<string, string>, three = 'three'): Promise<string> {
  const folder = await newProject(files);
  symlinkSync(path.resolve('node_modules', three), path.join(folder, 'node_modules', 'three'));
  symlinkSync(path.resolve('node_modules/@types'), path.join(folder, 'node_modules', '@types'));
  symlinkSync(path.resolve('node_modules/csstype'), path.join(folder, 'node_modules', 'csstype'));
  return folder;
}

/** TypeScript's errors in the folder's own files, without types of frameworks that are not installed. */
async function problemsOf(folder: string): Promise<string> {
  const compilerOptions = {
    strict: true,
    noEmit: true,
    target: 'es2022',
    lib: ['es2023', 'dom', 'dom.iterable'],
    types: [],
    jsx: 'react-jsx',
    module: 'esnext',
    moduleResolution: 'bundler',
  };
  writeFileSync(path.join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions, include: ['*.ts', '*.tsx'] }));
  const tsc = path.resolve('node_modules/typescript/bin/tsc');
  const { stdout } = await promisify(execFile)(process.execPath, [tsc, '-p', '.'], { cwd: folder }).catch(
    (failed: { stdout: string }) => failed,
  );
  return stdout;
}

describe.skipIf(!there)('the element', () => {
  it('is shown by the example page of the README, on a plain server and on those of Vite by default', async () => {
    const readme = readFileSync(path.join(packageIn(inject('installed')), 'README.md'), 'utf8');
    const [html] = /<!doctype html>\n<meta charset[^`]*/.exec(readme)!;
    const folder = await newProject({ 'index.html': `${html}<script type="module">${WATCH}</script>` });
    for (const [pose, name] of ['a', 'b'].entries())
      cpSync(path.join(folder, 'public', `pose-${pose}.glb`), path.join(folder, `${name}.glb`));
    expect(await outcomeOf(await host([folder]))).toEqual(SHOWN);
    for (const vite of [vite7, vite8 as unknown as typeof vite7]) {
      const settings = { root: folder, configFile: false as const, logLevel: 'error' as const };
      const server = await vite.createServer({ ...settings, server: { port: 0, host: 'localhost' } });
      try {
        await server.listen();
        expect(await outcomeOf(server.resolvedUrls!.local[0]!)).toEqual(SHOWN);
      } finally {
        await server.close();
      }
    }
  });

  it.each([
    ['Vite 7', vite7 as Pick<typeof vite7, 'createServer' | 'build'>],
    ['Vite 8', vite8 as unknown as Pick<typeof vite7, 'createServer' | 'build'>],
  ])('runs in %s, in development and as built', async (_, vite) => {
    const main = `import 'shapespline/element';\n${WATCH}`;
    const folder = await withPeers({ 'main.js': main, 'index.html': BUNDLED });
    const settings = { root: folder, configFile: false as const, logLevel: 'error' as const };
    const server = await vite.createServer({
      ...settings,
      server: { port: 0, host: 'localhost', fs: { strict: false } },
    });
    try {
      await server.listen();
      expect(await outcomeOf(server.resolvedUrls!.local[0]!)).toEqual(SHOWN);
    } finally {
      await server.close();
    }
    await vite.build({ ...settings, base: './' });
    expect(await outcomeOf(await host([path.join(folder, 'dist')]))).toEqual(SHOWN);
  });

  it('is bundled by webpack 5', async () => {
    const folder = await withPeers({ 'main.js': `import 'shapespline/element';\n${WATCH}`, 'index.html': BUNDLED });
    const output = path.join(folder, 'dist');
    const stats = await new Promise<webpack.Stats | undefined>((resolve, reject) =>
      webpack(
        { mode: 'production', context: folder, entry: './main.js', output: { path: output, filename: 'main.js' } },
        (error, done) => (error ? reject(error) : resolve(done)),
      ),
    );
    expect(stats?.toJson({ all: false, errors: true })).toMatchObject({ errors: [] });
    expect(await outcomeOf(await host([output, folder, path.join(folder, 'public')]))).toEqual(SHOWN);
  });

  it.each(['three', 'three-lowest'])(
    'is bundled by esbuild with %s, with the files next to the script',
    async (three) => {
      const files = { 'main.js': `import 'shapespline/element';\n${WATCH}`, 'index.html': BUNDLED };
      const folder = await withPeers(files, three);
      const output = path.join(folder, 'dist');
      await esbuild.build({
        absWorkingDir: folder,
        entryPoints: ['main.js'],
        bundle: true,
        splitting: true,
        format: 'esm',
        outdir: output,
        logLevel: 'error',
      });
      for (const name of readdirSync(packageIn(folder)).filter((file) => /^(worker|codecs)\.js$|\.wasm$/.test(file)))
        cpSync(path.join(packageIn(folder), name), path.join(output, name));
      expect(await outcomeOf(await host([output, folder, path.join(folder, 'public')]))).toEqual(SHOWN);
    },
  );

  it('the viewer can be used in an element of the page without the custom element', async () => {
    const files = {
      'main.js': `
        import { createEngine } from 'shapespline';
        import { CanvasViewer } from 'shapespline/canvas-viewer';
        const box = document.getElementById('box');
        Object.assign(box.style, { width: '300px', height: '200px' });
        const read = async (name) => ({ name, bytes: new Uint8Array(await (await fetch(name)).arrayBuffer()) });
        const run = async () => {
          const engine = createEngine();
          const keys = await engine.importKeyframes([await read('pose-0.glb'), await read('pose-1.glb')]);
          const sequence = await engine.createSequence(keys);
          const viewer = new CanvasViewer(box);
          await viewer.open(keys, [{ sequence, method: 'lri', ghost: 0 }], 0);
          const canvas = box.querySelector('canvas');
          const first = canvas.toDataURL();
          await viewer.seek(0.7);
          const moved = canvas.toDataURL() !== first;
          await viewer.seek(0);
          const outcome = { moved, same: canvas.toDataURL() === first, width: canvas.width };
          viewer.dispose();
          return { ...outcome, left: box.childElementCount };
        };
        run().then((outcome) => { window.outcome = outcome; }, (error) => { window.outcome = { error: String(error) }; });
      `,
      'index.html': '<!doctype html><div id="box"></div><script type="module" src="./main.js"></script>',
    };
    const folder = await withPeers(files);
    await vite7.build({ root: folder, configFile: false, logLevel: 'error', base: './' });
    expect(await outcomeOf(await host([path.join(folder, 'dist')]))).toEqual({
      moved: true,
      same: true,
      width: 300,
      left: 0,
    });
  });

  it('its class alone registers nothing, and can be registered with another name', async () => {
    const folder = await withPeers({
      'main.js': `
        import { ShapeSplineElement } from 'shapespline/element-class';
        const before = customElements.get('shape-spline') === undefined;
        customElements.define('my-motion', class extends ShapeSplineElement {});
        const element = document.querySelector('my-motion');
        element.src = 'pose-0.glb pose-1.glb';
        element.seek(0.5).then(() => { window.outcome = { before, time: element.currentTime }; });
      `,
      'index.html': '<!doctype html><my-motion></my-motion><script type="module" src="./main.js"></script>',
    });
    await vite7.build({ root: folder, configFile: false, logLevel: 'error', base: './' });
    expect(await outcomeOf(await host([path.join(folder, 'dist')]))).toEqual({ before: true, time: 0.5 });
  });

  it('has types for React 19, for the document and for the class', async () => {
    const folder = await withPeers({
      'use.tsx': `
        import 'shapespline/element';
        import type {} from 'shapespline/jsx';
        import { ShapeSplineElement } from 'shapespline/element-class';
        export const shown = <shape-spline src="a.glb b.glb" boundary="periodic" autoplay loop="bounce" controls />;
        const tell = (time: number, index: number): void => console.log(time, index);
        export const more = (
          <shape-spline keys={[new Blob(), new URL('https://a.example/b.glb')]} playbackRate={2} startSpeed={0} hidden
            onseeked={({ detail }) => tell(detail.currentTime, 0)} onkeychange={({ detail }) => tell(0, detail.index)} />
        );
        // @ts-expect-error
        export const never = <shape-spline onseeked={({ detail }) => tell(detail.index, 0)} />;
        // @ts-expect-error
        export const wrong = <shape-spline boundary="no such" />;
        const element: ShapeSplineElement = document.querySelector('shape-spline')!;
        await element.seek(0.5);
      `,
      'example.tsx': readFileSync(new URL('../../web/embed/examples/react-component.tsx', import.meta.url), 'utf8'),
    });
    expect(await problemsOf(folder)).toBe('');
  });

  it('has types for Vue and Svelte, which need no types of React', async () => {
    const folder = await newProject({
      // The extensible interfaces of Vue 3.5 and Svelte 5, by their names.
      'node_modules/vue/index.d.ts': `
        export interface HTMLAttributes { class?: string; onClick?: (event: MouseEvent) => void; onPlay?: () => void }
        export interface PublicProps { ref?: unknown }
        export interface GlobalComponents { Other: new () => { $props: {} } }`,
      'node_modules/vue/package.json': '{ "name": "vue", "types": "index.d.ts" }',
      'node_modules/svelte/elements.d.ts': `
        export interface HTMLAttributes<T extends EventTarget> { class?: string; onplay?: (event: T) => void }
        export interface SvelteHTMLElements { a: { href?: string } }`,
      'node_modules/svelte/package.json':
        '{ "name": "svelte", "exports": { "./elements": { "types": "./elements.d.ts" } } }',
      'use.ts': `
        import type {} from 'shapespline/vue';
        import type {} from 'shapespline/svelte';
        import type { GlobalComponents } from 'vue';
        import type { SvelteHTMLElements } from 'svelte/elements';
        type Vue = InstanceType<GlobalComponents['shape-spline']>['$props'];
        type Svelte = SvelteHTMLElements['shape-spline'];
        export const vue: Vue[] = [
          { class: 'big', src: 'a.glb b.glb', 'key-times': '0 2', loop: 'bounce', controls: true },
          { keyTimes: [0, 2], keys: [new Blob()], onSeeked: ({ detail }) => console.log(detail.currentTime) },
          // @ts-expect-error
          { boundary: 'no such' },
          // @ts-expect-error
          { borundary: 'natural' },
          // @ts-expect-error
          { onSeeked: ({ detail }) => console.log(detail.index) },
        ];
        export const svelte: Svelte[] = [
          { class: 'big', src: 'a.glb b.glb', 'key-times': '0 2', loop: 'bounce', controls: true },
          { keyTimes: [0, 2], keys: [new Blob()], onseeked: ({ detail }) => console.log(detail.currentTime) },
          { onkeychange: ({ detail }) => console.log(detail.index), 'on:play': () => console.log('plays') },
          // @ts-expect-error
          { boundary: 'no such' },
          // @ts-expect-error
          { borundary: 'natural' },
          // @ts-expect-error
          { onseeked: ({ detail }) => console.log(detail.index) },
        ];
      `,
    });
    expect(await problemsOf(folder)).toBe('');
  });
});
