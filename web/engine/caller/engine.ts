/** The engine over any kind of worker. A task that fails or is cancelled takes its worker with it. */
import type { CallOptions, Engine, Keys, Sequence, Shape } from '../api/api.ts';
import { cancelled, disposed, invalidOption } from '../api/errors.ts';
import { checkImportSize } from '../api/import-size.ts';
import { LARGE, mayBeLarge } from '../api/large.ts';
import { KeysHandle } from './keyframes.ts';
import { withoutLeftovers } from '../api/paths.ts';
import { ENCODING_SHARE, partOf } from '../api/progress.ts';
import {
  checkCall,
  checkEncodingOptions,
  checkImportOptions,
  checkSequenceOptions,
  encodingOf,
  motionOf,
} from '../api/options.ts';
import type { Program, WorkerFiles } from '../wire/protocol.ts';
import { WorkerClient, type Spawn } from './worker-client.ts';
import { SequenceClient } from './sequence.ts';
import { ShapeClient, type ShapeParts } from './shape.ts';
import type { EncodingOptions, ImportOptions, InputFile, SequenceOptions } from '../api/types.ts';

export interface Platform {
  spawn: Spawn;
  /** The compiled wasm, fetched once. */
  module: Promise<WebAssembly.Module>;
  /**
   * The same for two threads, fetched when it is first asked for; null where threads cannot share memory, and its
   * result where it cannot be had soon. Never rejects.
   */
  threaded?: (() => Promise<WebAssembly.Module | null>) | null;
  files?: WorkerFiles;
}

export class EngineClient implements Engine {
  private readonly platform: Platform;
  private readonly workers = new Set<WorkerClient>();
  private readonly shapes = new Set<ShapeClient>();
  /** A worker that has nothing to do and read nothing bad. */
  private idle: WorkerClient | null = null;
  private over = false;

  constructor(platform: Platform) {
    this.platform = platform;
    platform.module.catch(() => undefined); // said by the first call
  }

  /** Starts a worker ahead of the first call, which then need not wait for it. */
  warm(): void {
    this.checkAlive();
    this.idle ??= this.freshWorker();
  }

  async importKeyframes(given: InputFile[], options?: ImportOptions, call?: CallOptions): Promise<Keys> {
    this.checkAlive();
    checkCall(call);
    const checked = checkImportOptions(options);
    checkFiles(given);
    const files = withoutLeftovers(given);
    checkImportSize(bytesOf(files));
    if (mayBeLarge(files)) void this.platform.threaded?.(); // to be there when the keys are
    const client = this.takeWorker();
    const imported = await this.task(client, call, () =>
      client.call('import', { files, options: checked }, { onProgress: call?.onProgress }),
    );
    this.keepIdle(client);
    return new KeysHandle(imported);
  }

  async encode(keys: Keys, options?: Partial<EncodingOptions>, call?: CallOptions): Promise<Shape> {
    return this.encoded(keys, checkEncodingOptions(options), call, call?.onProgress, async (shape) => shape);
  }

  async createSequence(keys: Keys, options?: Partial<SequenceOptions>, call?: CallOptions): Promise<Sequence> {
    const checked = checkSequenceOptions(options);
    const report = call?.onProgress ?? (() => undefined);
    return this.encoded(keys, encodingOf(checked), call, partOf(report, 0, ENCODING_SHARE), async (shape) => {
      const spec = shape.spec(motionOf(checked), shape.parts.keys.info.times);
      const state = await shape.make(spec, { onProgress: partOf(report, ENCODING_SHARE, 1) });
      return new SequenceClient(shape, spec, state);
    });
  }

  dispose(): void {
    if (this.over) return;
    this.over = true;
    for (const shape of this.shapes) shape.dispose();
    for (const worker of this.workers) worker.terminate(disposed('engine'));
    this.workers.clear();
  }

  /** Encodes the keys and goes on with the shape; cancelled or failed, neither is left. */
  private async encoded<T>(
    keys: Keys,
    encoding: EncodingOptions,
    call: CallOptions | undefined,
    onProgress: CallOptions['onProgress'],
    goOn: (shape: ShapeClient) => Promise<T>,
  ): Promise<T> {
    this.checkAlive();
    checkCall(call);
    if (!(keys instanceof KeysHandle)) throw invalidOption('The keys must come from importKeyframes of this engine.');
    const large = Boolean(this.platform.threaded) && keys.info.report.vertices >= LARGE;
    const parts: ShapeParts = {
      keys: keys.data,
      encoding,
      freshWorker: () => this.freshWorker(),
      // What read the files has the memory for it already.
      workerBeside: large ? () => this.takeWorker() : null,
      onDispose: (gone) => void this.shapes.delete(gone),
    };
    const client = large ? this.freshWorker(large) : this.takeWorker();
    return this.task(client, call, async () => {
      const shape = await ShapeClient.encode(parts, client, { onProgress });
      const made = await goOn(shape);
      this.shapes.add(shape);
      return made;
    });
  }

  private takeWorker(): WorkerClient {
    const { idle } = this;
    this.idle = null;
    return idle?.alive ? idle : this.freshWorker();
  }

  private freshWorker(large = false): WorkerClient {
    this.checkAlive();
    for (const worker of this.workers) if (!worker.alive) this.workers.delete(worker);
    const client = new WorkerClient(this.platform.spawn, this.program(large));
    this.workers.add(client);
    return client;
  }

  private async program(large: boolean): Promise<Program> {
    const threaded = large ? await this.platform.threaded?.() : null;
    const { module, files = {} } = this.platform;
    return { module: await module, threaded: threaded ?? null, files };
  }

  /** Work in one worker, which ends when the work fails or the caller cancels. */
  private async task<T>(client: WorkerClient, call: CallOptions | undefined, work: () => Promise<T>): Promise<T> {
    const cancel = (): void => client.terminate(cancelled());
    const signal = call?.signal;
    if (signal?.aborted) cancel();
    signal?.addEventListener('abort', cancel, { once: true });
    try {
      return await work();
    } catch (error) {
      client.terminate(cancelled());
      throw error;
    } finally {
      signal?.removeEventListener('abort', cancel);
    }
  }

  private keepIdle(client: WorkerClient): void {
    if (this.idle || this.over) client.terminate(disposed('engine'));
    else this.idle = client;
  }

  private checkAlive(): void {
    if (this.over) throw disposed('engine');
  }
}

function checkFiles(files: unknown): void {
  const good = (file: unknown): boolean => {
    const { name, bytes } = (file ?? {}) as Partial<InputFile>;
    return typeof name === 'string' && bytes instanceof Uint8Array;
  };
  if (!Array.isArray(files) || files.length === 0 || !files.every(good)) {
    throw invalidOption('Give at least one file as { name, bytes: Uint8Array }.');
  }
}

function bytesOf(files: InputFile[]): number {
  return files.reduce((sum, { bytes }) => sum + bytes.length, 0);
}

/** Does the work when it is first asked for, and remembers what came of it. */
export function onlyOnce<T>(work: () => Promise<T>): () => Promise<T> {
  let result: Promise<T> | null = null;
  return () => (result ??= work());
}
