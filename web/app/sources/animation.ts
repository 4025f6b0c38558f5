/**
 * The animation that the open files hold: how few of its shapes suffice as keys, and itself to compare with; or that of
 * other files to compare with.
 */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import { fileName, modelName } from '../../engine/api/paths.ts';
import { likeOf } from '../../engine/api/read-poses.ts';
import type { ImportOptions, InputFile, Progress } from '../../engine/api/types.ts';
import { fewestKeys } from '../../study/fewest-keys.ts';
import { readReference } from '../../study/reference-motion.ts';
import type { ReferenceMotion, TimedShapes } from '../../study/reference-motion.ts';
import { MOST_SAMPLED } from '../../engine/api/option-table.ts';
import { length } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { PosePool } from '../session/pose-pool.ts';
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

export interface Animation {
  /** Takes as few keys as keep the motion so near, in percent of the diagonal; null where they are not taken. */
  takeFewest(animation: number, percent: number): Promise<Fewest | null>;
  /** The animation to compare with; null where there is none, or it could not be read. */
  reference(): Promise<TimedShapes | null>;
  /** What other files hold is compared with from now on, not the animation of the keys; false where it is not taken. */
  takeTruth(files: PickedFile[] | Promise<PickedFile[]>): Promise<boolean>;
  dropTruth(): void;
  /** What it is called; null: there is none. */
  readonly truth: string | null;
  cancel(): void;
}

/** The animation of other files, of the mesh of these poses. */
interface Truth {
  name: string;
  pool: PosePool;
  motion: ReferenceMotion;
}

interface Read {
  input: InputFile[];
  animation: number;
  motion: ReferenceMotion;
}

export function createAnimation({ engine, store, workspace, files, onWorking, onError }: AnimationParts): Animation {
  let read: Read | null = null;
  let truth: Truth | null = null;
  let working = new AbortController();

  /** Read once for the same files. */
  const referenceOf = async (animation: number, signal: AbortSignal): Promise<ReferenceMotion | null> => {
    const { input, info, options } = workspace;
    const span = info?.animations[animation];
    if (!info || !span) return null;
    if (read?.input === input && read.animation === animation) return read.motion;
    read?.motion.dispose();
    read = null;
    const { vertices } = info.report;
    const own = { ...options, offset: info.offset };
    const motion = await readReference(engine, input, animation, span, vertices, own, { signal });
    read = { input, animation, motion };
    return motion;
  };

  /** Of what is open now. */
  const truthNow = (): Truth | null => (truth?.pool === workspace.pool ? truth : null);

  const guarded = async <T>(work: (signal: AbortSignal) => Promise<T | null>): Promise<T | null> => {
    working.abort();
    const own = new AbortController();
    working = own;
    onWorking({ stage: 'reading the animation', fraction: 0 });
    try {
      return await work(own.signal);
    } catch (error) {
      if (!isCancelled(error) && !own.signal.aborted) onError(error);
      return null;
    } finally {
      if (working === own) onWorking(null);
    }
  };

  return {
    async takeFewest(animation, percent) {
      const found = await guarded(async (signal) => {
        const reference = await referenceOf(animation, signal);
        const { boundary, method } = store.get().doc.motion;
        const { stretch } = store.get().doc.encoding;
        if (!reference) return null;
        return fewestKeys(engine, reference, {
          tolerance: percent / 100,
          most: MOST_SAMPLED,
          options: { method, stretch, boundary: boundary === 'periodic' ? 'natural' : boundary },
          signal,
          onProgress: onWorking,
        });
      });
      if (!found || !(await files.resample(animation, found.times))) return null;
      return { keys: found.times.length, percent: 100 * found.error };
    },
    async reference() {
      const given = truthNow();
      if (given) return spread(given.motion, () => keyRange(store, workspace));
      return guarded((signal) => referenceOf(workspace.info?.animation ?? -1, signal));
    },
    async takeTruth(files) {
      const picked = await files;
      const { pool, options } = workspace;
      if (!pool || picked.length === 0) return false;
      const motion = await guarded(async (signal) =>
        readTruth(engine, await readFiles(picked, undefined, signal), options, pool, signal),
      );
      if (!motion || workspace.pool !== pool) return false;
      // The one before is not disposed of: it is on the screen until this one is.
      truth = { name: modelName(leadingName(picked.map(({ name }) => name))), pool, motion };
      return true;
    },
    dropTruth() {
      truth = null;
    },
    get truth() {
      return truthNow()?.name ?? null;
    },
    cancel: () => working.abort(),
  };
}

/** The animation of other files, of the mesh of these poses, which were read with these options. */
async function readTruth(
  engine: Engine,
  files: InputFile[],
  { up, unit, objects }: ImportOptions,
  { keys }: PosePool,
  signal: AbortSignal,
): Promise<ReferenceMotion> {
  const options = { up, unit, objects, ...likeOf(keys) };
  const found = await engine.importKeyframes(files, options, { signal });
  const at = Math.max(found.info.animation, 0);
  const span = found.info.animations[at]?.moves ? found.info.animations[at] : undefined;
  found.dispose();
  if (!span) throw new Error(`${fileName(files[0]!.name)} holds no animation to compare with.`);
  return readReference(engine, files, at, span, keys.info.report.vertices, options, { signal });
}

/** Where the animation lies in the motion; null: at its own times, which the keys have, too. */
function keyRange(store: Store, { info }: Workspace): Range | null {
  const { keys } = store.get().doc;
  return info && info.animation >= 0 ? null : [keys[0]!.time, keys.at(-1)!.time];
}

/** The animation from the first key to the last. */
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
