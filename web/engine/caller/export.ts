/**
 * Exports. Frames come from the sequence's own worker, one at a time, so that it stays free for scrubbing; they are
 * written in a fresh worker, so that neither a cancelled export nor one that runs out of memory touches the sequence.
 */
import type { CallOptions } from '../api/api.ts';
import { cancelled, untilAborted } from '../api/errors.ts';
import { checkBytes, exportWarnings, framesOf, type Frames } from './export-plan.ts';
import { writeProject } from '../wire/project.ts';
import type { KeyData } from '../wire/protocol.ts';
import type { WorkerClient } from './worker-client.ts';
import type { ExportedFile, ExportOptions, ExportPlan, Frame, Scene, SequenceOptions } from '../api/types.ts';

export interface ExportSource {
  keys: KeyData;
  keyTimes: readonly number[];
  options: SequenceOptions;
  range: readonly [number, number];
  freshWorker(): WorkerClient;
  frame(t: number): Promise<Frame>;
  /** Bytes of an animated GLB without its images. */
  glbSize(vertices: number, faces: number, frames: number, scene: Scene): Promise<number>;
}

const NO_SCENE: Scene = { uvs: null, colors: null, seams: null, groups: [], materials: [], images: [] };

export async function planExport(source: ExportSource, options: ExportOptions): Promise<ExportPlan> {
  const frames = framesOf(options, source.keyTimes, source.range);
  const bytes = await estimate(source, options, frames.times.length + frames.stills.length);
  checkBytes(options, bytes);
  return { times: frames.times, bytes, warnings: exportWarnings(options, frames) };
}

/** The files as they are written: who takes them one by one need not hold them all. */
export async function* exportFiles(
  source: ExportSource,
  options: ExportOptions,
  call: CallOptions,
): AsyncGenerator<ExportedFile, void, undefined> {
  const frames = framesOf(options, source.keyTimes, source.range);
  await planExport(source, options);
  const writer = source.freshWorker();
  const stop = (): void => writer.terminate(cancelled());
  if (call.signal?.aborted) stop();
  call.signal?.addEventListener('abort', stop, { once: true });
  try {
    const animated = options.format === 'glb' && frames.times.length > 1;
    yield* (animated ? writeAnimation : writePoses)({ source, options, frames, writer, call });
    call.onProgress?.({ stage: 'writing', fraction: 1 });
  } finally {
    call.signal?.removeEventListener('abort', stop);
    stop();
  }
}

interface Job {
  source: ExportSource;
  options: ExportOptions;
  frames: Frames;
  writer: WorkerClient;
  call: CallOptions;
}

function report({ call, frames }: Job, done: number): void {
  call.onProgress?.({ stage: 'evaluating', fraction: (0.95 * done) / (frames.times.length + frames.stills.length) });
}

async function* writeAnimation(job: Job): AsyncGenerator<ExportedFile, void, undefined> {
  const {
    source,
    frames: { times, seconds, stills },
    writer,
    call: { signal },
  } = job;
  for (const [index, t] of [...times, ...stills].entries()) {
    const { positions, normals } = await untilAborted(signal, source.frame(t));
    const transfer = [positions.buffer, normals.buffer] as ArrayBuffer[];
    await writer.call('addFrame', { positions, normals }, { transfer });
    report(job, index + 1);
  }
  const { faces, scene } = source.keys.info;
  const project = projectOf(source, job.frames);
  const bytes = await writer.call('writeAnimation', { faces, scene, seconds, stills: stills.length, project });
  yield { name: 'shapespline.glb', bytes };
}

async function* writePoses(job: Job): AsyncGenerator<ExportedFile, void, undefined> {
  const {
    source,
    options: { format },
    frames,
    writer,
    call: { signal },
  } = job;
  const { faces } = source.keys.info;
  const scene = sceneOf(format, source.keys.info.scene);
  for (const [index, t] of frames.times.entries()) {
    const frame = await untilAborted(signal, source.frame(t));
    const pose = { positions: frame.positions, normals: frame.normals };
    const bytes = await writer.call('writePose', { format, faces, scene, pose });
    frame.release();
    report(job, index + 1);
    yield { name: `${String(index).padStart(4, '0')}.${format}`, bytes };
  }
}

/** What a format keeps of the look. */
function sceneOf(format: ExportOptions['format'], { uvs, seams, ...rest }: Scene): Scene {
  if (format === 'glb') return { uvs, seams, ...rest };
  return format === 'obj' ? { ...NO_SCENE, uvs, seams } : NO_SCENE;
}

/** Every key is one of the frames, shown or not. */
function projectOf({ keys, keyTimes, options }: ExportSource, { times, stills }: Frames): string {
  const all = [...times, ...stills];
  return writeProject(
    { names: keys.info.names, times: keyTimes, frames: keyTimes.map((t) => all.indexOf(t)) },
    options,
  );
}

async function estimate(
  { keys: { info, positions }, glbSize }: ExportSource,
  { format }: ExportOptions,
  frames: number,
): Promise<number> {
  const { scene } = info;
  const vertices = positions[0]!.length / 3;
  const faces = info.faces.length / 3;
  if (format === 'ply') return frames * (12 * vertices + 13 * faces);
  if (format === 'obj') return frames * objBytes(vertices, faces, (scene.uvs?.length ?? 0) / 2);
  const images = scene.images.reduce((sum, image) => sum + image.bytes.length, 0);
  const bare = { ...scene, images: scene.images.map((image) => ({ ...image, bytes: new Uint8Array(0) })) };
  return images + (await glbSize(vertices, faces, frames, bare));
}

/** Numbers of about 10 characters; indices as long as the largest, twice a corner where there are coordinates. */
function objBytes(vertices: number, faces: number, coordinates: number): number {
  const digits = (count: number): number => String(count).length;
  const corner = 1 + digits(vertices) + (coordinates > 0 ? 1 + digits(coordinates) : 0);
  return 33 * vertices + 24 * coordinates + (2 + 3 * corner) * faces;
}
