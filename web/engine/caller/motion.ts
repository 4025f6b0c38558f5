/** A motion of a shape on the caller's side. */
import type { AheadOptions, CallOptions, Motion } from '../api/api.ts';
import { disposed, untilAborted, type EngineError } from '../api/errors.ts';
import {
  checkCall,
  checkExportOptions,
  checkFace,
  checkSamples,
  checkTime,
  checkTimes,
  checkWeights,
} from '../api/options.ts';
import type {
  DiscretePath,
  ExportedFile,
  ExportOptions,
  ExportPlan,
  FaceCurve,
  Frame,
  KeySpacing,
  Measures,
  MotionSpeed,
  PatchCurve,
  SequenceOptions,
  ShapePlane,
  TimingDerivatives,
  Warning,
} from '../api/types.ts';
import type { QueryInput, QUERIES, QueryName } from '../wire/calls.ts';
import type { FrameBuffers, MotionSpec, MotionState, RequestOf, ResultOf } from '../wire/protocol.ts';
import type { ExportSource } from './export-source.ts';
import { FramePool } from './frame-pool.ts';
import { urgency, type Task } from './scheduler.ts';
import type { ShapeClient } from './shape.ts';
import type { UserKeys } from './user-keys.ts';

interface Shown {
  task: Task;
  supersede(): void;
}

/** A motion through the keys of its shape, or of the shape from which that shape was derived. */
export type MotionParts = readonly [shape: ShapeClient, spec: MotionSpec, state: MotionState, user?: UserKeys];

/** The queries about a motion. */
type MotionQuery = {
  [N in QueryName]: (typeof QUERIES)[N]['of'] extends 'motion' ? N : never;
}[QueryName];

/** Longest delay of a frame by measures, unless a single measure takes longer. */
const AT_ONCE_MS = 10;

/** The export code is loaded with the first export, because most visits make none. */
const exporting = () => import('./export.ts');

export class MotionClient implements Motion {
  protected readonly what: string = 'motion';
  private readonly pool = new FramePool();
  private shown: Shown | null = null;
  private over = false;
  /** The last planned export. */
  private readonly planned: ExportSource['planned'] = { latest: null };

  constructor(
    readonly shape: ShapeClient,
    public spec: MotionSpec,
    protected state: MotionState,
    protected readonly user: UserKeys | null = null,
  ) {}

  get options(): Readonly<SequenceOptions> {
    const { shape, spec } = this.asked;
    return { ...shape.options, ...spec.options };
  }

  get keyTimes(): readonly number[] {
    return this.asked.spec.keyTimes;
  }

  get range(): readonly [number, number] {
    return this.state.range;
  }

  get warnings(): readonly Warning[] {
    return this.state.warnings;
  }

  get fitted(): readonly boolean[] | null {
    return this.user?.intervals ?? null;
  }

  async evaluate(t: number): Promise<Frame | null> {
    this.checkAlive();
    checkTime(t);
    return this.latest(() => this.frame(t, this.spec));
  }

  async evaluateBlend(weights: readonly number[]): Promise<Frame | null> {
    this.checkAlive();
    const checked = this.checkBlend(weights);
    return this.latest(() => this.blendFrame(checked, this.spec));
  }

  async evaluateAhead(t: number, { signal }: AheadOptions = {}): Promise<Frame> {
    this.checkAlive();
    checkTime(t);
    return this.shape.scheduler.run(urgency.ahead, () => this.frame(t, this.spec), signal);
  }

  async evaluateMany(times: number[], call?: CallOptions): Promise<Frame[]> {
    checkCall(call);
    const checked = checkTimes(times);
    const motion = await this.settled();
    const frames: Frame[] = [];
    for (const t of checked) {
      frames.push(
        await untilAborted(
          call?.signal,
          this.batch(() => this.frame(t, motion)),
        ),
      );
      call?.onProgress?.({ stage: 'evaluating', fraction: frames.length / checked.length });
    }
    return frames;
  }

  async measures(times: number[], call?: CallOptions): Promise<Measures> {
    checkCall(call);
    const checked = checkTimes(times);
    const measures: Measures = { times: checked, volume: [], area: [], sliding: [] };
    const motion = await this.settled();
    for (let done = 0; done < checked.length; done = measures.volume.length) {
      const rest = { motion, times: checked.slice(done), maxMs: AT_ONCE_MS };
      const next = this.shape.query('measure', () => rest);
      const { volume, area, sliding } = await untilAborted(call?.signal, next);
      measures.volume.push(...volume);
      measures.area.push(...area);
      measures.sliding.push(...sliding.map((share) => (share === null ? NaN : 100 * share)));
      call?.onProgress?.({ stage: 'evaluating', fraction: measures.volume.length / checked.length });
    }
    return measures;
  }

  async shapePlane(times: number[]): Promise<ShapePlane> {
    const checked = checkTimes(times);
    if (!this.user) return this.ask('plane', { times: checked, shape: null });
    return this.user.plane(checked, (t) => this.batch(() => this.frame(t, this.spec)));
  }

  async discretePath(samples: number): Promise<DiscretePath> {
    return this.ask('discretePath', { samples: checkSamples(samples) });
  }

  async faceCurve(face: number, times: number[]): Promise<FaceCurve> {
    return this.ask('faceCurve', { face: checkFace(face, this.faces), times: checkTimes(times) });
  }

  async patchCurve(patch: number, times: number[]): Promise<PatchCurve> {
    return this.ask('patchCurve', { patch: checkFace(patch, this.faces, 'patch'), times: checkTimes(times) });
  }

  async keySpacing(): Promise<KeySpacing> {
    return this.user ? this.user.spacing() : this.ask('keySpacing', {});
  }

  async motionSpeed(times: number[]): Promise<MotionSpeed> {
    return this.ask('motionSpeed', { times: checkTimes(times) });
  }

  async bendingEnergy(times: number[]): Promise<number[]> {
    const { energy } = await this.ask('bending', { times: checkTimes(times) });
    return this.user ? this.user.relative(energy, await this.ask('keySpacing', {})) : energy;
  }

  async shellBending(times: number[], call: CallOptions = {}): Promise<number[]> {
    checkCall(call);
    const checked = checkTimes(times);
    const motion = await this.settled();
    const { shellBending } = await import('./shell-bending.ts');
    const frame = (t: number): Promise<Frame> => this.batch(() => this.frame(t, motion));
    return shellBending(this.asked.shape, { range: this.range, frame }, checked, call);
  }

  async timingDerivatives(t: number, regionOf: number[]): Promise<TimingDerivatives> {
    return this.ask('timingDerivatives', { t: checkTime(t), regionOf });
  }

  async ghostPositions(t: number): Promise<Float32Array> {
    return (await this.ask('ghostPositions', { t: checkTime(t) })).positions;
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
    this.shape.drop(this.spec);
    this.user?.end(this.shape);
  }

  protected checkAlive(): void {
    if (this.over) throw disposed(this.what);
    this.shape.checkAlive();
  }

  /** The motion for all later requests. */
  protected async settled(): Promise<MotionSpec> {
    this.checkAlive();
    return this.spec;
  }

  /** The shape of the user's keys, and the options and times of the motion as given. */
  protected get asked(): { shape: ShapeClient; spec: MotionSpec } {
    return this.user ?? this;
  }

  private checkBlend(weights: readonly number[]): number[] {
    this.user?.refuseBlend();
    return checkWeights(weights, this.keyTimes.length);
  }

  private get faces(): number {
    return this.shape.parts.keys.info.report.faces;
  }

  /** Asks about the motion that is current when the request is sent. */
  private async ask<N extends MotionQuery>(name: N, asked: QueryInput<N>): Promise<ResultOf<N>> {
    this.checkAlive();
    return this.shape.query(name, () => ({ ...asked, motion: this.spec }) as RequestOf<N>);
  }

  /** Requests a frame; null if a newer request replaces it. */
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
      this.shape.scheduler.add(task);
    });
  }

  private supersede(): void {
    if (this.shown && this.shape.scheduler.withdraw(this.shown.task)) this.shown.supersede();
    this.shown = null;
  }

  private async frame(t: number, motion: MotionSpec): Promise<Frame> {
    const { buffers, transfer } = this.spare();
    return this.pool.frame(t, await this.shape.ask('evaluate', { motion, t, buffers }, { transfer }));
  }

  private async blendFrame(weights: number[], motion: MotionSpec): Promise<Frame> {
    const { buffers, transfer } = this.spare();
    return this.pool.frame(NaN, await this.shape.ask('blend', { motion, weights, buffers }, { transfer }));
  }

  private spare(): { buffers: FrameBuffers | null; transfer: ArrayBuffer[] } {
    const buffers = this.pool.take();
    const transfer = buffers ? [buffers.positions.buffer, buffers.normals.buffer] : [];
    return { buffers, transfer: transfer as ArrayBuffer[] };
  }

  private batch<T>(work: () => Promise<T>): Promise<T> {
    return this.shape.scheduler.run(urgency.batch, work);
  }

  private async exportSource({ inPlace, blend }: ExportOptions): Promise<ExportSource> {
    const weights = blend && this.checkBlend(blend);
    const settled = await this.settled();
    const motion =
      inPlace && !settled.options.inPlace
        ? this.shape.spec({ ...settled.options, inPlace }, settled.keyTimes)
        : settled;
    const { shape, spec } = this.user ?? { shape: this.shape, spec: motion };
    const { keys, filesWorker, glbSize } = shape.parts;
    return {
      planned: this.planned,
      keys,
      keyTimes: spec.keyTimes,
      options: { ...shape.options, ...spec.options, inPlace: motion.options.inPlace },
      range: this.range,
      filesWorker,
      glbSize,
      frame: (t) => this.batch(() => (weights ? this.blendFrame(weights, motion) : this.frame(t, motion))),
    };
  }
}
