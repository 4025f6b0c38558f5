/**
 * The animation in the open files: finds the fewest keys that suffice, and provides the animation for comparison. An
 * animation of other files can replace it in comparisons.
 */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import { fileName, modelName } from '../../engine/api/paths.ts';
import { OWN_METHOD } from '../../engine/api/methods.ts';
import { likeOf } from '../../engine/api/read-poses.ts';
import type { InputFile, Progress, TimingFit } from '../../engine/api/types.ts';
import { fewestKeys } from '../../study/fewest-keys.ts';
import { readReference } from '../../study/reference-motion.ts';
import type { ReferenceMotion, TimedShapes } from '../../study/reference-motion.ts';
import { MAX_SAMPLED } from '../../engine/api/option-table.ts';
import { length } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { PosePool } from '../session/pose-pool.ts';
import { encodingFor, sequencePlan } from '../session/sequence-plan.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { readFiles } from './input-files.ts';
import type { Opener } from './opener.ts';

export interface AnimationParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  files: Opener;
  onWorking(working: Progress | null): void;
  onError(error: unknown): void;
}

export interface Fewest {
  keys: number;
  percent: number;
}

/** An animation from other files, with the mesh of these poses. */
interface Reference {
  name: string;
  pool: PosePool;
  motion: ReferenceMotion;
}

interface Read {
  input: InputFile[];
  /** Its import options as text. */
  how: string;
  motion: ReferenceMotion;
}

export class Animation {
  private read: Read | null = null;
  private other: Reference | null = null;
  private stop = new AbortController();
  private seeking = new AbortController();
  /** The last request. The next one waits for it. */
  private last: Promise<unknown> = Promise.resolve();
  private waiting = 0;

  constructor(private readonly parts: AnimationParts) {}

  /**
   * Chooses the fewest keys that keep the motion within this error, in percent of the diagonal; null if they are not
   * used.
   */
  async takeFewest(animation: number, percent: number): Promise<Fewest | null> {
    const { engine, store, files, onWorking } = this.parts;
    // A new error bound replaces the previous one.
    this.seeking.abort();
    this.seeking = new AbortController();
    const { signal } = this.seeking;
    const found = await this.guarded(async () => {
      if (signal.aborted) return null;
      const reference = await this.referenceOf(animation, signal);
      const { doc } = store.get();
      const { boundary, method } = doc.motion;
      const { stretch } = doc.encoding;
      if (!reference) return null;
      return fewestKeys(engine, reference, {
        tolerance: percent / 100,
        max: MAX_SAMPLED,
        options: { method, stretch, boundary: boundary === 'periodic' ? 'natural' : boundary },
        signal,
        onProgress: onWorking,
      });
    });
    if (!found || !(await files.resample(animation, found.times))) return null;
    return { keys: found.times.length, percent: 100 * found.error };
  }

  /**
   * Fits the timing of regions to the animation from which the keys were taken; null if that is impossible or ended
   * early.
   */
  async fitTiming(animation: number): Promise<TimingFit | null> {
    const { engine, store, workspace, onWorking } = this.parts;
    const { pool } = workspace;
    return this.guarded(async (signal) => {
      const reference = await this.referenceOf(animation, signal);
      if (!reference || !pool) return null;
      const plan = sequencePlan(store.get().doc);
      const variant = { method: OWN_METHOD, ghost: plan.encoding.ghostFaces };
      const keys = pool.keys.arrange(plan.order, plan.times);
      const shape = await engine.encode(keys, encodingFor(plan, variant, pool.keys), { signal });
      try {
        const motion = await shape.motion({ ...plan.motion, hold: 'off', pins: [] });
        const frames = { times: reference.times, at: (index: number) => reference.keys.positions(index) };
        return await engine.fitTiming(motion, frames, {}, { signal, onProgress: onWorking });
      } finally {
        shape.dispose();
        keys.dispose();
      }
    });
  }

  /** The animation for comparison; null if there is none, or if it was unreadable. */
  async reference(): Promise<TimedShapes | null> {
    const { store, workspace } = this.parts;
    const given = this.referenceNow;
    if (given) return spread(given.motion, () => keyRange(store, workspace));
    return this.guarded((signal) => this.referenceOf(workspace.info?.animation ?? -1, signal));
  }

  /** Compares with other files' animation instead of the keys' from now on; false if it is not used. */
  async takeReference(files: PickedFile[] | Promise<PickedFile[]>): Promise<boolean> {
    const { workspace } = this.parts;
    const picked = await files;
    const { pool } = workspace;
    if (!pool || picked.length === 0) return false;
    const motion = await this.guarded(async (signal) =>
      this.readReference(await readFiles(picked, undefined, signal), pool, signal),
    );
    if (!motion || workspace.pool !== pool) return false;
    // The previous animation is not disposed of, because it stays on the screen until this one is ready.
    this.other = { name: modelName(leadingName(picked.map(({ name }) => name))), pool, motion };
    return true;
  }

  dropReference(): void {
    this.other = null;
  }

  /** Name of the other files' animation; null if there is none. */
  get referenceName(): string | null {
    return this.referenceNow?.name ?? null;
  }

  cancel(): void {
    this.stop.abort();
    this.seeking.abort();
    this.stop = new AbortController();
  }

  /** The other files' animation, if it matches the open content. */
  private get referenceNow(): Reference | null {
    return this.other?.pool === this.parts.workspace.pool ? this.other : null;
  }

  /** The animation of the keys, cached for the same files. */
  private async referenceOf(animation: number, signal: AbortSignal): Promise<ReferenceMotion | null> {
    const { engine, workspace } = this.parts;
    const { input, info, options } = workspace;
    const span = info?.animations[animation];
    const how = this.howNow(animation);
    if (!info || !span) return null;
    if (this.isRead(how)) return this.read!.motion;
    this.read?.motion.dispose();
    this.read = null;
    const { vertices } = info.report;
    const own = { ...options, offset: info.offset };
    const motion = await readReference(engine, input, animation, span, vertices, own, { signal });
    this.read = { input, how, motion };
    return motion;
  }

  private isRead(how: string): boolean {
    return this.read?.input === this.parts.workspace.input && this.read.how === how;
  }

  /** The open files' import options for this animation, as text. */
  private howNow(animation: number): string {
    const { info, options } = this.parts.workspace;
    return JSON.stringify([animation, options.up, options.unit, options.objects, info?.offset]);
  }

  private async readReference(files: InputFile[], { keys }: PosePool, signal: AbortSignal): Promise<ReferenceMotion> {
    const { engine, workspace } = this.parts;
    const { up, unit, objects } = workspace.options;
    const options = { up, unit, objects, ...likeOf(keys) };
    const found = await engine.importKeyframes(files, options, { signal });
    const at = Math.max(found.info.animation, 0);
    const span = found.info.animations[at]?.moves ? found.info.animations[at] : undefined;
    found.dispose();
    if (!span)
      throw new Error(
        `${fileName(files[0]!.name)} has no animation to compare with. Choose a file with an animation of this mesh.`,
      );
    return readReference(engine, files, at, span, keys.info.report.vertices, options, { signal });
  }

  /** Runs requests one after the other. */
  private guarded<T>(work: (signal: AbortSignal) => Promise<T | null>): Promise<T | null> {
    const { signal } = this.stop;
    this.waiting += 1;
    const task = this.last.then(() => this.run(work, signal));
    this.last = task;
    return task;
  }

  private async run<T>(work: (signal: AbortSignal) => Promise<T | null>, signal: AbortSignal): Promise<T | null> {
    const { onWorking, onError } = this.parts;
    try {
      signal.throwIfAborted();
      onWorking({ stage: 'reading the animation', fraction: 0 });
      return await work(signal);
    } catch (error) {
      if (!isCancelled(error) && !signal.aborted) onError(error);
      return null;
    } finally {
      this.waiting -= 1;
      if (this.waiting === 0) onWorking(null);
    }
  }
}

/** Range of the animation in the motion; null if the animation plays at its own times, which the keys share. */
function keyRange(store: Store, { info }: Workspace): Range | null {
  const { keys } = store.get().doc;
  return info && info.animation >= 0 ? null : [keys[0]!.time, keys.at(-1)!.time];
}

/** Maps the animation to the time from the first key to the last. */
function spread(motion: ReferenceMotion, range: () => Range | null): TimedShapes {
  const [start, end] = [motion.times[0]!, motion.times.at(-1)!];
  return {
    times: motion.times,
    at(t) {
      const to = range();
      return motion.at(to ? start + ((t - to[0]) / length(to)) * (end - start) : t);
    },
  };
}
