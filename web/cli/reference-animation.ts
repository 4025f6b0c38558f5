/** The animation that `measure` compares with: its frames, and their times on the timeline of the keys. */
import type { CallOptions, Engine, Keys } from '../engine/api/api.ts';
import { EngineError } from '../engine/api/errors.ts';
import { noteOf } from '../engine/api/export-note.ts';
import { CACHES, extensionOf } from '../engine/api/paths.ts';
import { isMismatch, likeOf } from '../engine/api/read-poses.ts';
import type { ImportOptions, InputFile, KeysInfo } from '../engine/api/types.ts';
import { UsageError } from './arguments.ts';
import type { AxisAndUnit } from './comparison-warnings.ts';

/** Number of frames to read if all of them would exceed the memory. */
const EVEN_FRAMES = 240;
/** Relative tolerance for equal ranges. */
const SAME = 1e-3;

export interface ReferenceOptions {
  up?: 'y' | 'z';
  unit?: number;
}

export interface Reference {
  /** Time of each frame, on the timeline of the keys. */
  times: number[];
  /** Positions of a frame, 3 x vertices. */
  frame(index: number): Float32Array;
  /** Describes how the frames were mapped to the timeline. */
  placed: string;
  axisAndUnit: AxisAndUnit;
  /** The same animation at these times of the timeline. */
  at(times: readonly number[]): Promise<Reference>;
  dispose(): void;
}

/**
 * `own`: orientation of this animation if its files do not specify it; default: that of the keys. Our files specify Y
 * up, metres and frame times.
 */
export async function readReference(
  engine: Engine,
  keys: Keys,
  input: InputFile[],
  given: ImportOptions,
  own: ReferenceOptions,
): Promise<Reference> {
  const [{ name } = { name: '' }] = input;
  const note = noteOf(input);
  const axisAndUnit = note ? {} : { up: given.up, unit: given.unit };
  const { objects, animation } = given;
  const options: ImportOptions = { ...axisAndUnit, ...own, objects, animation, ...likeOf(keys) };
  const read = (change: ImportOptions, call?: CallOptions): Promise<Keys> =>
    engine.importKeyframes(input, { ...options, ...change }, call).catch((error: unknown) => {
      if (isMismatch(error))
        throw new EngineError(error.code, `--against: ${name} is a different mesh from the keys.`, error.place);
      if (error instanceof EngineError && error.code === 'too-few-keys')
        throw new EngineError(error.code, `--against: ${name} has no animation. ${error.message}`, error.place);
      throw error;
    });
  const played = await playOf(engine, input, options);
  const frames = await read({ everyFrame: true }).catch((error: unknown) => {
    if (!(error instanceof EngineError) || error.code !== 'too-large') throw error;
    return read({ sample: EVEN_FRAMES });
  });
  const inFile = frames.info.times;
  const { times, placed } = placeFrames(frames.info, keys.info, input, Boolean(note?.times), played);
  const referenceOf = (held: Keys, at: number[], description: string): Reference => ({
    times: at,
    frame: (index) => held.positions(index),
    placed: description,
    axisAndUnit: {
      up: note && !own.up ? null : isGltf(input) ? null : (options.up ?? 'y'),
      unit: options.unit ?? 1,
    },
    dispose: () => held.dispose(),
    async at(wanted) {
      const places = wanted.map((t) => interpolated(t, times, inFile));
      const distinct = [...new Set(places)];
      // An import takes at least two samples, in increasing order.
      if (distinct.length < 2) distinct.push(inFile.find((t) => t !== places[0])!);
      const sample = distinct.sort((a, b) => a - b);
      const sampled = await read({ sample });
      const frame = (index: number): Float32Array => sampled.positions(sample.indexOf(places[index]!));
      return { ...referenceOf(sampled, [...wanted], description), frame };
    },
  });
  return referenceOf(frames, times, placed);
}

const isGltf = (input: InputFile[]): boolean => input.some(({ name }) => ['glb', 'gltf'].includes(extensionOf(name)));

/** Playback speed and range of our projects; null for other files. */
async function playOf(
  engine: Engine,
  input: InputFile[],
  { objects }: ImportOptions,
): Promise<{ speed: number; span: [number, number] } | null> {
  if (!isGltf(input)) return null;
  const project = await engine.importKeyframes(input, { objects }).catch(() => null);
  const { speed = null, played = null } = project?.info ?? {};
  project?.dispose();
  return speed !== null && played !== null ? { speed, span: played } : null;
}

function placeFrames(
  { times }: KeysInfo,
  keys: KeysInfo,
  input: InputFile[],
  isNoted: boolean,
  played: { speed: number; span: [number, number] } | null,
): { times: number[]; placed: string } {
  if (isNoted) return { times: [...times], placed: 'at the times stated in its files' };
  const [start, end] = [times[0]!, times.at(-1)!];
  if (played) {
    const { speed, span } = played;
    const there = times.filter((t) => span[0] + t * speed <= span[1] + SAME * (span[1] - span[0]));
    return { times: there.map((t) => span[0] + t * speed), placed: 'at the times stated in its project' };
  }
  const [first, last] = [keys.times[0]!, keys.times.at(-1)!];
  const ofKeys = keys.animations[keys.animation];
  const isSameSpan = ofKeys && Math.abs(ofKeys.start - start) + Math.abs(ofKeys.end - end) <= SAME * (end - start);
  const timeless = input.some(({ name }) => ['pc2', 'obj', 'ply'].includes(extensionOf(name)));
  const hasTimes = input.some(({ name }) => CACHES.includes(extensionOf(name)) && extensionOf(name) !== 'pc2');
  if (!timeless || hasTimes || isSameSpan) return { times: [...times], placed: 'at its own times' };
  const scale = (last - first) / (end - start);
  return {
    times: times.map((t, i) => (i === times.length - 1 ? last : first + (t - start) * scale)),
    placed: 'spaced evenly from the first key to the last, because its files do not state frame times',
  };
}

/** Linear interpolation at t; constant beyond both ends. */
function interpolated(t: number, places: readonly number[], values: readonly number[]): number {
  const next = places.findIndex((place) => place > t);
  if (next < 0) return values.at(-1)!;
  if (next === 0) return values[0]!;
  const share = (t - places[next - 1]!) / (places[next]! - places[next - 1]!);
  return values[next - 1]! + share * (values[next]! - values[next - 1]!);
}

export const noFrames = (file: string, [first, last]: readonly [number, number]): UsageError =>
  new UsageError(
    `--against: give times from ${first} to ${last}, the range of ${file}, or set the key times to its times with ` +
      '--key-times',
  );
