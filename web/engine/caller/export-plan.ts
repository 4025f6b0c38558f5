/** Which times an export holds, and where they lie on the exported animation's own timeline. */
import { EngineError, invalidOption } from '../api/errors.ts';
import { NO_PLACE } from '../api/types.ts';
import type { ExportOptions, Warning } from '../api/types.ts';

/** Morph targets that WebGL2 players are sure to hold: 256 layers of an array texture. */
const SAFE_TARGETS = 256;

/**
 * What opens again: weights are one for each target at every frame, and a file's sizes are read up to 2^31
 * (wasm/io/gltf/gltf_writer).
 */
const MOST_WEIGHTS = 16_000_000;
const MOST_GLB_BYTES = 2 ** 31 - 1;

/** A grid time this close to a key, relative to the export's length, is the key's: linspace rounds, keys are exact. */
const SAME_TIME = 1e-9;

export interface Frames {
  /** In the sequence's own unit. */
  times: number[];
  /** For each time its place on the exported animation's timeline, in float32; the first is 0. */
  seconds: number[];
  /** Times of keys outside the range: they come along unseen, so that the file holds the whole project. */
  stills: number[];
}

/** `range`: what is exported unless the options say otherwise. */
export function framesOf(
  options: ExportOptions,
  keyTimes: readonly number[],
  range: readonly [number, number],
): Frames {
  if (options.pose !== null) return { times: [options.pose], seconds: [0], stills: [] };
  const asked = options.times ?? evenly(options.range ?? range, options.frames);
  if (options.format !== 'glb' || asked.length === 1) return { times: asked, seconds: asked.map(() => 0), stills: [] };
  checkWeights(asked.length, asked.length - 1);
  const times = withKeys(
    [...asked].sort((a, b) => a - b),
    keyTimes,
  );
  return onTimeLine(times, keyTimes, options.duration);
}

function evenly([first, last]: readonly [number, number], count: number): number[] {
  return Array.from({ length: count }, (_, i) => (i === count - 1 ? last : first + ((last - first) * i) / (count - 1)));
}

/** The sorted times and the keys between them, each once; a key wins over a time that is nearly its own. */
function withKeys(times: number[], keyTimes: readonly number[]): number[] {
  const first = times[0]!;
  const last = times.at(-1)!;
  const near = SAME_TIME * (last - first);
  const keys = keyTimes.filter((key) => key >= first - near && key <= last + near);
  const free = times.filter((t) => !keys.some((key) => Math.abs(key - t) <= near));
  return [...new Set([...free, ...keys])].sort((a, b) => a - b);
}

function onTimeLine(times: number[], keyTimes: readonly number[], duration: number | null): Frames {
  const first = times[0]!;
  const length = times.at(-1)! - first;
  if (!(length > 0)) throw invalidOption('An animation needs at least two different times.');
  const scale = (duration ?? length) / length;
  const seconds = times.map((t) => Math.fround((t - first) * scale));
  if (seconds.some((s, i) => i > 0 && !(s > seconds[i - 1]!))) {
    throw invalidOption(
      'Some frames are too close together for the file format. Use fewer frames or a longer duration.',
    );
  }
  const stills = keyTimes.filter((t) => !times.includes(t));
  checkWeights(times.length, times.length + stills.length - 1);
  return { times, seconds, stills };
}

function checkWeights(frames: number, targets: number): void {
  if (frames * targets <= MOST_WEIGHTS) return;
  throw tooLarge(
    `An animation of ${grouped(frames)} frames could not be opened again: its ${grouped(targets)} morph targets need more than ` +
      `${grouped(MOST_WEIGHTS)} weights. Export fewer frames, or an OBJ sequence.`,
  );
}

/** Refuses a GLB of so many bytes where that would not open again. */
export function checkBytes({ format }: ExportOptions, bytes: number): void {
  if (format !== 'glb' || bytes <= MOST_GLB_BYTES) return;
  throw tooLarge(
    `The file would be ${(bytes / 1e9).toFixed(1)} GB and could not be opened again; a GLB may have 2.1 GB. Export fewer frames, or an OBJ sequence.`,
  );
}

const grouped = (count: number): string => count.toLocaleString('en');

const tooLarge = (sentence: string): EngineError => new EngineError('too-large', sentence);

export function exportWarnings(options: ExportOptions, frames: Frames): Warning[] {
  const targets = frames.times.length + frames.stills.length - 1;
  if (options.format !== 'glb' || targets <= SAFE_TARGETS) return [];
  const message =
    `The animation has ${targets} morph targets; some players take no more than ${SAFE_TARGETS}. ` +
    'Fewer frames are safer.';
  return [{ ...NO_PLACE, code: 'many-targets', message, count: targets }];
}
