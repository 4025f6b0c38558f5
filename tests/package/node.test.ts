/** The package in Node, and its content. */
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';
import { expect, inject, it } from 'vitest';
import { newProject, packageIn } from './support/project.ts';
import { sumInNode } from './support/expected.ts';

const project = inject('installed');
const start = promisify(execFile);
const node = async (folder: string, ...args: string[]): Promise<string> =>
  (await start(process.execPath, args, { cwd: folder })).stdout;
const manifest = JSON.parse(readFileSync(path.join(packageIn(project), 'package.json'), 'utf8'));
const hasElement = './element' in manifest.exports;

it('the tarball contains exactly these files', () => {
  const chunks = /^(chunk-\w+\.js|types-[\w-]+\.d\.ts)$/;
  const ofElement = [
    'attributes.d.ts',
    'canvas-viewer.d.ts',
    'canvas-viewer.js',
    'cdn.d.ts',
    'cdn.js',
    'custom-elements.json',
    'element-class.d.ts',
    'element-class.js',
    'element.d.ts',
    'element.js',
    'jsx.d.ts',
    'jsx.js',
    'node/canvas-viewer.mjs',
    'svelte.d.ts',
    'svelte.js',
    'vue.d.ts',
    'vue.js',
  ];
  expect(
    inject('packed')
      .filter((file) => !chunks.test(file))
      .sort(),
  ).toEqual(
    [
      'CHANGELOG.md',
      'LICENSE',
      'README.md',
      'codecs.js',
      'draco_decoder_gltf.wasm',
      'index.d.ts',
      'index.js',
      'node/cli.mjs',
      'node/index.mjs',
      'node/node-worker.mjs',
      'node/second-thread-node.mjs',
      'notices.txt',
      'package.json',
      'shapespline.wasm',
      'shapespline_files.wasm',
      'shapespline_shells.wasm',
      'shapespline_threads.wasm',
      'worker.js',
      ...(hasElement ? ofElement : []),
    ].sort(),
  );
});

it('package.json has no dependencies and no scripts, and names existing files', () => {
  expect(manifest).toMatchObject({ name: 'shapespline', type: 'module', engines: { node: '>=20' } });
  for (const name of ['private', 'scripts', 'dependencies', 'devDependencies', 'overrides'])
    expect(manifest).not.toHaveProperty(name);
  const named = (part: unknown): string[] =>
    typeof part === 'string' ? [part] : Object.values(part as object).flatMap(named);
  for (const file of [...named(manifest.exports), ...manifest.sideEffects, ...named(manifest.bin), manifest.types])
    expect(inject('packed')).toContain(path.posix.normalize(file));
});

it('every entry can be imported in Node, without a page', async () => {
  const entries = Object.keys(manifest.exports)
    .filter((name) => !/\.(wasm|json)$/.test(name))
    .map((name) => path.posix.join('shapespline', name));
  expect(entries).toContain('shapespline/worker.js');
  // Bundlers for browsers also use index.js.
  const all = [...entries, path.join(packageIn(project), 'index.js')];
  const importing = all.map((name) => `await import(${JSON.stringify(name)});`).join('\n');
  expect(await node(project, '--input-type=module', '-e', `${importing}\nconsole.log('all')`)).toBe('all\n');
  const viewer = `const { CanvasViewer } = await import('shapespline/canvas-viewer');
    try { new CanvasViewer(); } catch (error) { console.log(error.message); }`;
  expect(await node(project, '--input-type=module', '-e', viewer)).toMatch(/^CanvasViewer draws into a page: /);
});

it('the engine runs in Node without a bundler, reads and writes compressed files', async () => {
  const folder = await newProject();
  expect((await sumInNode(folder)).vertices).toBeGreaterThan(100);
  const written = await node(
    folder,
    '--input-type=module',
    '-e',
    `import { createEngine } from 'shapespline';
     import { readFile } from 'node:fs/promises';
     const engine = createEngine();
     const read = async (name) => ({ name, bytes: await readFile('public/' + name) });
     const keys = await engine.importKeyframes([await read('pose-0.glb'), await read('pose-1.glb')]);
     const sequence = await engine.createSequence(keys);
     const [file] = await sequence.export({ compression: 'meshopt' });
     const again = await engine.importKeyframes([file]);
     console.log(again.info.times.join());
     engine.dispose();`,
  );
  expect(written).toBe('0,1\n');
});

it('has the same names in Node and in a browser', async () => {
  const names = (file: string): Promise<string> =>
    node(project, '--input-type=module', '-e', `console.log(Object.keys(await import('${file}')).join())`);
  expect(await names('shapespline')).toBe(await names(path.join(packageIn(project), 'index.js')));
});

it('configure refuses unknown options, and calls after the first engine', async () => {
  const said = await node(
    project,
    '--input-type=module',
    '-e',
    `import { configure, createEngine } from 'shapespline';
     const tried = (urls) => { try { configure(urls); } catch (error) { console.log(error.code, error.message); } };
     tried({ wasm: 'x' });
     tried({ wasmUrl: 3 });
     tried({ threadsUrl: null });
     createEngine().dispose();
     tried({ threadsUrl: null });
     tried({ wasmUrl: '/elsewhere.wasm' });`,
  );
  expect(said.trim().split('\n')).toEqual([
    'invalid-option configure has no option wasm. The options are wasmUrl, filesUrl, shellsUrl, workerUrl, threadsUrl, dracoUrl.',
    'invalid-option wasmUrl must be a URL: a string or a URL object.',
    expect.stringMatching(/^invalid-option configure was called too late: call it before the first engine is made/),
  ]);
});

it('the command line is installed as a program', async () => {
  const folder = await newProject();
  const program = path.join(project, 'node_modules', '.bin', 'shapespline');
  const run = async (...args: string[]): Promise<string> => (await start(program, args, { cwd: folder })).stdout;
  expect(await run('--version')).toBe(`${manifest.version}\n`);
  await run('complete', 'public/pose-0.glb', 'public/pose-1.glb', '--output', 'motion.glb');
  expect(JSON.parse(await run('inspect', 'motion.glb')).keys).toHaveLength(2);
});

it('the types are those of the engine, for bundlers and for Node', async () => {
  const folder = await newProject({
    'use.ts': `
      import { configure, createEngine, EngineError, type Frame } from 'shapespline';
      configure({ wasmUrl: new URL('file:///x.wasm'), filesUrl: './y.wasm', threadsUrl: null });
      const engine = createEngine({ onLost: () => undefined });
      const keys = await engine.importKeyframes([{ name: 'a.glb', bytes: new Uint8Array() }]);
      const sequence = await engine.createSequence(keys, { boundary: 'hermite', startSpeed: 0 });
      const frame: Frame | null = await sequence.evaluate(0.5);
      const positions: Float32Array | undefined = frame?.positions;
      // @ts-expect-error
      await engine.createSequence(keys, { boundary: 'no such' });
      console.log(positions, EngineError);
    `,
  });
  const tsc = path.resolve('node_modules/typescript/bin/tsc');
  for (const [module, resolution] of [
    ['esnext', 'bundler'],
    ['nodenext', 'nodenext'],
  ] as const) {
    const config = {
      compilerOptions: {
        strict: true,
        noEmit: true,
        exactOptionalPropertyTypes: true,
        target: 'es2022',
        lib: ['es2022', 'dom'],
        types: [],
        module,
        moduleResolution: resolution,
      },
      include: ['use.ts'],
    };
    writeFileSync(path.join(folder, 'tsconfig.json'), JSON.stringify(config));
    expect(await node(folder, tsc, '-p', '.')).toBe('');
  }
});
