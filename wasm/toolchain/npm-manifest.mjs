// The package.json of the npm package. Name, version and similar fields are from the repository's own.
import { readFileSync } from 'node:fs';
import { FRAMEWORKS } from './element-types.mjs';
import { inRoot } from './paths.mjs';

/** Files next to the scripts with public URLs, for `configure` and for copying. */
export const FILES = [
  'worker.js',
  'codecs.js',
  'shapespline.wasm',
  'shapespline_files.wasm',
  'shapespline_shells.wasm',
  'shapespline_threads.wasm',
  'draco_decoder_gltf.wasm',
];

const typed = (name) => ({ types: `./${name}.d.ts`, default: `./${name}.js` });
const asItIs = (names) => Object.fromEntries(names.map((name) => [`./${name}`, `./${name}`]));

// A page that starts the worker itself imports worker.js for its side effects.
const ACTIVE = ['./worker.js'];

/** `element`: whether it includes the custom element. */
export function npmManifest({ element }) {
  const { name, version, description, license, type, engines, devDependencies } = JSON.parse(
    readFileSync(inRoot('package.json'), 'utf8'),
  );
  const ofElement = {
    './element': typed('element'),
    './element-class': typed('element-class'),
    './canvas-viewer': {
      types: './canvas-viewer.d.ts',
      node: './node/canvas-viewer.mjs',
      default: './canvas-viewer.js',
    },
    './cdn': typed('cdn'),
    ...Object.fromEntries(Object.keys(FRAMEWORKS).map((name) => [`./${name}`, typed(name)])),
    ...asItIs(['custom-elements.json']),
  };
  return {
    name,
    version,
    description,
    keywords: ['animation', 'custom-element', 'gltf', 'interpolation', 'mesh', 'morph', 'shape', 'spline', 'wasm'],
    license,
    type,
    engines,
    exports: {
      '.': { types: './index.d.ts', node: './node/index.mjs', default: './index.js' },
      ...(element ? ofElement : {}),
      ...asItIs([...FILES, 'package.json']),
    },
    main: './index.js',
    types: './index.d.ts',
    bin: { [name]: 'node/cli.mjs' },
    files: ['*.js', '*.wasm', '*.d.ts', 'node', 'custom-elements.json', 'notices.txt', 'CHANGELOG.md'],
    sideEffects: element ? ['./element.js', './cdn.js', ...ACTIVE] : ACTIVE,
    ...(element
      ? {
          customElements: 'custom-elements.json',
          // The lowest version that the tests use; a range, because other packages require their own versions.
          peerDependencies: { three: `>=${devDependencies['three-lowest'].replace('npm:three@', '')}` },
          peerDependenciesMeta: { three: { optional: true } },
        }
      : {}),
  };
}
