/** The module for fitted motions with its glue, loaded with the first such motion. */
import createShells from '../../../build/wasm/shapespline_shells.mjs';
import type { ShellCallName } from '../wire/protocol.ts';
import type { Handlers } from './handlers.ts';
import { shellHandlers } from './shell-handlers.ts';
import { WasmShells } from './wasm-shells.ts';

export async function startShells(module: WebAssembly.Module): Promise<Handlers<ShellCallName>> {
  return shellHandlers(await WasmShells.start(createShells, module));
}
