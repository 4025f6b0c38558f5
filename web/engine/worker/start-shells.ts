/** The module for fitted motions with its glue, loaded with the first such motion. */
import createShells from '../../../build/wasm/shapespline_shells.mjs';
import type { ShellCallName } from '../wire/protocol.ts';
import type { Answers } from './answers.ts';
import { shellAnswers } from './shell-answers.ts';
import { WasmShells } from './wasm-shells.ts';

export async function startShells(module: WebAssembly.Module): Promise<Answers<ShellCallName>> {
  return shellAnswers(await WasmShells.start(createShells, module));
}
