/** Times of an export, and their times on the exported animation's timeline. */
import { bytesText } from '../api/bytes-text.ts';
import { EngineError, invalidOption } from '../api/errors.ts';
import { MAX_EXPORTED_FRAMES, USUAL_FRAMES } from '../api/option-table.ts';
import { NO_PLACE } from '../api/types.ts';
import { SAME_FRAME, frameCount, frameTimes } from '../api/whole-frames.ts';
import type { ExportOptions, Point, Warning } from '../api/types.ts';

/**
 * Bytes per target and vertex. three.js and Babylon.js store position and normal as four floats each in a texture, plus
 * three floats each in memory; Blender stores a position.
 */
const PLAYED_BYTES = { texture: 32, memory: 24, blender: 12 };
/** Larger textures exceed the limit of many phones and integrated GPUs for one model. */
const HEAVY_BYTES = 256e6;
/** Layers of an array texture, at the limit of nearly all GPUs. three.js uses one per target. */
const MAX_LAYERS = 2048;

/**
 * Limit for files that can be opened again: one weight per target and frame, and sizes up to 2^31
 * (wasm/io/gltf/gltf_writer).
 */
export const MAX_WEIGHTS = 16_000_000;
const MAX_GLB_BYTES = 2 ** 31 - 1;

/**
 * A grid time this close to a key, relative to the export's length, becomes the key's exact time, because linspace
 * rounds.
 */
const SAME_TIME = 1e-9;

export interface Frames {
  /** Frame times in the sequence's unit of time. */
  times: number[];
  /** Time of each frame on the exported animation's timeline, in float32; the first is 0. */
  seconds: number[];
  /** Times of keys outside the range. They are stored but never shown, so the file contains the whole project. */
  stills: number[];
}

/** `range`: the default range. For a GLB, excludes frames within the tolerance. */
export function framesOf(
  options: ExportOptions,
  keyTimes: readonly number[],
  range: readonly [number, number],
): Frames {
  if (options.pose !== null || options.blend) return { times: [options.pose ?? range[0]], seconds: [0], stills: [] };
  const asked = askedTimes(options, options.range ?? range);
  if (options.format !== 'glb' || asked.length === 1)
    return { times: asked, seconds: placesOf(asked, options), stills: [] };
  checkWeights(asked.length, asked.length - 1);
  const times = withKeys(
    [...asked].sort((a, b) => a - b),
    keyTimes,
  );
  return onTimeLine(times, keyTimes, options.duration);
}

function askedTimes({ times, frames, fps, duration }: ExportOptions, range: readonly [number, number]): number[] {
  if (times) return times;
  return fps !== null && frames === null ? wholeFrames(range, fps, duration) : evenly(range, frames ?? USUAL_FRAMES);
}

/** With a duration, frames are those of the exported animation, starting with frame 0. */
function wholeFrames([first, last]: readonly [number, number], fps: number, duration: number | null): number[] {
  const scale = duration === null ? 1 : duration / (last - first);
  const count = duration === null ? frameCount([first, last], fps) : frameCount([0, duration], fps);
  if (count > MAX_EXPORTED_FRAMES)
    throw tooLarge(
      `This would be ${grouped(count)} frames; the maximum is ${grouped(MAX_EXPORTED_FRAMES)}. Use a shorter range or fewer frames per second.`,
    );
  const times =
    duration === null
      ? frameTimes([first, last], fps)
      : frameTimes([0, duration], fps).map((seconds) => Math.min(first + seconds / scale, last));
  if (times.length > 1) return times;
  throw invalidOption('The range has no length. Use a longer range.');
}

/** Whether a GLB omits frames within the tolerance; for principal targets, weight times. */
export function isThinned({ format, pose, blend, times, frames, tolerance, targets }: ExportOptions): boolean {
  const wanted = tolerance > 0 || targets === 'principal';
  return format === 'glb' && pose === null && !blend && wanted && !times && frames === null;
}

/** Candidate times of a thinned GLB: required and optional ones. */
export function choicesOf(
  options: ExportOptions,
  keyTimes: readonly number[],
  range: readonly [number, number],
): { corners: number[]; grid: number[] | null } {
  const [first, last] = options.range ?? range;
  if (options.fps === null || options.frames !== null || options.times)
    return { corners: withKeys([first, last], keyTimes), grid: null };
  const grid = wholeFrames([first, last], options.fps, options.duration);
  return { corners: withKeys([grid[0]!, grid.at(-1)!], keyTimes), grid };
}

function evenly([first, last]: readonly [number, number], count: number): number[] {
  return Array.from({ length: count }, (_, i) => (i === count - 1 ? last : first + ((last - first) * i) / (count - 1)));
}

/** Frame times of files without keys among their frames. Only an MDD stores them. */
function placesOf(asked: readonly number[], { format, duration }: ExportOptions): number[] {
  const first = asked.reduce((least, t) => Math.min(least, t));
  const length = asked.reduce((most, t) => Math.max(most, t)) - first;
  if (format !== 'mdd' || !(length > 0)) return asked.map(() => 0);
  return asked.map((t) => ((t - first) / length) * (duration ?? length));
}

/** The sorted times and the keys between them, each once. A key replaces a time close to it. */
function withKeys(times: number[], keyTimes: readonly number[]): number[] {
  const first = times[0]!;
  const last = times.at(-1)!;
  const near = SAME_TIME * (last - first);
  const keys = keyTimes.filter((key) => key >= first - near && key <= last + near);
  const free = times.filter((t) => !keys.some((key) => Math.abs(key - t) <= near));
  return [...new Set([...free, ...keys])].sort((a, b) => a - b);
}

export function onTimeLine(times: number[], keyTimes: readonly number[], duration: number | null): Frames {
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

export function checkWeights(frames: number, targets: number): void {
  if (frames * targets <= MAX_WEIGHTS) return;
  throw tooLarge(
    `With ${grouped(frames)} frames, the file would be too large to open here again: its ${grouped(targets)} morph targets need ` +
      `more than ${grouped(MAX_WEIGHTS)} weights. Export fewer frames, or an OBJ sequence.`,
  );
}

/** Refuses a GLB that is too large to open again. */
export function checkBytes({ format }: ExportOptions, bytes: number): void {
  if (format !== 'glb' || bytes <= MAX_GLB_BYTES) return;
  throw tooLarge(
    `The file would be ${(bytes / 1e9).toFixed(1)} GB, but a GLB can have at most 2.1 GB. Export fewer frames, or an OBJ sequence.`,
  );
}

const grouped = (count: number): string => count.toLocaleString('en');

const tooLarge = (sentence: string): EngineError => new EngineError('too-large', sentence);

/** Warnings about keys between whole frames. `range`: the exported range. */
export function frameWarnings(
  { format, pose, times, frames, fps, duration }: ExportOptions,
  keyTimes: readonly number[],
  [first, last]: readonly [number, number],
): Warning[] {
  if (format !== 'glb' || pose !== null || times || frames !== null || fps === null) return [];
  const inside = keyTimes.flatMap((t, key) => (t >= first && t <= last ? [{ t, key }] : []));
  const frameOf = (t: number): number => fps * (duration === null ? t : ((t - first) * duration) / (last - first));
  const off = inside.filter(({ t }) => Math.abs(frameOf(t) - Math.round(frameOf(t))) > SAME_FRAME);
  if (off.length === 0) return [];
  const named = off.map(({ key }) => key + 1).join(', ');
  return [
    {
      ...NO_PLACE,
      code: 'keys-off-frames',
      message:
        `At ${fps} frames per second, ${off.length === 1 ? `key ${named} is` : `keys ${named} are`} between whole frames, ` +
        'as extra frames. Move the keys onto frames, or omit the frame rate.',
      key: off[0]!.key,
      count: off.length,
    },
  ];
}

/** Formats that store vertex positions separately from the faces. */
export const isPointCache = ({ format }: ExportOptions): boolean => format === 'pc2' || format === 'mdd';

/** Warnings about single precision, in which a cache must be near the origin. */
export function localWarnings(options: ExportOptions, offset: Point): Warning[] {
  if (!isPointCache(options) || offset.every((value) => value === 0)) return [];
  const message =
    `The ${options.format.toUpperCase()} and its OBJ have positions relative to ${offset.join(', ')} (y up). ` +
    'In other programs, move the object by this offset. shapespline applies it when it opens the files.';
  return [{ ...NO_PLACE, code: 'local-positions', message, count: 0 }];
}

/** `vertices`: total over all primitives. */
export function exportWarnings(options: ExportOptions, targets: number, vertices: number): Warning[] {
  if (options.format !== 'glb') return [];
  const warnings: Warning[] = [];
  const texture = targets * vertices * PLAYED_BYTES.texture;
  const bytes = (each: number): string => bytesText(targets * vertices * each);
  if (texture > HEAVY_BYTES)
    warnings.push({
      ...NO_PLACE,
      code: 'heavy-animation',
      message:
        `Playing this file takes ${bytesText(texture)} of graphics memory in three.js and Babylon.js (${grouped(targets)} ` +
        `morph targets of ${grouped(vertices)} vertices, 32 bytes each) and ${bytes(PLAYED_BYTES.memory)} of memory; ` +
        `${bytes(PLAYED_BYTES.blender)} in Blender. To use less memory, choose a larger tolerance or fewer frames.`,
      count: targets,
    });
  if (targets > MAX_LAYERS)
    warnings.push({
      ...NO_PLACE,
      code: 'many-targets',
      message: `The animation has ${grouped(targets)} morph targets; three.js plays no more than ${grouped(MAX_LAYERS)} on most GPUs.`,
      count: targets,
    });
  return warnings;
}
