/** The wasm modules in the current thread, for tests of the bindings and the heap. */
/// <reference path="../../../web/engine/worker/generated.d.ts" />
import { readFile } from 'node:fs/promises';
import createCore from '../../../build/wasm/shapespline.mjs';
import createFiles from '../../../build/wasm/shapespline_files.mjs';
import { WasmCore } from '../../../web/engine/worker/wasm-core.ts';
import { WasmFiles } from '../../../web/engine/worker/wasm-files.ts';
import type { MotionSpec, RequestOf } from '../../../web/engine/wire/protocol.ts';
import { ENCODING_DEFAULTS, MOTION_DEFAULTS } from '../../../web/engine/api/types.ts';
import type { CoreModule, CreateWasmModule, FilesModule, WasmModule } from '../../../web/engine/worker/wasm-module.ts';
import { bar, bent, type Mesh } from './shapes.ts';

export interface LocalCore {
  core: WasmCore;
  module: CoreModule;
}

export interface LocalFiles {
  files: WasmFiles;
  module: FilesModule;
}

export async function localCore(): Promise<LocalCore> {
  const { create, made } = kept(createCore);
  return { core: await WasmCore.start(create, await compiled('shapespline')), module: made() };
}

export async function localFiles(): Promise<LocalFiles> {
  const { create, made } = kept(createFiles);
  return { files: await WasmFiles.start(create, await compiled('shapespline_files')), module: made() };
}

const compiling = new Map<string, Promise<WebAssembly.Module>>();

/** A module of build/wasm, compiled once. */
export function compiled(name: string): Promise<WebAssembly.Module> {
  const compile = async (): Promise<WebAssembly.Module> =>
    WebAssembly.compile(await readFile(new URL(`../../../build/wasm/${name}.wasm`, import.meta.url)));
  if (!compiling.has(name)) compiling.set(name, compile());
  return compiling.get(name)!;
}

/** Wraps a factory of modules to provide access to the module that it made. */
export function kept<M extends WasmModule>(create: CreateWasmModule<M>): { create: CreateWasmModule<M>; made(): M } {
  let module: M | null = null;
  return { create: async (settings) => (module = await create(settings)), made: () => module! };
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
  /** Handle of the shape. */
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
