/**
 * Exports. Frames come one at a time from the sequence's worker, which stays available for scrubbing. A new worker
 * writes them. Cancelling the export, or running out of memory, does not affect the sequence.
 */
import type { CallOptions } from '../api/api.ts';
import { clipName } from '../api/clip-name.ts';
import { cancelled, untilAborted } from '../api/errors.ts';
import { pingPong } from './bounce.ts';
import { withNote } from '../api/export-note.ts';
import { checkBytes, exportWarnings, frameWarnings, isPointCache, localWarnings } from './export-plan.ts';
import { movesKeys, planFrames, shapeCount } from './export-frames.ts';
import type { ExportSource, PlannedFrames } from './export-source.ts';
import { materialFiles, materialLibrary } from './material-library.ts';
import { PointCache } from './point-cache.ts';
import { sliderFiles } from './slider-files.ts';
import { targetNames } from './target-names.ts';
import { GridFit, maxWeight, roundingError } from '../wire/position-grid.ts';
import { writeProject } from '../wire/project.ts';
import type { FrameBuffers } from '../wire/protocol.ts';
import type { FilesWorker } from './worker-client.ts';
import type { ExportedFile, ExportOptions, ExportPlan, Frame, Scene } from '../api/types.ts';

const NO_SCENE: Scene = { uvs: null, colors: null, seams: null, polygons: null, groups: [], materials: [], images: [] };

/**
 * Measured compression ratios. Quantised: 0.75 to 0.84, higher for large rotations, whose normals stay floats.
 * Meshopt: 0.28 (a smooth bar) to 0.6 (a horse).
 */
const LEFT = { none: 1, quantized: 0.8, meshopt: 0.5 };

/** Additional characters per number in an OBJ with an offset. */
const FAR_DIGITS = 5;

/** Share of planning in the progress, unless it was done before. */
const PLANNING = 0.4;

interface Planned {
  frames: PlannedFrames;
  /** Largest playback error, including rounding; null without an animation. */
  error: number | null;
}

async function planOnce(source: ExportSource, options: ExportOptions, call: CallOptions): Promise<Planned> {
  const frames = await framesOnce(source, options, call);
  const latest = source.planned.latest!;
  if (frames.error === null || options.compression === 'none') return { frames, error: frames.error };
  latest.rounding ??= await roundingOf(source, frames, call);
  return { frames, error: frames.error + latest.rounding };
}

/** Largest displacement by a compressed file's grid, also at the keys, relative to the diagonal. */
async function roundingOf(source: ExportSource, frames: PlannedFrames, { signal }: CallOptions): Promise<number> {
  const fit = new GridFit();
  let base: Float32Array | null = null;
  for await (const { positions } of shapesOf(source, frames, signal)) {
    base ??= positions;
    if (base === positions) fit.addBase(base);
    else fit.addTarget(positions, base);
  }
  const weight = maxWeight(frames.principal?.weights ?? null, frames.times.length);
  return roundingError(fit.grid, weight) / source.keys.info.report.diagonal;
}

async function framesOnce(source: ExportSource, options: ExportOptions, call: CallOptions): Promise<PlannedFrames> {
  const { compression: _, name: __, clip: ___, ...rest } = options;
  const mine = JSON.stringify([rest, source.keyTimes, source.options]);
  if (source.planned.latest?.for === mine) return source.planned.latest.frames;
  const frames = await planFrames(source, options, call);
  source.planned.latest = { for: mine, frames, rounding: null };
  return frames;
}

export async function planExport(
  source: ExportSource,
  options: ExportOptions,
  call: CallOptions = {},
): Promise<ExportPlan> {
  const { frames, error } = await planOnce(source, options, call);
  const size = await estimate(source, options, shapeCount(frames));
  checkBytes(options, size.bytes);
  return {
    times: options.blend ? [] : frames.times,
    targets: options.format === 'glb' ? shapeCount(frames) - 1 : 0,
    error,
    bytes: size.bytes,
    warnings: [
      ...exportWarnings(options, shapeCount(frames) - 1, size.vertices),
      ...frameWarnings(options, source.keyTimes, options.range ?? source.range),
      ...localWarnings(options, source.keys.info.offset),
    ],
  };
}

/** Yields each file once written, so the caller need not hold all of them. */
export async function* exportFiles(
  source: ExportSource,
  options: ExportOptions,
  call: CallOptions,
): AsyncGenerator<ExportedFile, void, undefined> {
  let start = 0;
  await planExport(source, options, {
    signal: call.signal,
    onProgress: ({ stage, fraction }) => {
      start = PLANNING;
      call.onProgress?.({ stage, fraction: PLANNING * fraction });
    },
  });
  const { frames, error } = await planOnce(source, options, call);
  const writer = source.filesWorker();
  const stop = (): void => writer.terminate(cancelled());
  if (call.signal?.aborted) stop();
  call.signal?.addEventListener('abort', stop, { once: true });
  try {
    yield* writerOf(options, frames)({ source, options, frames, error, writer, call, start });
    call.onProgress?.({ stage: 'writing', fraction: 1 });
  } finally {
    call.signal?.removeEventListener('abort', stop);
    stop();
  }
}

function writerOf(options: ExportOptions, { times }: PlannedFrames) {
  if (isPointCache(options)) return writePointCache;
  return options.format === 'glb' && times.length > 1 ? writeAnimation : writePoses;
}

interface Job extends Planned {
  source: ExportSource;
  options: ExportOptions;
  writer: FilesWorker;
  call: CallOptions;
  /** Current progress. */
  start: number;
}

function report({ call, frames, start }: Job, done: number): void {
  const fraction = start + ((0.95 - start) * done) / shapeCount(frames);
  call.onProgress?.({ stage: 'evaluating', fraction });
}

const stemOf = ({ name }: ExportOptions): string => name ?? 'shapespline';

/** The shapes of an animation: frames at their times, or precomputed targets. */
async function* shapesOf(
  source: ExportSource,
  frames: PlannedFrames,
  signal: AbortSignal | undefined,
): AsyncGenerator<FrameBuffers, void, undefined> {
  if (frames.principal) {
    for (const { positions, normals } of frames.principal.shapes)
      yield { positions: positions.slice(), normals: normals.slice() };
    return;
  }
  const frame = (t: number): Promise<Frame> => untilAborted(signal, source.frame(t));
  for (const t of [...frames.times, ...frames.stills]) yield await frame(t);
  for (let key = 0; key < frames.poses; ++key) {
    // Normals are not visible here.
    const { normals } = await frame(source.keyTimes[key]!);
    yield { positions: source.keys.positions[key]!.slice(), normals };
  }
}

async function* writeAnimation(job: Job): AsyncGenerator<ExportedFile, void, undefined> {
  const { source, options, frames, writer } = job;
  let done = 0;
  for await (const { positions, normals } of shapesOf(source, frames, job.call.signal)) {
    const transfer = [positions.buffer, normals.buffer] as ArrayBuffer[];
    await writer.call('addFrame', { positions, normals }, { transfer });
    done += 1;
    report(job, done);
  }
  const { faces, scene, offset } = source.keys.info;
  const oneWay = { seconds: frames.seconds, weights: frames.principal?.weights ?? null };
  const { seconds, weights } = options.bounce ? pingPong(oneWay, shapeCount(frames) - 1) : oneWay;
  const names = targetNames(source.keys.info.names, source.keyTimes, frames);
  const bytes = await writer.call('writeAnimation', {
    faces,
    scene,
    seconds,
    stills: frames.stills.length + frames.poses,
    weights,
    project: projectOf(job),
    offset,
    name: stemOf(options),
    clip: options.clip ?? clipName(source.keys.info) ?? stemOf(options),
    targetNames: names,
    compression: options.compression,
  });
  yield { name: `${stemOf(options)}.glb`, bytes };
  if (frames.principal) yield* sliderFiles(stemOf(options), names, frames);
}

async function* writePoses(job: Job): AsyncGenerator<ExportedFile, void, undefined> {
  const { source, options, frames, call } = job;
  const { signal } = call;
  const many = frames.times.length > 1;
  let written = 0;
  for (const t of frames.times) {
    const frame = await untilAborted(signal, source.frame(t));
    const bytes = withNote(options.format, await writePose(job, frame), options.blend ? [] : [t]);
    frame.release();
    const name = many || options.pose === null ? String(written).padStart(4, '0') : stemOf(options);
    report(job, ++written);
    yield { name: `${name}.${options.format}`, bytes };
  }
  if (options.format === 'obj') yield* materialFiles(stemOf(options), source.keys.info.scene);
}

function writePose({ source, options, writer }: Job, frame: Frame): Promise<Uint8Array> {
  const { info } = source.keys;
  const format = options.format === 'glb' || options.format === 'ply' ? options.format : 'obj';
  return writer.call('writePose', {
    format,
    faces: info.faces,
    scene: sceneOf(format, info.scene),
    pose: { positions: frame.positions, normals: frame.normals },
    library: materialLibrary(stemOf(options), info.scene),
    offset: info.offset,
    local: isPointCache(options),
  });
}

/** The cache, and one OBJ with its vertices in the shape of the first frame. */
async function* writePointCache(job: Job): AsyncGenerator<ExportedFile, void, undefined> {
  const { source, options, frames, call } = job;
  const cache = new PointCache(options.format as 'pc2' | 'mdd', frames, source.keys.positions[0]!.length / 3);
  let obj: Uint8Array | null = null;
  let written = 0;
  for (const t of frames.times) {
    const frame = await untilAborted(call.signal, source.frame(t));
    obj ??= await writePose(job, frame);
    cache.add(frame.positions);
    frame.release();
    report(job, ++written);
  }
  yield { name: `${stemOf(options)}.${options.format}`, bytes: cache.bytes };
  yield { name: `${stemOf(options)}.obj`, bytes: withNote('obj', obj!, frames.times) };
  yield* materialFiles(stemOf(options), source.keys.info.scene);
}

/** The part of the look that a format can store. */
function sceneOf(format: 'glb' | 'obj' | 'ply', scene: Scene): Scene {
  if (format === 'glb') return scene;
  return format === 'obj' ? { ...scene, colors: null, images: [] } : NO_SCENE;
}

/**
 * Every key is one of the shapes, shown or not. With appended poses, keys are the last shapes; with principal targets,
 * the first.
 */
function projectOf({ source: { keys, keyTimes, options }, frames, error }: Job): string {
  const all = [...frames.times, ...frames.stills];
  const shapeOf = (t: number, key: number): number => {
    if (frames.poses > 0) return all.length + key;
    return frames.principal ? key : all.indexOf(t);
  };
  const { vertices, faces } = keys.info.report;
  // These keys' shapes include the effect of pins, so the pins are removed.
  const pins = frames.poses > 0 ? options.pins : options.pins.filter((pin) => !movesKeys({ ...options, pins: [pin] }));
  return writeProject(
    {
      names: keys.info.names,
      times: keyTimes,
      frames: keyTimes.map(shapeOf),
    },
    { ...options, pins },
    { vertices, faces, error },
    {
      speed: (frames.times.at(-1)! - frames.times[0]!) / frames.seconds.at(-1)!,
      start: frames.times[0]!,
      end: frames.times.at(-1)!,
    },
    keys.info.offset,
  );
}

async function estimate(
  { keys: { info, positions }, glbSize }: ExportSource,
  { format, compression }: ExportOptions,
  frames: number,
): Promise<{ bytes: number; vertices: number }> {
  const { scene } = info;
  const vertices = positions[0]!.length / 3;
  const faces = info.faces.length / 3;
  const obj = objBytes(vertices, faces, (scene.uvs?.length ?? 0) / 2);
  const far = info.offset.filter((value) => value !== 0).length;
  if (format === 'ply') return { bytes: frames * ((far > 0 ? 24 : 12) * vertices + 13 * faces), vertices };
  if (format === 'obj') return { bytes: frames * (obj + FAR_DIGITS * far * vertices), vertices };
  if (format !== 'glb') return { bytes: frames * (12 * vertices + 4) + obj, vertices };
  const images = scene.images.reduce((sum, image) => sum + image.bytes.length, 0);
  const bare = { ...scene, images: scene.images.map((image) => ({ ...image, bytes: new Uint8Array(0) })) };
  const size = await glbSize({ faces: info.faces, vertices, frames, scene: bare });
  return { bytes: images + LEFT[compression] * size.bytes, vertices: size.vertices };
}

/** Assumes numbers of about 10 characters, and indices as long as the largest, up to three per corner. */
function objBytes(vertices: number, faces: number, coordinates: number): number {
  const digits = (count: number): number => String(count).length;
  const corner = 2 * (1 + digits(vertices)) + 1 + (coordinates > 0 ? digits(coordinates) : 0);
  return 68 * vertices + 24 * coordinates + (2 + 3 * corner) * faces;
}
