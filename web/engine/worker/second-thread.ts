/**
 * The second thread: an instance of the threaded module on the memory of the first, with its own stack. It waits on a
 * futex inside the module, computes the second parts of frames, and never returns.
 */
import type { Address } from './wasm-module.ts';

export interface SecondThreadStart {
  module: WebAssembly.Module;
  memory: WebAssembly.Memory;
  /** Its upper end. */
  stack: Address;
}

interface SecondThreadExports {
  __stack_pointer: WebAssembly.Global;
  shapespline_help(): void;
  shapespline_help_lost(): void;
}

/** Ends only with the thread. `onReady` is called just before it waits for work. */
export function help({ module, memory, stack }: SecondThreadStart, onReady: () => void): void {
  const imports: WebAssembly.Imports = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = kind === 'memory' ? memory : notHere(name);
  }
  // Not seen by the types: that the module exports just these.
  const secondThread = new WebAssembly.Instance(module, imports).exports as unknown as SecondThreadExports;
  secondThread.__stack_pointer.value = stack;
  onReady();
  try {
    secondThread.shapespline_help();
  } catch {
    secondThread.shapespline_help_lost();
  }
}

// The parts of a frame need nothing of the page.
function notHere(name: string) {
  return (): never => {
    throw new Error(`${name} was called in the second thread`);
  };
}
