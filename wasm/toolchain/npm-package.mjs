// build/package: the npm package; `npm pack ./build/package` packs it. Plain JavaScript for browsers and Node, types,
// the wasm files, notices. esbuild bundles it and keeps `new URL('./name', import.meta.url)`, which users' bundlers
// recognise. A declaration bundler (rollup-plugin-dts) makes one type file per entry.
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { FRAMEWORKS, attributeTypes, elementTypes } from './element-types.mjs';
import { NOTICES, notices, packageOf } from './notices.mjs';
import { npmManifest } from './npm-manifest.mjs';
import { buildDir, inRoot } from './paths.mjs';
import { withoutPixels } from './pixels.mjs';

export const packageDir = path.join(buildDir, 'package');
const inPackage = (...parts) => path.join(packageDir, ...parts);
const source = (name) => inRoot('web', name);

/** Replacements for modules that locate the repository's files. */
const packaged = {
  name: 'packaged',
  setup: ({ onResolve }) =>
    onResolve({ filter: /\/(browser|node)-files\.ts$/ }, ({ path: name, importer, kind }) =>
      importer.startsWith(source('engine/')) && path.dirname(importer) === source('engine') && kind !== 'entry-point'
        ? { path: source(`engine/packaged/${path.basename(name)}`) }
        : undefined,
    ),
};

/** Scripts on pages use their own versions of functions that old libraries replace. */
const ownBuiltins = {
  define: { 'Array.from': 'arrayFrom', 'JSON.stringify': 'stringify' },
  inject: [source('engine/packaged/builtins.ts')],
};

/** Node modules that scripts import only when running in Node; empty in a browser. */
const nothingOfNode = {
  name: 'nothing-of-node',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^(node:.*|module|fs|path|crypto|url|util)$/ }, ({ path: name }) => ({
      path: name,
      namespace: 'nothing-of-node',
    }));
    onLoad({ filter: /.*/, namespace: 'nothing-of-node' }, () => ({ contents: 'export default {}' }));
  },
};

const withText = (name, text) => ({
  name: 'with-text',
  setup: ({ onLoad }) =>
    onLoad({ filter: new RegExp(`/${name}\\.ts$`) }, () => ({
      contents: `export const inlinedWorker = ${JSON.stringify(text)};`,
    })),
});

const forBrowsers = {
  bundle: true,
  format: 'esm',
  platform: 'browser',
  target: 'es2022',
  minify: true,
  legalComments: 'none',
  metafile: true,
  logLevel: 'warning',
  alias: withoutPixels,
  plugins: [packaged, nothingOfNode],
};
const forNode = {
  ...forBrowsers,
  platform: 'node',
  target: 'node20',
  plugins: [packaged],
  outExtension: { '.js': '.mjs' },
};

const elementEntries = [
  ['element', 'embed/register.ts'],
  ['element-class', 'embed/shape-spline.ts'],
  ['canvas-viewer', 'embed/canvas-viewer.ts'],
];
const elementTypesOf = [...elementEntries.slice(1), ['cdn', 'embed/cdn.ts']];
const hasElement = () => elementEntries.every(([, file]) => existsSync(source(file)));
const entries = (list) => list.map(([out, file]) => ({ out, in: source(file) }));

async function scripts(element) {
  const { build } = await import('esbuild');
  const outdir = packageDir;
  const alone = (out, file, more = {}) =>
    build({ ...forBrowsers, outdir, entryPoints: entries([[out, file]]), ...more });
  const made = await Promise.all([
    build({
      ...forBrowsers,
      ...ownBuiltins,
      outdir,
      entryPoints: entries([['index', 'engine/index.ts'], ...(element ? elementEntries : [])]),
      // All entries share one engine, so `configure` applies to all of them.
      splitting: true,
      chunkNames: 'chunk-[hash]',
      external: ['three', 'three/*'],
    }),
    alone('worker', 'engine/packaged/worker.ts'),
    // The decoder runs in Node as in a browser, because it receives everything it needs.
    alone('codecs', 'engine/packaged/codecs.ts', { define: { process: 'undefined' } }),
    build({
      ...forNode,
      outdir: inPackage('node'),
      entryPoints: entries([
        ['index', 'engine/index-node.ts'],
        ['node-worker', 'engine/packaged/node-worker.ts'],
        ['second-thread-node', 'engine/worker/second-thread-node.ts'],
        ['cli', 'cli/main.ts'],
      ]),
    }),
  ]);
  if (element) {
    const worker = withText('inlined-worker', readFileSync(inPackage('worker.js'), 'utf8'));
    made.push(await alone('cdn', 'embed/cdn.ts', { ...ownBuiltins, plugins: [worker, ...forBrowsers.plugins] }));
  }
  return made.flatMap(({ metafile }) => Object.keys(metafile.inputs));
}

async function types(element) {
  const [{ rollup }, { dts }] = await Promise.all([import('rollup'), import('rollup-plugin-dts')]);
  const input = { index: source('engine/index.ts') };
  if (element) for (const [out, file] of elementTypesOf) input[out] = source(file);
  const bundle = await rollup({ input, external: [/^three/], plugins: [dts({ tsconfig: source('tsconfig.json') })] });
  await bundle.write({ dir: packageDir, chunkFileNames: 'types-[hash].d.ts' });
  await bundle.close();
}

/** The output of a source module that Node cannot import directly. */
async function madeBy(file, name) {
  const { build } = await import('esbuild');
  const outfile = path.join(buildDir, 'package-maker.mjs');
  await build({ ...forNode, entryPoints: [source(file)], outfile, outExtension: undefined });
  const made = (await import(`${pathToFileURL(outfile).href}?${Date.now()}`))[name]();
  rmSync(outfile);
  return made;
}

/** In Node, no entry imports three.js, which may be missing. */
const viewerInNode = `export class CanvasViewer {
  constructor() {
    throw new Error('CanvasViewer draws into a page: it can be imported in Node, but made in a browser only.');
  }
}
`;

const write = (name, text) => writeFileSync(inPackage(name), text);
const asJson = (value) => `${JSON.stringify(value, null, 2)}\n`;

async function ofElement() {
  const manifest = await madeBy('embed/manifest.ts', 'customElementsManifest');
  write('custom-elements.json', asJson(manifest));
  write('element.d.ts', elementTypes);
  write('attributes.d.ts', attributeTypes(manifest));
  write('node/canvas-viewer.mjs', viewerInNode);
  for (const [name, types] of Object.entries(FRAMEWORKS)) {
    write(`${name}.d.ts`, types);
    // Types only; importing it has no effect.
    write(`${name}.js`, 'export {};\n');
  }
}

/** Rebuilds build/package. */
export async function buildPackage() {
  const element = hasElement();
  rmSync(packageDir, { recursive: true, force: true });
  mkdirSync(packageDir, { recursive: true });
  const modules = await scripts(element);
  await types(element);
  if (element) await ofElement();
  for (const name of [
    'shapespline.wasm',
    'shapespline_files.wasm',
    'shapespline_shells.wasm',
    'shapespline_threads.wasm',
  ])
    cpSync(inRoot('build/wasm', name), inPackage(name));
  cpSync(inRoot('node_modules/draco3dgltf/draco_decoder_gltf.wasm'), inPackage('draco_decoder_gltf.wasm'));
  cpSync(source('package/README.md'), inPackage('README.md'));
  for (const name of ['LICENSE', 'CHANGELOG.md']) cpSync(inRoot(name), inPackage(name));
  const packages = modules.map((module) => packageOf(`/${module}`)).filter((name) => name !== null);
  write(NOTICES, notices(packages));
  write('package.json', asJson(npmManifest({ element })));
}
