/** The answers of a worker with the module for fitted motions. */
import type { ShellCallName } from '../wire/protocol.ts';
import type { Answers } from './answers.ts';
import type { WasmShells } from './wasm-shells.ts';

export function shellAnswers(wasm: WasmShells): Answers<ShellCallName> {
  return {
    fitShells: (request, report) => wasm.fit(request, report),
    leadShape: (request) => {
      wasm.lead(request);
      return null;
    },
    follow: (request) => ({ positions: wasm.follow(request) }),
    shellBending: (request) => wasm.bending(request),
  };
}
