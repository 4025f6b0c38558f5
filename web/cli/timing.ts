/** The option --fit-timing: the timing that fits the motion to the animation from which the keys were taken. */
import type { Engine, Keys, Shape } from '../engine/api/api.ts';
import { OWN_METHOD } from '../engine/api/methods.ts';
import { motionOf } from '../engine/api/options.ts';
import type { ImportOptions, InputFile, SequenceOptions, TimingFit, Timings } from '../engine/api/types.ts';
import { MAX_REGIONS } from '../engine/api/option-table.ts';
import { UsageError, type Arguments } from './arguments.ts';
import { readReference } from './reference-animation.ts';

const FLAG = '--fit-timing';

/** What the command has read. */
export interface Source {
  engine: Engine;
  keys: Keys;
  inputs: InputFile[];
  imported: ImportOptions;
}

export interface FittedTiming {
  options: Timings;
  /** The errors, as part of a sentence. */
  text: string;
}

/**
 * The number of regions whose timing is to be fitted; 0 for none. Refuses options that exclude it, before any file is
 * read.
 */
export function fittedRegions(args: Arguments): number {
  const value = args.values.get('fit-timing') ?? 'off';
  const count = value === 'off' ? 0 : value === 'whole' ? 1 : Number(value);
  if (!/^(off|whole|\d+)$/.test(value) || count > MAX_REGIONS || value === '0')
    throw new UsageError(
      `${FLAG} requires whole, off, or a number of regions from 1 to ${MAX_REGIONS}, not '${value}'`,
    );
  if (count === 0) return 0;
  for (const other of ['earlier', 'swing', 'key-times', 'every-frame'])
    if (args.values.has(other) || args.flags.has(other))
      throw new UsageError(`${FLAG} and --${other} exclude each other`);
  return count;
}

/** `shape`: the keys, encoded. */
export async function fittedTiming(
  { engine, keys, inputs, imported }: Source,
  shape: Shape,
  options: SequenceOptions,
  regions: number,
): Promise<FittedTiming> {
  if (options.method !== OWN_METHOD || options.keepLengths > 0)
    throw new UsageError(`${FLAG} requires --method ${OWN_METHOD}, without --keep-lengths`);
  if (keys.info.animation < 0)
    throw new UsageError(`${FLAG} requires keys that are taken from an animation (see --sample)`);
  const animation = await readReference(engine, keys, inputs, imported, {});
  try {
    const motion = await shape.motion({ ...motionOf(options), hold: 'off', pins: [] });
    const frames = { times: animation.times, at: (index: number) => animation.frame(index) };
    const fit = await engine.fitTiming(motion, frames, { regions });
    motion.dispose();
    if (!fit)
      throw new UsageError(`${FLAG}: the animation has no frames between the keys. Take fewer keys (see --sample)`);
    return { options: fit.timings, text: textOf(fit) };
  } finally {
    animation.dispose();
  }
}

function textOf({ timings, unseen }: TimingFit): string {
  if (!unseen) return 'timing fitted to every frame between the keys';
  const [before, after] = [unseen.before, unseen.after].map((error) => `${Number(error.toPrecision(3))} %`);
  const where = `on ${unseen.frames} ${unseen.frames === 1 ? 'frame' : 'frames'} between the keys`;
  return timings.regions.length === 0
    ? `timing not fitted, because it raised the KG error from ${before} to ${after} ${where} that it was not fitted to`
    : `timing fitted: KG error ${before} without it, ${after} with a fit to the other half, ${where}`;
}
