/** The handlers of a worker with the module for fitted motions. */
import type { ShellCallName } from '../wire/protocol.ts';
import type { Handlers } from './handlers.ts';
import type { WasmShells } from './wasm-shells.ts';

export function shellHandlers(wasm: WasmShells): Handlers<ShellCallName> {
  return {
    fitShells: (request, report) => wasm.fit(request, report),
    deformationTransfer: (request) => {
      wasm.lead(request);
      return null;
    },
    follow: (request) => ({ positions: wasm.follow(request) }),
    shellBending: (request) => wasm.bending(request),
  };
}
