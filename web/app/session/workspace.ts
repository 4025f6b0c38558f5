/** The open content: poses and sequences, and its replacement by a new import. */
import type { CallOptions, Engine, Keys } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { ImportOptions, InputFile, KeyMesh, KeysInfo, Progress, Warning } from '../../engine/api/types.ts';
import { LARGE, mayBeLarge } from '../../engine/api/large.ts';
import type { Doc, View } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { documentFromImport } from './document-from-import.ts';
import type { renumbered } from '../../engine/api/sentences.ts';
import { SequenceSet } from './sequence-set.ts';
import type { RunningMotion } from '../../playback/frame-set.ts';
import { PosePool } from './pose-pool.ts';
import type { SequencePlan } from './sequence-plan.ts';
import { sequencePlan } from './sequence-plan.ts';

export interface Start {
  doc: Doc;
  /** Camera for the first key; null to fit the whole shape. */
  camera: View['camera'];
}

/** Content being opened: its keys are read, its motion does not exist yet. */
export interface LoadedKeys extends Start {
  info: KeysInfo;
  pool: PosePool;
}

export interface WorkspaceEvents {
  onProgress(progress: Progress | null): void;
  /** Files are read; the motion does not exist yet. */
  onRead(info: KeysInfo): void;
  /** Files of unknown, possibly large size are about to be read. */
  onLarge(): void;
  /** Keys are read. null: the open content stays visible and usable until the new motion exists. */
  onKeys(opening: LoadedKeys | null): void;
  /** Opening was given up. */
  onGivenUp(): void;
  onReady(plan: SequencePlan): void;
  onRefused(error: unknown, current: SequencePlan | null): void;
}

export interface LoadSteps<S extends Start> {
  /** The mesh is the same, so the open content stays visible and usable until the new motion is made. */
  stays: boolean;
  /** Other import options that follow from the files' content; null to keep the given ones. */
  otherwise(info: KeysInfo): ImportOptions | null;
  /** Turns the files' document into the document to open. */
  start(doc: Doc, pool: PosePool): S;
  /** Called just before the open content is replaced. */
  leave(): void;
}

interface Current {
  info: KeysInfo;
  set: SequenceSet;
  pool: PosePool;
  input: OpenFile[];
  options: ImportOptions;
  /** null without warnings of the import. */
  renumbered: typeof renumbered | null;
}

/** A file. Samples made in the page have arrays, so no reader is loaded for them. */
export interface OpenFile extends InputFile {
  mesh?: KeyMesh;
}

/** Files or their source; `report` receives the fetched share. */
export type Input = OpenFile[] | ((report: (fraction: number) => void, signal: AbortSignal) => Promise<InputFile[]>);

/** Share of reading in the progress bar, and of fetching in reading. The rest is encoding and factoring. */
const READING = 0.3;
const FETCHING = 0.3;
const NOTHING_RUNNING: readonly RunningMotion[] = [];
const UNIT_RANGE: Range = [0, 1];

export class Workspace {
  /** Content was opened that is not in the state yet. The opener resets this with the state. */
  aheadOfState = false;
  private current: Current | null = null;
  private opening: AbortController | null = null;

  constructor(
    private readonly engine: Engine,
    private readonly events: WorkspaceEvents,
  ) {}

  get sequences(): readonly RunningMotion[] {
    return this.current?.set.all ?? NOTHING_RUNNING;
  }

  /** Range of the first running sequence. */
  get range(): Range {
    return this.sequences[0]?.sequence.range ?? UNIT_RANGE;
  }

  /** Information on the import. */
  get info(): KeysInfo | null {
    return this.current?.info ?? null;
  }

  /**
   * Warnings of the import about these keys, and of the first running sequence, each once. Equal warnings at two
   * locations are two.
   */
  warningsOf(keys: Doc['keys']): Warning[] {
    const keyOf = (pose: number): number => keys.findIndex((key) => key.pose === pose);
    const imported = (this.info?.warnings ?? []).flatMap((warning) => this.current?.renumbered?.(warning, keyOf) ?? []);
    const all = [...imported, ...(this.sequences[0]?.sequence.warnings ?? [])];
    const texts = all.map((warning) => JSON.stringify(warning));
    return all.filter((_, index) => texts.indexOf(texts[index]!) === index);
  }

  get pool(): PosePool | null {
    return this.current?.pool ?? null;
  }

  /** The open files, for choosing other keys. */
  get input(): OpenFile[] {
    return this.current?.input ?? [];
  }

  /** Import options of the open files. */
  get options(): ImportOptions {
    return this.current?.options ?? {};
  }

  /**
   * Reads files and makes the motion. Replaces the open content only after both have succeeded. Resolves to null if it
   * was cancelled or replaced by another call.
   */
  async open<S extends Start>(
    source: Input,
    given: ImportOptions,
    { stays, otherwise, start, leave }: LoadSteps<S>,
  ): Promise<(LoadedKeys & S) | null> {
    if (this.opening) this.events.onGivenUp();
    this.opening?.abort();
    const abort = new AbortController();
    this.opening = abort;
    let keys: Keys | null = null;
    try {
      const report = (stage: string, fraction: number): void =>
        this.progress(abort, { stage, fraction: READING * fraction });
      report('reading the files', 0);
      const fetched = typeof source === 'function' ? FETCHING : 0;
      const input =
        typeof source === 'function'
          ? await source((fraction) => report('reading the files', fetched * fraction), abort.signal)
          : source;
      abort.signal.throwIfAborted();
      if (!stays && mayBeLarge(input)) this.events.onLarge();
      const onProgress = ({ stage, fraction }: Progress): void => report(stage, fetched + (1 - fetched) * fraction);
      const read = { signal: abort.signal, onProgress };
      keys = await this.keysOf(input, given, read);
      const again = otherwise(keys.info);
      if (again) {
        keys.dispose();
        keys = await this.keysOf(input, again, read);
      }
      const options = again ?? given;
      performance.mark('shapespline read');
      const { info } = keys;
      this.events.onRead(info);
      const sentences = info.warnings.length > 0 ? await import('../../engine/api/sentences.ts') : null;
      const pool = new PosePool(keys);
      const opening = { ...start(documentFromImport(info, pool), pool), info, pool };
      const takesLong = info.report.vertices >= LARGE;
      this.events.onKeys(takesLong && !stays ? opening : null);
      const set = await this.firstSet(pool, sequencePlan(opening.doc), abort);
      performance.mark('shapespline made');
      if (this.current) leave();
      this.close();
      this.current = { info, set, pool, input, options, renumbered: sentences?.renumbered ?? null };
      this.aheadOfState = true;
      return opening;
    } catch (error) {
      keys?.dispose();
      if (this.opening === abort) this.events.onGivenUp();
      if (isCancelled(error) || abort.signal.aborted) return null;
      throw error;
    } finally {
      this.progress(abort, null);
      if (this.opening === abort) this.opening = null;
    }
  }

  want(plan: SequencePlan): void {
    this.current?.set.want(plan);
  }

  /** Cancels the work in progress; the open content stays. */
  cancel(): void {
    this.opening?.abort();
    this.current?.set.cancel();
  }

  async idle(): Promise<void> {
    await this.current?.set.idle();
  }

  private keysOf(input: OpenFile[], options: ImportOptions, call: CallOptions): Promise<Keys> {
    const { keyTimes, ...others } = options;
    const mesh = input[0]?.mesh;
    if (!mesh || Object.keys(others).length > 0) return this.engine.importKeyframes(input, options, call);
    const poses = mesh.poses.map((pose, key) => ({ ...pose, time: keyTimes?.[key] ?? pose.time }));
    return this.engine.createKeys({ ...mesh, poses }, call);
  }

  private progress(abort: AbortController, progress: Progress | null): void {
    if (this.opening === abort) this.events.onProgress(progress);
  }

  private async firstSet(pool: PosePool, plan: SequencePlan, abort: AbortController): Promise<SequenceSet> {
    let failure: unknown = null;
    let open = false;
    const set = new SequenceSet(this.engine, pool, {
      onProgress: (progress) => {
        if (open) this.events.onProgress(progress);
        else if (progress) this.progress(abort, { ...progress, fraction: READING + (1 - READING) * progress.fraction });
      },
      onReady: (ready) => {
        if (open) this.events.onReady(ready);
      },
      onRefused: (error, current) => {
        failure = error;
        if (open) this.events.onRefused(error, current);
      },
    });
    const stop = (): void => set.cancel();
    abort.signal.addEventListener('abort', stop);
    set.want(plan);
    await set.idle();
    abort.signal.removeEventListener('abort', stop);
    if (abort.signal.aborted || set.plan === null) {
      set.dispose();
      throw failure ?? abort.signal.reason;
    }
    open = true;
    return set;
  }

  private close(): void {
    this.current?.set.dispose();
    this.current?.pool.keys.dispose();
    this.current = null;
  }
}
