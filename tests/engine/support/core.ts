/** The core in this very thread, for tests of the bindings and of the heap. */
/// <reference path="../../../web/engine/worker/generated.d.ts" />
import { readFile } from 'node:fs/promises';
import createWasm from '../../../build/wasm/shapespline.mjs';
import { WasmCore } from '../../../web/engine/worker/wasm-core.ts';
import type { MotionSpec, RequestOf } from '../../../web/engine/wire/protocol.ts';
import { ENCODING_DEFAULTS, MOTION_DEFAULTS } from '../../../web/engine/api/types.ts';
import type { WasmModule } from '../../../web/engine/worker/wasm-module.ts';
import { bar, bent, type Mesh } from './shapes.ts';

let compiled: Promise<WebAssembly.Module> | null = null;

export interface LocalCore {
  core: WasmCore;
  module: WasmModule;
}

export async function localCore(): Promise<LocalCore> {
  compiled ??= readFile(new URL('../../../build/wasm/shapespline.wasm', import.meta.url)).then((bytes) =>
    WebAssembly.compile(bytes),
  );
  let module: WasmModule | null = null;
  const core = await WasmCore.start(async (settings) => (module = await createWasm(settings)), await compiled);
  return { core, module: module as unknown as WasmModule };
}

export const motion: MotionSpec = { number: 1, options: MOTION_DEFAULTS, keyTimes: [0, 0.5, 1] };

export function bendData(mesh: Mesh = bar()): RequestOf<'encode'> {
  return {
    names: ['a', 'b', 'c'],
    times: motion.keyTimes as number[],
    faces: mesh.indices,
    positions: [0, 60, 120].map((degrees) => bent(mesh, degrees)),
    normals: null,
    encoding: ENCODING_DEFAULTS,
  };
}

export interface Bend {
  /** Handles. */
  shape: number;
  motion: number;
  release(): void;
}

export function createBend(core: WasmCore, data = bendData(), spec = motion): Bend {
  const shape = core.encode(data);
  const { handle } = core.motion(shape, spec, null);
  const release = (): void => [handle, shape].forEach((one) => core.release(one));
  return { shape, motion: handle, release };
}
