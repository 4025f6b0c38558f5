/** A wasm module with typed calls into its bindings, which copy arrays in and out. Runs inside a worker. */
import { EngineError } from '../api/errors.ts';
import { HeapScope, readJson, readText } from './heap.ts';
import type { Address, CreateWasmModule, WasmModule } from './wasm-module.ts';

type CallResult<T> = ({ ok: true } & T) | Failure;

interface Failure {
  ok: false;
  code: string;
  message: string;
  key: number;
  vertex: number;
  face: number;
}

export type OnProgress = (stage: string, fraction: number) => void;

function placeOf({ key, vertex, face }: Failure): EngineError['place'] {
  const entries = Object.entries({ key, vertex, face }).filter(([, index]) => index >= 0);
  return Object.fromEntries(entries);
}

/** Milliseconds between reports of one stage. */
const REPORT_MS = 15;

export class WasmCalls<M extends WasmModule> {
  constructor(protected readonly module: M) {}

  /** Instantiates the compiled module with its Emscripten glue. */
  static async start<M extends WasmModule, Calls>(
    this: new (
      module: M,
    ) => Calls,
    create: CreateWasmModule<M>,
    compiled: WebAssembly.Module,
  ): Promise<Calls> {
    return new this(await instantiate(create, compiled));
  }

  get heapBytes(): number {
    return this.module.HEAPU8.length;
  }

  /** Number of live objects in the bindings. */
  get objects(): number {
    return this.result<{ count: number }>(this.module._shapespline_objects()).count;
  }

  release(handle: number): void {
    this.module._shapespline_release(handle);
  }

  /** Limits the core's reports, which come faster than needed, because each message takes time. */
  protected hear(onProgress: OnProgress): void {
    let last: Address = -1;
    let heard = -Infinity;
    this.module.onProgress = (stage, fraction) => {
      const now = performance.now();
      if (stage === last && fraction < 1 && now < heard + REPORT_MS) return;
      last = stage;
      heard = now;
      onProgress(readText(this.module, stage), fraction);
    };
  }

  protected lend<T>(work: (scope: HeapScope) => T): T {
    const scope = new HeapScope(this.module);
    try {
      return work(scope);
    } finally {
      scope.free();
    }
  }

  protected send<T>(request: object, call: (address: Address) => Address): T {
    return this.lend((scope) => this.result<T>(call(scope.putJson(request))));
  }

  protected result<T>(address: Address): T {
    return checked(readJson(this.module, readText(this.module, address)) as CallResult<T>);
  }

  /** Returns the result with its ranges, without copying the arrays. */
  protected rawResult<T>(address: Address): T {
    return checked(JSON.parse(readText(this.module, address)) as CallResult<T>);
  }
}

function checked<T>(result: CallResult<T>): T {
  if (!result.ok) throw new EngineError(result.code, result.message, placeOf(result));
  const { ok, ...value } = result;
  return value as T;
}

function instantiate<M extends WasmModule>(create: CreateWasmModule<M>, compiled: WebAssembly.Module): Promise<M> {
  return new Promise((resolve, reject) => {
    const instantiateWasm: Parameters<CreateWasmModule<M>>[0]['instantiateWasm'] = (imports, receive) => {
      // The generated glue does not notice a failure here, such as lack of memory. Its promise would never settle.
      WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled), reject);
      return {};
    };
    create({ instantiateWasm }).then(resolve, reject);
  });
}
