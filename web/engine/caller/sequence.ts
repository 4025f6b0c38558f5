/** A sequence on the caller's side: its worker, the motion that is meant, and what it takes to build it again. */
import type { AheadOptions, CallOptions, Sequence } from '../api/api.ts';
import { disposed, untilAborted, type EngineError } from '../api/errors.ts';
import type { ExportSource } from './export-source.ts';
import {
  checkCall,
  checkExportOptions,
  checkFace,
  checkSamples,
  checkTime,
  checkTimes,
  checkUpdate,
  checkWeights,
  encodingOf,
  motionOf,
} from '../api/options.ts';
import { FramePool } from './frame-pool.ts';
import type { CallName, FrameBuffers, KeyData, MotionSpec, RequestOf, ResultOf } from '../wire/protocol.ts';
import type { SharedOrder } from '../wire/shared-order.ts';
import type { WorkerClient, WorkerCall } from './worker-client.ts';
import { Scheduler, urgency, type Task, type Urgency } from './scheduler.ts';
import type {
  DiscretePath,
  EncodingOptions,
  ExportedFile,
  ExportOptions,
  ExportPlan,
  FaceCurve,
  Frame,
  Ghost,
  Measures,
  MotionOptions,
  SequenceOptions,
  SequenceStats,
  KeyPace,
  MotionPace,
  PatchCurve,
  ShapePlane,
  Warning,
} from '../api/types.ts';

export interface SequenceParts {
  keys: KeyData;
  options: SequenceOptions;
  /** Starts a worker that no other sequence uses, with one thread. */
  freshWorker(): WorkerClient;
  onDispose(sequence: SequenceClient): void;
}

interface Shown {
  task: Task;
  supersede(): void;
}

/** Loaded with the first export: most visits to the page never make one. */
const exporting = () => import('./export.ts');

export class SequenceClient implements Sequence {
  private readonly parts: SequenceParts;
  private readonly encoding: EncodingOptions;
  private readonly scheduler = new Scheduler();
  private readonly pool = new FramePool();
  private client: WorkerClient;
  private motion: MotionSpec;
  private versions = 0;
  private state: ResultOf<'create'>;
  private shown: Shown | null = null;
  private updates: Promise<unknown> = Promise.resolve();
  private over = false;
  /** Of the last export that was planned. */
  private readonly planned: ExportSource['planned'] = { latest: null };

  private constructor(parts: SequenceParts, client: WorkerClient, motion: MotionSpec, state: ResultOf<'create'>) {
    this.parts = parts;
    this.encoding = encodingOf(parts.options);
    this.client = client;
    this.motion = motion;
    this.state = state;
  }

  /** Builds it in `client`, which is the sequence's own from here on. */
  static async create(
    parts: SequenceParts,
    client: WorkerClient,
    order: SharedOrder | null,
    call: WorkerCall,
  ): Promise<SequenceClient> {
    const request = requestOf(parts);
    const state = await client.call('create', { ...request, order }, call);
    return new SequenceClient(parts, client, request.motion, state);
  }

  get options(): Readonly<SequenceOptions> {
    return { ...this.encoding, ...this.motion.options };
  }

  get keyTimes(): readonly number[] {
    return this.motion.keyTimes;
  }

  get range(): readonly [number, number] {
    return this.state.range;
  }

  get warnings(): readonly Warning[] {
    return this.state.warnings;
  }

  async evaluate(t: number): Promise<Frame | null> {
    this.checkAlive();
    checkTime(t);
    return this.latest(() => this.frame(t, this.motion));
  }

  /** null where a newer one overtakes it. */
  private async latest(make: () => Promise<Frame>): Promise<Frame | null> {
    this.supersede();
    return new Promise<Frame | null>((resolve, reject) => {
      const task: Task = {
        urgency: urgency.shown,
        start: () => {
          this.shown = null;
          return make().then(resolve, (error: EngineError) =>
            error.code === 'disposed' ? resolve(null) : reject(error),
          );
        },
      };
      this.shown = { task, supersede: () => resolve(null) };
      this.scheduler.add(task);
    });
  }

  async evaluateBlend(weights: readonly number[]): Promise<Frame | null> {
    this.checkAlive();
    const checked = checkWeights(weights, this.motion.keyTimes.length);
    return this.latest(() => this.blendFrame(checked, this.motion));
  }

  async evaluateAhead(t: number, { signal }: AheadOptions = {}): Promise<Frame> {
    this.checkAlive();
    checkTime(t);
    return this.scheduler.run(urgency.ahead, () => this.frame(t, this.motion), signal);
  }

  async evaluateMany(times: number[], call?: CallOptions): Promise<Frame[]> {
    checkCall(call);
    checkTimes(times);
    const motion = await this.settledMotion();
    const frames: Frame[] = [];
    await this.each(times, call, async (t) => {
      frames.push(await this.batch(() => this.frame(t, motion)));
    });
    return frames;
  }

  async update(change: Partial<MotionOptions> & { keyTimes?: number[] }): Promise<void> {
    this.checkAlive();
    const work = this.scheduler.run(urgency.shown, async () => {
      const { motion: options, keyTimes } = checkUpdate(this.motion.options, change);
      const motion: MotionSpec = { version: ++this.versions, options, keyTimes: keyTimes ?? this.motion.keyTimes };
      this.state = await this.ask('update', { motion });
      this.motion = motion;
    });
    this.updates = work.catch(() => undefined);
    return work;
  }

  async stats(): Promise<SequenceStats> {
    return this.scheduled(urgency.shown, 'stats', () => ({}));
  }

  async measures(times: number[], call?: CallOptions): Promise<Measures> {
    checkCall(call);
    const measures: Measures = { times: checkTimes(times), volume: [], area: [], sliding: [] };
    const motion = await this.settledMotion();
    for (let done = 0; done < times.length; done = measures.volume.length) {
      const next = this.batch(() => this.ask('measure', { motion, times: times.slice(done) }));
      for (const { volume, area, sliding } of await untilAborted(call?.signal, next)) {
        measures.volume.push(volume);
        measures.area.push(area);
        measures.sliding.push(sliding === null ? NaN : 100 * sliding);
      }
      call?.onProgress?.({ stage: 'evaluating', fraction: measures.volume.length / times.length });
    }
    return measures;
  }

  async shapePlane(times: number[]): Promise<ShapePlane> {
    const checked = checkTimes(times);
    return this.scheduled(urgency.shown, 'plane', () => ({ motion: this.motion, times: checked }));
  }

  async discretePath(samples: number): Promise<DiscretePath> {
    const checked = checkSamples(samples);
    return this.scheduled(urgency.shown, 'discretePath', () => ({ motion: this.motion, samples: checked }));
  }

  async faceCurve(face: number, times: number[]): Promise<FaceCurve> {
    const checked = { face: checkFace(face, this.parts.keys.info.report.faces), times: checkTimes(times) };
    return this.scheduled(urgency.shown, 'faceCurve', () => ({ motion: this.motion, ...checked }));
  }

  async patchCurve(patch: number, times: number[]): Promise<PatchCurve> {
    const checked = { patch: checkFace(patch, this.parts.keys.info.report.faces, 'patch'), times: checkTimes(times) };
    return this.scheduled(urgency.shown, 'patchCurve', () => ({ motion: this.motion, ...checked }));
  }

  async keyPace(): Promise<KeyPace> {
    return this.scheduled(urgency.shown, 'pace', () => ({ motion: this.motion }));
  }

  async motionPace(times: number[]): Promise<MotionPace> {
    const checked = checkTimes(times);
    return this.scheduled(urgency.batch, 'motionPace', () => ({ motion: this.motion, times: checked }));
  }

  async bendingEnergy(times: number[]): Promise<number[]> {
    const checked = checkTimes(times);
    return this.scheduled(urgency.shown, 'bending', () => ({ motion: this.motion, times: checked }));
  }

  async patches(): Promise<Int32Array> {
    return this.scheduled(urgency.shown, 'patches', () => ({}));
  }

  async components(): Promise<Int32Array> {
    return this.scheduled(urgency.shown, 'components', () => ({}));
  }

  async ghost(): Promise<Ghost | null> {
    return this.scheduled(urgency.shown, 'ghost', () => ({}));
  }

  async ghostPositions(t: number): Promise<Float32Array> {
    const checked = checkTime(t);
    return this.scheduled(urgency.shown, 'ghostPositions', () => ({ motion: this.motion, t: checked }));
  }

  async planExport(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportPlan> {
    checkCall(call);
    const checked = checkExportOptions(options);
    const { planExport } = await exporting();
    return planExport(await this.exportSource(checked), checked, call);
  }

  async export(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportedFile[]> {
    const files: ExportedFile[] = [];
    for await (const file of this.exportFiles(options, call)) files.push(file);
    return files;
  }

  async *exportFiles(options?: Partial<ExportOptions>, call?: CallOptions): AsyncGenerator<ExportedFile> {
    checkCall(call);
    const checked = checkExportOptions(options);
    const { exportFiles } = await exporting();
    yield* exportFiles(await this.exportSource(checked), checked, call ?? {});
  }

  dispose(): void {
    if (this.over) return;
    this.over = true;
    this.supersede();
    this.client.terminate(disposed('sequence'));
    this.parts.onDispose(this);
  }

  private supersede(): void {
    if (this.shown && this.scheduler.withdraw(this.shown.task)) this.shown.supersede();
    this.shown = null;
  }

  private checkAlive(): void {
    if (this.over) throw disposed('sequence');
  }

  /** The motion after all updates that were asked for so far. */
  private async settledMotion(): Promise<MotionSpec> {
    await this.updates;
    this.checkAlive();
    return this.motion;
  }

  private async frame(t: number, motion: MotionSpec): Promise<Frame> {
    const { buffers, transfer } = this.spare();
    return this.pool.frame(t, await this.ask('evaluate', { motion, t, buffers }, { transfer }));
  }

  private async blendFrame(weights: number[], motion: MotionSpec): Promise<Frame> {
    const { buffers, transfer } = this.spare();
    return this.pool.frame(NaN, await this.ask('blend', { motion, weights, buffers }, { transfer }));
  }

  private spare(): { buffers: FrameBuffers | null; transfer: ArrayBuffer[] } {
    const buffers = this.pool.take();
    const transfer = buffers ? [buffers.positions.buffer, buffers.normals.buffer] : [];
    return { buffers, transfer: transfer as ArrayBuffer[] };
  }

  /**
   * One request; a worker that died before is replaced first, built from the same keys and the present motion. If the
   * second thread was the reason, it would be again: the new worker has one thread.
   */
  private async ask<K extends CallName>(type: K, request: RequestOf<K>, call?: WorkerCall): Promise<ResultOf<K>> {
    this.checkAlive();
    if (!this.client.alive) await this.revive();
    return this.client.call(type, request, call);
  }

  private async revive(): Promise<void> {
    this.client = this.parts.freshWorker();
    const request = createRequest(this.parts.keys, this.encoding, this.motion);
    this.state = await this.client.call('create', { ...request, order: null });
  }

  private async scheduled<K extends CallName>(
    level: Urgency,
    type: K,
    request: () => RequestOf<K>,
  ): Promise<ResultOf<K>> {
    this.checkAlive();
    return this.scheduler.run(level, () => this.ask(type, request()));
  }

  private batch<T>(work: () => Promise<T>): Promise<T> {
    return this.scheduler.run(urgency.batch, work);
  }

  /** One step after the other, with progress, until all are done or the caller cancels. */
  private async each(
    times: number[],
    call: CallOptions | undefined,
    step: (t: number) => Promise<void>,
  ): Promise<void> {
    for (const [index, t] of times.entries()) {
      await untilAborted(call?.signal, step(t));
      call?.onProgress?.({ stage: 'evaluating', fraction: (index + 1) / times.length });
    }
  }

  private async exportSource({ inPlace, blend }: ExportOptions): Promise<ExportSource> {
    const weights = blend && checkWeights(blend, this.motion.keyTimes.length);
    const settled = await this.settledMotion();
    const motion =
      inPlace && !settled.options.inPlace
        ? { ...settled, version: ++this.versions, options: { ...settled.options, inPlace } }
        : settled;
    return {
      planned: this.planned,
      keys: this.parts.keys,
      keyTimes: motion.keyTimes,
      options: { ...this.encoding, ...motion.options },
      range: this.range,
      freshWorker: this.parts.freshWorker,
      frame: (t) => this.batch(() => (weights ? this.blendFrame(weights, motion) : this.frame(t, motion))),
      glbSize: (faces, vertices, frames, scene) =>
        this.scheduled(urgency.shown, 'glbSize', () => ({ faces, vertices, frames, scene })),
    };
  }
}

/** What a sequence is first made of. */
export function requestOf({ keys, options }: Pick<SequenceParts, 'keys' | 'options'>): CreateRequest {
  return createRequest(keys, encodingOf(options), {
    version: 0,
    options: motionOf(options),
    keyTimes: keys.info.times,
  });
}

type CreateRequest = Omit<RequestOf<'create'>, 'order'>;

function createRequest(
  { info: { names, faces }, positions, normals }: KeyData,
  encoding: EncodingOptions,
  motion: MotionSpec,
): CreateRequest {
  return { names, faces, positions, normals, encoding, motion };
}
