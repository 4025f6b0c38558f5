/** The engine over any kind of worker. A failed or cancelled task ends its worker. */
import type { CallOptions, Engine, Keys, Motion, Sequence, Shape, TimedFrames } from '../api/api.ts';
import { cancelled, disposed, invalidOption, untilAborted } from '../api/errors.ts';
import { FITTED_REGIONS, MAX_REGIONS } from '../api/option-table.ts';
import { checkImportSize } from '../api/import-size.ts';
import { LARGE, mayBeLarge } from '../api/large.ts';
import { KeyArrays } from './keyframes.ts';
import { withSpellings, withoutLeftovers } from '../api/paths.ts';
import { isFitted, OWN_METHOD } from '../api/methods.ts';
import { ENCODING_SHARE, partOf } from '../api/progress.ts';
import {
  checkCall,
  checkEncodingOptions,
  checkImportOptions,
  checkRules,
  checkSequenceOptions,
  encodingOf,
  motionOf,
} from '../api/options.ts';
import type { CallName, KeyData, MotionSpec, Program, WorkerFiles } from '../wire/protocol.ts';
import { keysOfMesh } from './key-mesh.ts';
import { WorkerClient, type CoreWorker, type FilesWorker, type ShellsWorker, type Spawn } from './worker-client.ts';
import { MotionClient, type MotionParts } from './motion.ts';
import { urgency } from './scheduler.ts';
import { SequenceClient } from './sequence.ts';
import { ShapeClient, type ShapeParts } from './shape.ts';
import { SEQUENCE_DEFAULTS } from '../api/types.ts';
import type {
  EncodingOptions,
  ImportOptions,
  InputFile,
  KeyMesh,
  MotionOptions,
  SequenceOptions,
  TimingFit,
} from '../api/types.ts';

export interface Platform {
  spawn: Spawn;
  /** The compiled core. */
  module: Promise<WebAssembly.Module>;
  /** The compiled module for files, fetched on first use, and again after a failure. */
  filesModule: () => Promise<WebAssembly.Module>;
  /** The same for fitted motions. */
  shellsModule: () => Promise<WebAssembly.Module>;
  /**
   * The core for two threads, fetched on first use. null if threads cannot share memory; resolves to null if it is
   * unavailable. Never rejects.
   */
  threaded?: (() => Promise<WebAssembly.Module | null>) | null;
  files?: WorkerFiles;
}

type AnyWorker = CoreWorker | FilesWorker | ShellsWorker;

export class EngineClient implements Engine {
  private readonly platform: Platform;
  private readonly workers = new Set<AnyWorker>();
  /** The shapes, with those that they are derived from. */
  private readonly shapes = new Map<ShapeClient, ShapeClient | null>();
  /** Idle workers that have read no invalid files. */
  private readonly idle: { core: CoreWorker | null; files: FilesWorker | null } = { core: null, files: null };
  private over = false;

  constructor(platform: Platform) {
    this.platform = platform;
    platform.module.catch(() => undefined); // The first call reports this error.
  }

  /** Starts a worker ahead of the first call, to save time. */
  warm(): void {
    this.checkAlive();
    this.idle.core ??= this.coreWorker();
  }

  warmFiles(): void {
    this.checkAlive();
    if (!this.idle.files?.alive) this.idle.files = this.filesWorker();
  }

  async importKeyframes(given: InputFile[], options?: ImportOptions, call?: CallOptions): Promise<Keys> {
    this.checkAlive();
    checkCall(call);
    const checked = checkImportOptions(options);
    checkFiles(given);
    const importable = withoutLeftovers(given);
    checkImportSize(bytesOf(importable));
    const files = withSpellings(importable);
    if (mayBeLarge(files)) void this.platform.threaded?.(); // Loads it in parallel with reading the keys.
    const imported = await this.inFilesWorker(call, mayBeLarge(files), (client) =>
      client.call('import', { files, options: checked }, { onProgress: call?.onProgress }),
    );
    const { project, times, warnings } = imported.info;
    imported.info.warnings = (await import('../api/sentences.ts')).withSentences(warnings, times.length);
    if (project) {
      const all = { ...SEQUENCE_DEFAULTS, ...project };
      const inherited = checkRules(motionOf(all), undefined);
      imported.info.project = { ...all, ...inherited.motion };
      imported.info.warnings.push(...inherited.warnings);
    }
    return new KeyArrays(imported);
  }

  async createKeys(mesh: KeyMesh, call?: CallOptions): Promise<Keys> {
    this.checkAlive();
    checkCall(call);
    const { info, ...poses } = keysOfMesh(mesh);
    const { names, times, faces } = info;
    const client = this.takeCore();
    const vertices = (poses.positions[0]?.length ?? 0) / 3;
    const [{ report }] = await this.task(client, call, () =>
      Promise.all([
        client.call('report', { names, times, faces, ...poses }),
        (mesh.scene ?? null) !== null && checkScene(info.scene, { faces, vertices }),
      ]),
    );
    this.idle.core = this.kept(client, this.idle.core);
    return new KeyArrays({ ...poses, info: { ...info, report } });
  }

  async encode(keys: Keys, options?: Partial<EncodingOptions>, call?: CallOptions): Promise<Shape> {
    return this.encoded({ keys: dataOf(keys), encoding: checkEncodingOptions(options) }, call, async (shape) => shape);
  }

  async createSequence(keys: Keys, options?: Partial<SequenceOptions>, call?: CallOptions): Promise<Sequence> {
    const checked = checkSequenceOptions(options);
    const { motion } = checkRules(motionOf(checked), options);
    const report = call?.onProgress ?? (() => undefined);
    const part = (from: number, to: number): CallOptions => ({ ...call, onProgress: partOf(report, from, to) });
    const encoding = encodingOf(checked);
    return this.encoded({ keys: dataOf(keys), encoding }, part(0, ENCODING_SHARE), async (shape) => {
      if (isFitted(motion)) (await fitting()).refuseTangents(motion, encoding);
      const spec = shape.spec(motion, shape.parts.keys.info.times);
      return new SequenceClient(...(await motionParts(shape, spec, part(ENCODING_SHARE, 1))));
    });
  }

  async fitTiming(
    motion: Motion,
    animation: TimedFrames,
    { regions = FITTED_REGIONS }: { regions?: number } = {},
    call?: CallOptions,
  ): Promise<TimingFit | null> {
    this.checkAlive();
    checkCall(call);
    const { shape, options, keyTimes } = motion;
    const isOwn = shape instanceof ShapeClient && this.shapes.has(shape);
    if (!isOwn || options.method !== OWN_METHOD || options.keepLengths > 0)
      throw invalidOption(`A timing can be fitted to motions of this engine with the method '${OWN_METHOD}' only.`);
    if (!Number.isInteger(regions) || regions < 1 || regions > MAX_REGIONS)
      throw invalidOption(`The number of regions must be a whole number from 1 to ${MAX_REGIONS}, not ${regions}.`);
    const { fitTiming } = await import('../timing/timing-fit.ts');
    // Holding and pins move the shapes after the spline, and the travel belongs to the animation.
    const plain: MotionOptions = { ...motionOf(options), hold: 'off', pins: [], inPlace: false };
    const keys = new KeyArrays(shape.parts.keys);
    return fitTiming({ engine: this, keys, shape, times: keyTimes, options: plain, animation }, regions, call);
  }

  dispose(): void {
    if (this.over) return;
    this.over = true;
    for (const shape of this.shapes.keys()) shape.dispose();
    for (const worker of this.workers) worker.terminate(disposed('engine'));
    this.workers.clear();
  }

  /** Encodes the keys and calls `goOn` with the shape. Disposes of the shape if that fails or is cancelled. */
  private async encoded<T>(
    { keys, encoding, from }: { keys: KeyData; encoding: EncodingOptions; from?: ShapeClient },
    call: CallOptions | undefined,
    goOn: (shape: ShapeClient) => Promise<T>,
  ): Promise<T> {
    this.checkAlive();
    checkCall(call);
    const large = keys.info.report.vertices >= LARGE;
    const inTwo = large && Boolean(this.platform.threaded);
    const parts: ShapeParts = {
      keys,
      encoding,
      freshWorker: () => this.coreWorker(),
      workerBeside: inTwo ? () => this.takeCore() : null,
      filesWorker: () => this.filesWorker(),
      glbSize: (request) => this.inFilesWorker(undefined, large, (one) => one.call('glbSize', request)),
      shellsWorker: () => this.started(this.program('shells', this.platform.shellsModule())),
      motion: async (...motion) => new MotionClient(...(await motionParts(...motion))),
      derive: (shape, other, options, rest) =>
        this.encoded({ keys: other, encoding: options, from: shape }, rest, async (derived) => derived),
      onDispose: (gone) => {
        this.shapes.delete(gone);
        for (const [shape, origin] of this.shapes) if (origin === gone) shape.dispose();
      },
    };
    const client = inTwo ? this.coreWorker(true) : this.takeCore();
    return this.task(client, call, async () => {
      const shape = await ShapeClient.encode(parts, client, { onProgress: call?.onProgress });
      const made = await goOn(shape);
      this.shapes.set(shape, from ?? null);
      return made;
    });
  }

  private takeCore(): CoreWorker {
    const { core } = this.idle;
    this.idle.core = null;
    return core?.alive ? core : this.coreWorker();
  }

  /**
   * Runs work in an exclusive worker for files. `large`: ends the worker afterwards, because its memory never shrinks.
   */
  private async inFilesWorker<T>(
    call: CallOptions | undefined,
    large: boolean,
    work: (client: FilesWorker) => Promise<T>,
  ): Promise<T> {
    const { files } = this.idle;
    this.idle.files = null;
    const client = files?.alive ? files : this.filesWorker();
    const result = await this.task(client, call, () => work(client));
    if (large) client.terminate(disposed('engine'));
    else this.idle.files = this.kept(client, this.idle.files);
    return result;
  }

  private coreWorker(large = false): CoreWorker {
    return this.started(this.coreProgram(large));
  }

  /** Reports a core that cannot be loaded first, because reading files would be useless. */
  private filesWorker(): FilesWorker {
    const { module, filesModule } = this.platform;
    const files = filesModule();
    files.catch(() => undefined); // The first call reports this error.
    return this.started(
      this.program(
        'files',
        module.then(() => files),
      ),
    );
  }

  private started<Name extends CallName>(program: Promise<Program>): WorkerClient<Name> {
    this.checkAlive();
    for (const worker of this.workers) if (!worker.alive) this.workers.delete(worker);
    const client = new WorkerClient<Name>(this.platform.spawn, program);
    this.workers.add(client as AnyWorker);
    return client;
  }

  private async coreProgram(large: boolean): Promise<Program> {
    const threaded = large ? await this.platform.threaded?.() : null;
    return this.program('core', this.platform.module, threaded);
  }

  private async program(
    kind: Program['kind'],
    module: Promise<WebAssembly.Module>,
    threaded: WebAssembly.Module | null = null,
  ): Promise<Program> {
    return { kind, module: await module, threaded, files: this.platform.files ?? {} };
  }

  /** Runs work in one worker, which ends if the work fails or is cancelled. */
  private async task<T>(client: AnyWorker, call: CallOptions | undefined, work: () => Promise<T>): Promise<T> {
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

  /**
   * Keeps this worker if there is no idle one yet and the engine is in use; otherwise ends it. Returns the idle worker.
   */
  private kept<W extends AnyWorker>(client: W, idle: W | null): W | null {
    if (!idle?.alive && !this.over) return client;
    client.terminate(disposed('engine'));
    return idle;
  }

  private checkAlive(): void {
    if (this.over) throw disposed('engine');
  }
}

/** Fits are loaded on demand, because most motions have none. */
const fitting = () => import('./fitted-motion.ts');

/** Makes a motion in its shape's worker. A motion with fitted shapes gets a derived shape. */
async function motionParts(shape: ShapeClient, spec: MotionSpec, call?: CallOptions): Promise<MotionParts> {
  if (isFitted(spec.options)) return (await fitting()).fitMotion(shape, spec, call);
  const made = shape.scheduler.run(urgency.shown, () => shape.make(spec, call), call?.signal);
  return [shape, spec, await untilAborted(call?.signal, made)];
}

function dataOf(keys: Keys): KeyData {
  if (keys instanceof KeyArrays) return keys.data;
  throw invalidOption('The keys must come from importKeyframes or createKeys of this engine.');
}

/** The checks are loaded on demand, because most callers give no scene. */
async function checkScene(...given: Parameters<typeof import('./check-scene.ts')['checkScene']>): Promise<void> {
  (await import('./check-scene.ts')).checkScene(...given);
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

/** Runs the work on first use and caches its result, unless it failed. */
export function onlyOnce<T>(work: () => Promise<T>): () => Promise<T> {
  let result: Promise<T> | null = null;
  const fail = (error: unknown): never => {
    result = null;
    throw error;
  };
  return () => (result ??= work().catch(fail));
}
