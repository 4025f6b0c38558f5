/** A shape on the caller's side: its worker, its request queue, and the data to encode it again. */
import type { CallOptions, Motion, MotionChange, Shape } from '../api/api.ts';
import { cancelled, disposed } from '../api/errors.ts';
import { METHOD } from '../api/methods.ts';
import { checkCall, checkRules, checkUpdate } from '../api/options.ts';
import { MOTION_DEFAULTS } from '../api/types.ts';
import type { EncodingOptions, Ghost, MotionOptions, SequenceStats } from '../api/types.ts';
import type { CoreCallName, KeyData, MotionSpec, MotionState, RequestOf, ResultOf } from '../wire/protocol.ts';
import { QUERIES, type QueryName } from '../wire/calls.ts';
import type { ExportSource } from './export-source.ts';
import { KeyArrays } from './keyframes.ts';
import { orderInParallel } from './parallel-ordering.ts';
import { Scheduler, urgency } from './scheduler.ts';
import type { CoreWorker, ShellsWorker, WorkerCall } from './worker-client.ts';

export interface ShapeParts {
  keys: KeyData;
  encoding: EncodingOptions;
  /** Starts a worker for this shape alone, with one thread. */
  freshWorker(): CoreWorker;
  /** Starts a worker that finds the elimination order of a large shape in parallel; null for small shapes. */
  workerBeside: (() => CoreWorker) | null;
  /** Starts a worker for exports. */
  filesWorker: ExportSource['filesWorker'];
  glbSize: ExportSource['glbSize'];
  shellsWorker(): ShellsWorker;
  motion(shape: ShapeClient, motion: MotionSpec, call?: CallOptions): Promise<Motion>;
  /** Encodes a shape that is derived from `shape` and ends with it. */
  derive(shape: ShapeClient, keys: KeyData, encoding: EncodingOptions, call: CallOptions): Promise<ShapeClient>;
  onDispose(shape: ShapeClient): void;
}

export class ShapeClient implements Shape {
  readonly scheduler = new Scheduler();
  private motions = 0;
  private hasLri = false;
  private over = false;

  private constructor(
    readonly parts: ShapeParts,
    private client: CoreWorker,
  ) {}

  /** Encodes the shape in `client`, which belongs to it from now on. */
  static async encode(parts: ShapeParts, client: CoreWorker, call: WorkerCall): Promise<ShapeClient> {
    await client.call('encode', encodeRequest(parts), call);
    return new ShapeClient(parts, client);
  }

  get options(): Readonly<EncodingOptions> {
    return this.parts.encoding;
  }

  async motion(change: MotionChange = {}, call?: CallOptions): Promise<Motion> {
    checkCall(call);
    const { motion, keyTimes } = checkUpdate(MOTION_DEFAULTS, change);
    const spec = this.spec(checkRules(motion, change).motion, keyTimes ?? this.parts.keys.info.times);
    return this.parts.motion(this, spec, call);
  }

  derive(keys: KeyData, encoding: EncodingOptions, call: CallOptions): Promise<ShapeClient> {
    return this.parts.derive(this, keys, encoding, call);
  }

  /** A motion that no worker has made yet. */
  spec(options: MotionOptions, keyTimes: readonly number[]): MotionSpec {
    return { number: ++this.motions, options, keyTimes: [...keyTimes] };
  }

  async make(motion: MotionSpec, call?: CallOptions): Promise<MotionState> {
    const needsLri = METHOD[motion.options.method].space !== 'vertices';
    const making =
      needsLri && !this.hasLri ? this.makeWithLri(motion, call) : this.ask('motion', { motion, order: null });
    const state = await making;
    if (state.warnings.length === 0) return state;
    const { withSentences } = await import('../api/sentences.ts');
    return { ...state, warnings: withSentences(state.warnings, motion.keyTimes.length, this.parts.keys.userKeys) };
  }

  /** Releases a motion in the worker. */
  drop(motion: MotionSpec): void {
    // A worker that has ended has nothing to release.
    if (!this.over && this.client.alive) this.client.call('drop', { motion }).catch(() => undefined);
  }

  async stats(): Promise<SequenceStats> {
    return this.query('stats', () => ({}));
  }

  async patches(): Promise<Int32Array> {
    return (await this.query('patches', () => ({}))).patchOf;
  }

  async components(): Promise<Int32Array> {
    return (await this.query('components', () => ({}))).componentOf;
  }

  async ghost(): Promise<Ghost | null> {
    const ghost = await this.query('ghost', () => ({}));
    return ghost.faces.length > 0 ? ghost : null;
  }

  rename(names: string[]): void {
    this.checkAlive();
    const { times } = this.parts.keys.info;
    this.parts.keys = new KeyArrays(this.parts.keys).arrange([...times.keys()], times, names).data;
  }

  dispose(): void {
    if (this.over) return;
    this.over = true;
    this.client.terminate(disposed('shape'));
    this.parts.onDispose(this);
  }

  checkAlive(): void {
    if (this.over) throw disposed('shape');
  }

  /** Sends a query through the queue. */
  async query<N extends QueryName>(name: N, request: () => RequestOf<N>): Promise<ResultOf<N>> {
    this.checkAlive();
    return this.scheduler.run(urgency[QUERIES[name].urgency], () => this.ask(name, request()));
  }

  /**
   * Sends one request. If the worker has died, starts a new one first and encodes the same keys again. The new worker
   * has one thread, in case the second thread caused the failure.
   */
  async ask<K extends CoreCallName>(type: K, request: RequestOf<K>, call?: WorkerCall): Promise<ResultOf<K>> {
    this.checkAlive();
    if (!this.client.alive) {
      this.client = this.parts.freshWorker();
      this.hasLri = false;
      await this.client.call('encode', encodeRequest(this.parts));
    }
    return this.client.call(type, request, call);
  }

  /**
   * The first motion in LRI space creates that space. Cancelling ends the worker; the next request starts a new one.
   */
  private async makeWithLri(motion: MotionSpec, call?: CallOptions): Promise<MotionState> {
    const { workerBeside } = this.parts;
    const beside = workerBeside && orderInParallel(workerBeside(), encodeRequest(this.parts));
    const cancel = (): void => this.client.terminate(cancelled());
    call?.signal?.addEventListener('abort', cancel, { once: true });
    try {
      const request = { motion, order: beside?.order ?? null };
      const state = await this.ask('motion', request, { onProgress: call?.onProgress });
      this.hasLri = true;
      return state;
    } finally {
      call?.signal?.removeEventListener('abort', cancel);
      beside?.end();
    }
  }
}

/** The input of an encoding. */
function encodeRequest({ keys, encoding }: ShapeParts): RequestOf<'encode'> {
  const { info, positions, normals } = keys;
  return { names: info.names, faces: info.faces, times: info.times, positions, normals, encoding };
}
