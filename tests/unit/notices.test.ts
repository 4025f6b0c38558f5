import { expect, it } from 'vitest';
import { packageOf } from '../../wasm/toolchain/notices.mjs';

it.each([
  ['/x/node_modules/three/build/three.core.js', 'three'],
  ['/x/node_modules/@gltf-transform/core/dist/index.js', '@gltf-transform/core'],
  ['/x/node_modules/a/node_modules/@b/c/d.js?url', '@b/c'],
  ['C:\\x\\node_modules\\three\\three.js', 'three'],
  ['/x/web/app/main.ts', null],
  ['\0vite/preload-helper.js', null],
])('the package of the module %j is %j', (module, name) => {
  expect(packageOf(module)).toBe(name);
});
