/** From what the export dialog asks for to a download. */
import packageJson from '../../../package.json';
import type { Sequence } from '../../engine/api/api.ts';
import { errorText } from '../../engine/api/error-text.ts';
import type { ExportedFile, ExportOptions, ExportPlan as EnginePlan, Progress } from '../../engine/api/types.ts';
import type { Doc } from '../../model/state.ts';
import { bytesText } from '../../engine/api/bytes-text.ts';
import { frameCount } from '../../engine/api/whole-frames.ts';
import type { Range } from '../../model/time-scale.ts';
import type { ExportRequest } from '../../ui/export-dialog.ts';
import { MAX_FRAMES, framesWanted, isVideoRequest } from '../../ui/export-dialog.ts';
import { measuresCsv, patchesCsv } from './csv.ts';
import { download } from './download.ts';
import type { Analysis } from '../analysis/analysis.ts';
import { videoFrames } from './video.ts';
import { videoFormats, writeVideo } from './write-video.ts';
import { withReadme } from './readme.ts';
import { zip } from './zip.ts';

export interface ExportJob {
  sequence: Sequence;
  doc: Doc;
  /** Stem of the file's name. */
  name: string;
  time: number;
  stretch: Stretch;
  /** Draws now and calls `use` while the canvas holds the picture. */
  snapshot<T>(use: (canvas: HTMLCanvasElement) => T): T;
  analysis(): Promise<Analysis | null>;
  /** Shows the moment and resolves when it is drawn. */
  show(t: number): Promise<void>;
  /** Turns the view to a share of a whole turn about the upright axis. */
  turn(share: number): Promise<void>;
  /** A PNG of the view. */
  png(): Promise<Blob>;
  /** Puts the page's colour behind the shape, or takes it away. */
  backdrop(on: boolean): void;
  onProgress(progress: Progress | null): void;
  signal: AbortSignal;
}

const VIDEO_FPS = 30;
const MAX_VIDEO_FPS = 60;

/** What an export holds unless the request says otherwise. */
export interface Stretch {
  /** What plays. */
  range: Range;
  fps: number | null;
}

/** Options of the engine for the kinds of export that it writes; null for pictures, videos and tables. */
export function engineOptions(request: ExportRequest, time: number, stretch: Stretch): Partial<ExportOptions> | null {
  if (request.kind === 'pose') return { format: request.pose, pose: time };
  if (request.kind !== 'animation' || request.animation === 'video') return null;
  const { animation: format, inPlace, duration, compression, targets } = request;
  if (format === 'obj' || format === 'pc2') return { format, ...gridOf(request, stretch), inPlace };
  if (format === 'mdd') return { format, ...gridOf(request, stretch), duration, inPlace };
  const shared = { format, duration, inPlace, compression };
  if (targets === 'every') return { ...shared, ...gridOf(request, stretch), tolerance: 0 };
  return {
    ...shared,
    range: [...(request.range ?? stretch.range)] as [number, number],
    fps: stretch.fps,
    tolerance: request.tolerance,
    targets: targets === 'principal' ? 'principal' : 'frames',
  };
}

/** The whole frames of the timeline where there are some and no other number was asked for. */
function gridOf(request: ExportRequest, { range, fps }: Stretch): Partial<ExportOptions> {
  const [start, end] = request.range ?? range;
  const count = request.frames === null && fps !== null ? frameCount([start, end], fps) : 0;
  if (count > MAX_FRAMES)
    throw new Error(
      `This would be ${count.toLocaleString('en')} frames; the maximum is ${MAX_FRAMES.toLocaleString('en')}. Use a shorter range or fewer frames per second.`,
    );
  if (count > 1) return { fps, range: [start, end] };
  return { frames: framesWanted(request, [start, end], fps), range: [start, end] };
}

/** What would be made, in words. */
export interface ExportPlan {
  text: string;
  warnings: string[];
}

export async function describeExport(
  request: ExportRequest,
  sequence: Sequence,
  time: number,
  stretch: Stretch,
  signal?: AbortSignal,
): Promise<ExportPlan> {
  const options = engineOptions(request, time, stretch);
  if (options) {
    const plan = await sequence.planExport(options, { signal });
    return {
      text: request.kind === 'pose' ? `One shape, about ${bytesText(plan.bytes)}` : planText(request, plan),
      warnings: plan.warnings.map(({ message }) => message),
    };
  }
  if (isVideoRequest(request)) {
    const seconds = videoSeconds(request, stretch);
    const frames = videoFrames(seconds, videoRate(stretch)).toLocaleString('en');
    return { text: `${frames} frames, ${seconds.toFixed(1)} s of video`, warnings: [] };
  }
  return { text: request.kind === 'picture' ? 'A picture' : 'A table', warnings: [] };
}

function planText(request: ExportRequest, { times, targets, error, bytes }: EnginePlan): string {
  const isWhole = request.animation !== 'glb' || request.targets === 'every';
  const what = isWhole ? `${times.length} frames` : `${targets} morph ${targets === 1 ? 'target' : 'targets'}`;
  const off = error === null ? '' : `, off by at most ${errorText(error)} between them`;
  return `${what}${off}, about ${bytesText(bytes)}`;
}

export async function runExport(request: ExportRequest, job: ExportJob): Promise<void> {
  const { name } = job;
  if (request.kind === 'picture') {
    if (request.picture === 'png') return download(await job.png(), `${name}.png`);
    return video(request, job, (share) => job.turn(share));
  }
  if (request.kind === 'numbers') return table(request, job);
  if (request.kind === 'animation' && request.animation === 'video') {
    const [start, end] = request.range ?? job.stretch.range;
    return video(request, job, (share) => job.show(start + share * (end - start)));
  }
  const options = { ...engineOptions(request, job.time, job.stretch)!, name: safeName(name) };
  const call = { signal: job.signal, onProgress: job.onProgress };
  const files = job.sequence.exportFiles(options, call);
  if (request.kind === 'animation' && request.animation !== 'glb')
    return download(await zip(withReadme(request.animation, files, job.stretch.fps)), `${name}.zip`);
  return downloadAll(await all(files), name);
}

/** Without what file systems refuse. */
function safeName(name: string): string {
  return name.replace(/[/\\\p{C}]/gu, '').slice(0, 100) || 'shapespline';
}

async function all(files: AsyncIterable<ExportedFile>): Promise<ExportedFile[]> {
  const list: ExportedFile[] = [];
  for await (const file of files) list.push(file);
  return list;
}

async function downloadAll(files: ExportedFile[], name: string): Promise<void> {
  const [file, ...others] = files;
  if (!file) return;
  if (others.length > 0) return download(await zip(files), `${name}.zip`);
  const extension = file.name.split('.').at(-1) ?? 'glb';
  const type = extension === 'glb' ? 'model/gltf-binary' : 'application/octet-stream';
  download(new Blob([file.bytes as Uint8Array<ArrayBuffer>], { type }), `${name}.${extension}`);
}

async function video(request: ExportRequest, job: ExportJob, draw: (share: number) => Promise<void>): Promise<void> {
  const format = request.video ?? (await videoFormats())[0];
  if (!format) throw new Error('This browser cannot write videos. Export OBJ frames or a GLB instead.');
  job.backdrop(true);
  const blob = await writeVideo({
    format,
    seconds: videoSeconds(request, job.stretch),
    framesPerSecond: videoRate(job.stretch),
    draw,
    snapshot: job.snapshot,
    signal: job.signal,
    onProgress: (fraction) => job.onProgress({ stage: 'recording', fraction }),
  }).finally(() => job.backdrop(false));
  download(blob, `${job.name}.${format}`);
}

function videoRate({ fps }: Stretch): number {
  return Math.min(fps ?? VIDEO_FPS, MAX_VIDEO_FPS);
}

async function table(request: ExportRequest, job: ExportJob): Promise<void> {
  const version = packageJson.version;
  if (request.numbers === 'patches') {
    const text = patchesCsv(await job.sequence.patches(), job.doc, version);
    return download(new Blob([text], { type: 'text/csv' }), `${job.name}-patches.csv`);
  }
  const analysis = await job.analysis();
  if (!analysis) throw new Error('There is nothing to tabulate yet. Open some shapes first.');
  download(new Blob([measuresCsv(analysis, job.doc, version)], { type: 'text/csv' }), `${job.name}-measures.csv`);
}

function videoSeconds(request: ExportRequest, stretch: Stretch): number {
  const length = request.kind === 'animation' ? lengthOf(request, stretch) : 6;
  return Math.min(request.duration ?? length, 600);
}

function lengthOf(request: ExportRequest, { range }: Stretch): number {
  const [start, end] = request.range ?? range;
  return end - start;
}
