/**
 * The second thread: an instance of the threaded module on the first one's memory, with its own stack. It waits on a
 * futex inside the module, computes the second parts of frames, and never returns.
 */
import type { Address } from './wasm-module.ts';

export interface SecondThreadStart {
  module: WebAssembly.Module;
  memory: WebAssembly.Memory;
  /** Upper end of the stack. */
  stack: Address;
}

interface SecondThreadExports {
  __stack_pointer: WebAssembly.Global;
  shapespline_help(): void;
  shapespline_help_lost(): void;
}

/** Returns only when the thread ends. Calls `onReady` just before waiting for work. */
export function help({ module, memory, stack }: SecondThreadStart, onReady: () => void): void {
  const imports: WebAssembly.Imports = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = kind === 'memory' ? memory : notHere(name);
  }
  // The types do not express that the module exports exactly these functions.
  const secondThread = new WebAssembly.Instance(module, imports).exports as unknown as SecondThreadExports;
  secondThread.__stack_pointer.value = stack;
  onReady();
  try {
    secondThread.shapespline_help();
  } catch {
    secondThread.shapespline_help_lost();
  }
}

// Computing a frame calls no imported function, so every import is a stub that throws.
function notHere(name: string) {
  return (): never => {
    throw new Error(`${name} was called in the second thread`);
  };
}
