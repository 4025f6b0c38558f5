/**
 * Chooses the shapes of an export: the requested ones, or the fewest within its tolerance. Planning evaluates the
 * motion.
 */
import type { CallOptions } from '../api/api.ts';
import { cancelled, EngineError } from '../api/errors.ts';
import { adaptiveTimes, errorOf, type Motion } from './adaptive-times.ts';
import { checkWeights, choicesOf, framesOf, isThinned, onTimeLine, type Frames } from './export-plan.ts';
import { principalTargets, type PrincipalTargets } from './principal-targets.ts';
import type { ExportSource, PlannedFrames } from './export-source.ts';
import type { ExportOptions, SequenceOptions } from '../api/types.ts';

/** Limit for morph targets of a thinned animation. */
const MAX_TARGETS = 3999;
/** Share of the tolerance for the weight times of principal targets. */
const SHARE_OF_TIMES = 0.25;
/** Limit for bytes of frames in memory while finding the principal targets. */
const MAX_HELD = 1.5e9;
/** Tolerance of principal targets requested without one, in percent. */
const MIN_TOLERANCE = 0.0001;

export function shapeCount({ principal, times, stills, poses }: PlannedFrames): number {
  return principal ? principal.shapes.length : times.length + stills.length + poses;
}

/** Whether shapes at the keys differ from the keys because of pins. */
export function movesKeys({ pins }: SequenceOptions): boolean {
  return pins.some(({ stay, path }) => stay !== undefined || path !== undefined);
}

interface Chosen {
  frames: Frames;
  /** Largest distance between the times, in the unit of the positions; null without an animation. */
  error: number | null;
}

/** Principal targets without a tolerance get the least one. */
function toleranceOf(source: ExportSource, { tolerance }: ExportOptions): number {
  return (Math.max(tolerance, MIN_TOLERANCE) / 100) * source.keys.info.report.diagonal;
}

export async function planFrames(
  source: ExportSource,
  options: ExportOptions,
  call: CallOptions,
): Promise<PlannedFrames> {
  const { signal } = call;
  const motion: Motion = {
    at: async (t) => {
      if (signal?.aborted) throw cancelled();
      const frame = await source.frame(t);
      return frame.positions;
    },
  };
  const choose = isThinned(options) ? fewFrames : givenFrames;
  const { frames, error } = await choose(motion, source, options, call);
  const { diagonal } = source.keys.info.report;
  if (error === null) return { ...frames, poses: 0, principal: null, error };
  if (options.targets !== 'principal') {
    const poses = movesKeys(source.options) ? source.keyTimes.length : 0;
    checkWeights(frames.times.length, frames.times.length + frames.stills.length + poses - 1);
    return { ...frames, poses, principal: null, error: error / diagonal };
  }
  const tolerance = toleranceOf(source, options);
  const principal = await principalOf(source, frames.times, Math.max(tolerance - error, tolerance / 2), call);
  return { ...frames, stills: [], poses: 0, principal, error: (error + principal.error) / diagonal };
}

async function givenFrames(motion: Motion, source: ExportSource, options: ExportOptions): Promise<Chosen> {
  const frames = framesOf(options, source.keyTimes, source.range);
  if (options.format !== 'glb' || frames.times.length === 1) return { frames, error: null };
  const [first, last] = [frames.times[0]!, frames.times.at(-1)!];
  const corners = [...new Set([first, ...source.keyTimes, last])]
    .filter((t) => t >= first && t <= last)
    .sort((a, b) => a - b);
  return { frames, error: await errorOf(motion, frames.times, corners) };
}

async function fewFrames(
  motion: Motion,
  source: ExportSource,
  options: ExportOptions,
  call: CallOptions,
): Promise<Chosen> {
  const share = options.targets === 'principal' ? SHARE_OF_TIMES : 1;
  const { times, error } = await adaptiveTimes(motion, {
    ...choicesOf(options, source.keyTimes, source.range),
    tolerance: share * toleranceOf(source, options),
    max: MAX_TARGETS,
    onProgress: (fraction) => call.onProgress?.({ stage: 'choosing frames', fraction }),
  });
  return { frames: onTimeLine(times, source.keyTimes, options.duration), error };
}

async function principalOf(
  source: ExportSource,
  times: readonly number[],
  tolerance: number,
  { signal }: CallOptions,
): Promise<PrincipalTargets> {
  const size = source.keys.positions[0]!.length;
  if (2 * 4 * size * times.length > MAX_HELD)
    throw new EngineError(
      'too-large',
      `For a shape of this size, in-betweens (principal targets) need ${times.length} frames in memory. They do not fit. ` +
        'Use one morph target per frame, or a larger tolerance.',
    );
  const frame = async (t: number) => {
    if (signal?.aborted) throw cancelled();
    const { positions, normals } = await source.frame(t);
    return { positions, normals };
  };
  const all = async (list: readonly number[]) => {
    const frames = [];
    for (const t of list) frames.push(await frame(t));
    return frames;
  };
  const worker = source.filesWorker();
  try {
    const [first, last] = source.range;
    return await principalTargets({
      keys: await all(source.keyTimes),
      keyTimes: source.keyTimes,
      period: source.options.boundary === 'periodic' ? last - first : null,
      frames: await all(times),
      times,
      reduce: (rows) => worker.call('principalOffsets', { frames: rows, tolerance, max: times.length }),
    });
  } finally {
    worker.terminate(cancelled());
  }
}
