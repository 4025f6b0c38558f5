/** The animation that the open files hold: how few of its shapes suffice as keys, and itself to compare with. */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { InputFile, Progress } from '../../engine/api/types.ts';
import { fewestKeys } from '../../study/fewest-keys.ts';
import { readReference } from '../../study/reference-motion.ts';
import type { ReferenceMotion } from '../../study/reference-motion.ts';
import { MOST_SAMPLED } from '../../engine/api/option-table.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { OpenFiles } from './open-files.ts';

export interface AnimationParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  files: OpenFiles;
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
  /** The animation that the keys are of now; null where there is none, or it could not be read. */
  reference(): Promise<ReferenceMotion | null>;
  cancel(): void;
}

interface Read {
  input: InputFile[];
  animation: number;
  motion: ReferenceMotion;
}

export function createAnimation({ engine, store, workspace, files, onWorking, onError }: AnimationParts): Animation {
  let read: Read | null = null;
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
    const motion = await readReference(engine, input, animation, span, vertices, options, { signal });
    read = { input, animation, motion };
    return motion;
  };

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
    reference: () => guarded((signal) => referenceOf(workspace.info?.animation ?? -1, signal)),
    cancel: () => working.abort(),
  };
}
