/** Turns a request of the export dialog into a download. */
import packageJson from '../../../package.json';
import type { Motion } from '../../engine/api/api.ts';
import { errorText } from '../../engine/api/error-text.ts';
import type { ExportedFile, ExportOptions, ExportPlan as EnginePlan, Progress } from '../../engine/api/types.ts';
import { bytesText } from '../../engine/api/bytes-text.ts';
import type { ExportNumbers, ExportRequest, PictureSize, Playing, VideoFormat } from '../../model/export-request.ts';
import {
  MAX_FRAMES,
  goesBack,
  exportNumbers,
  gridTimes,
  isTurn,
  isVideoRequest,
  shareOf,
  sizeOf,
} from '../../model/export-request.ts';
import type { Doc } from '../../model/state.ts';
import type { Analysis } from '../analysis/analysis.ts';
import type { SceneController } from '../drawing/scene-controller.ts';
import { measuresCsv, patchesCsv } from './csv.ts';
import { download } from '../../ui/download.ts';
import { takePicture } from './picture.ts';
import { withReadme } from './readme.ts';
import { withCaptureCanvas } from './capture-canvas.ts';
import { pageColour } from './title.ts';
import { videoFormats, writeVideo } from './write-video.ts';
import { zip } from './zip.ts';
import { timeLeft } from './time-left.ts';

export interface ExportJob {
  sequence: Motion;
  doc: Doc;
  /** File name without its extension. */
  name: string;
  /** HTML that shows the GLB of this name. */
  page: string;
  time: number;
  playing: Playing;
  scene: SceneController;
  analyseAt(
    times: readonly number[],
    report: (fraction: number) => void,
    signal: AbortSignal,
  ): Promise<Analysis | null>;
  /** Shows the shape at a time; resolves when it is drawn. */
  show(t: number): Promise<void>;
  /** Turns the view about the upright axis by a share of a full turn. */
  turn(share: number): Promise<void>;
  onProgress(progress: Progress | null): void;
  signal: AbortSignal;
}

/** Engine options for the exports that the engine writes; null for images, videos and tables. */
export function engineOptions(request: ExportRequest, time: number, playing: Playing): Partial<ExportOptions> | null {
  if (request.kind === 'pose') return { format: request.pose, pose: time };
  if (request.kind !== 'animation' || request.animation === 'video') return null;
  const { animation: format, inPlace, compression, targets } = request;
  const bounce = goesBack(request);
  const numbers = exportNumbers(request, playing, null);
  // The timeline's duration, unless the export changes the speed.
  const duration = numbers.speed === 1 ? null : numbers.seconds;
  if (format === 'obj' || format === 'pc2') return { format, ...gridOf(numbers, null), inPlace };
  if (format === 'mdd') return { format, ...gridOf(numbers, duration), duration, inPlace };
  const shared = { format, duration, inPlace, compression, bounce };
  if (targets === 'every') return { ...shared, ...gridOf(numbers, duration), tolerance: 0 };
  return {
    ...shared,
    range: [...numbers.range],
    fps: numbers.whole ? numbers.rate : null,
    tolerance: request.tolerance,
    targets: targets === 'principal' ? 'principal' : 'frames',
  };
}

/** Whole frames of the timeline, counted on the exported animation's timeline if that has a duration. */
function gridOf(numbers: ExportNumbers, duration: number | null): Partial<ExportOptions> {
  const { range, frames, whole, rate, speed } = counted(numbers);
  if (!whole) return { frames, range: [...range] };
  return { fps: duration === null ? rate / speed : rate, range: [...range] };
}

/** Rejects an unintended number of frames. Only whole frames of a long range can reach it. */
function counted(numbers: ExportNumbers): ExportNumbers {
  if (numbers.frames <= MAX_FRAMES) return numbers;
  throw new Error(
    `This would be ${grouped(numbers.frames)} frames; the maximum is ${grouped(MAX_FRAMES)}. Use a shorter range or fewer frames per second.`,
  );
}

/** Principal targets store the keys' shapes with pins applied, but not the pins' motion between keys. */
function lostPins({ kind, animation, targets }: ExportRequest, { options }: Motion): string[] {
  const lost = options.pins.some(({ stay, path }) => stay !== undefined || path !== undefined);
  if (kind !== 'animation' || animation !== 'glb' || targets !== 'principal' || !lost) return [];
  return ['When reopened here, only pins on their own splines are kept, so the motion between keys differs.'];
}

/** A description of the planned export. */
export interface ExportPlan {
  text: string;
  warnings: string[];
}

export interface Planned {
  sequence: Motion;
  time: number;
  playing: Playing;
  /** Size of the view on the screen. */
  window: PictureSize;
  signal: AbortSignal;
}

export async function describeExport(
  request: ExportRequest,
  { sequence, time, playing, window, signal }: Planned,
): Promise<ExportPlan> {
  const options = engineOptions(request, time, playing);
  if (options) {
    const plan = await sequence.planExport(options, { signal });
    return {
      text: request.kind === 'pose' ? `One shape, about ${bytesText(plan.bytes)}` : planText(request, playing, plan),
      warnings: [...plan.warnings.map(({ message }) => message), ...lostPins(request, sequence)],
    };
  }
  if (isVideoRequest(request)) return { text: await videoText(request, playing, window), warnings: [] };
  if (request.kind === 'picture') return { text: pictureText(request, window), warnings: [] };
  if (request.numbers === 'patches') return { text: 'A table', warnings: [] };
  const { frames } = counted(exportNumbers(request, playing, null));
  return { text: `A table of ${grouped(frames)} frames`, warnings: [] };
}

async function videoText(request: ExportRequest, playing: Playing, window: PictureSize): Promise<string> {
  const format = await formatOf(request);
  const { frames, rate } = exportNumbers(request, playing, format);
  return `${grouped(frames)} frames, ${secondsText(frames / rate)}, ${pixels(sizeOf(request, format) ?? window)}`;
}

function pictureText(request: ExportRequest, window: PictureSize): string {
  const size = pixels(sizeOf(request, null) ?? window);
  return request.crop ? `An image, cropped from ${size}` : `An image of ${size}`;
}

const grouped = (count: number): string => count.toLocaleString('en');
const pixels = ({ width, height }: PictureSize): string => `${width}\u00a0×\u00a0${height}\u00a0pixels`;

function secondsText(seconds: number): string {
  return `${Number(seconds.toFixed(seconds < 1 ? 2 : 1))}\u00a0s`;
}

function planText(request: ExportRequest, playing: Playing, { times, targets, error, bytes }: EnginePlan): string {
  const { frames, seconds } = exportNumbers(request, playing, null);
  const off = error === null ? '' : `, playback error at most ${errorText(error)}`;
  const size = `about ${bytesText(bytes)}`;
  if (request.animation !== 'glb') return `${grouped(times.length)} frames, ${size}`;
  const bounces = goesBack(request);
  const back = bounces ? ' forwards and backwards' : '';
  const length = secondsText(bounces ? 2 * seconds : seconds);
  if (request.targets !== 'every')
    return `${length}${back}, ${targets} morph ${targets === 1 ? 'target' : 'targets'}${off}, ${size}`;
  // A GLB passes through the keys at any frame count.
  const keys = times.length - frames;
  const more = keys > 0 ? ` (${grouped(frames)} and ${keys} more at keys)` : '';
  return `${length}${back}, ${grouped(times.length)} frames${more}${off}, ${size}`;
}

export async function runExport(request: ExportRequest, job: ExportJob): Promise<void> {
  const { name } = job;
  if (request.kind === 'picture' && request.picture === 'png')
    return download(await takePicture(job.scene, { ...request, size: sizeOf(request, null) }), `${name}.png`);
  if (isVideoRequest(request)) return video(request, job);
  if (request.kind === 'numbers') return table(request, job);
  const clip = request.name === '' ? {} : { clip: name };
  const options = { ...engineOptions(request, job.time, job.playing)!, name, ...clip };
  const call = { signal: job.signal, onProgress: job.onProgress };
  const files = job.sequence.exportFiles(options, call);
  if (request.kind === 'animation' && request.animation !== 'glb') {
    const { rate } = exportNumbers(request, job.playing, null);
    return download(await zip(withReadme(request.animation, files, Number(rate.toFixed(3)))), `${name}.zip`);
  }
  if (request.page) {
    const { withPackage } = await import('./embed-zip.ts');
    return download(await zip(withPackage(job.page, files, job.signal)), `${name}-page.zip`);
  }
  return downloadAll(await all(files), name);
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

/** The chosen format, or the first that the browser can write. */
async function formatOf({ video }: ExportRequest): Promise<VideoFormat> {
  return video ?? (await videoFormats())[0] ?? 'gif';
}

async function video(request: ExportRequest, job: ExportJob): Promise<void> {
  const format = await formatOf(request);
  const { range, frames, rate } = exportNumbers(request, job.playing, format);
  const [start, end] = range;
  const bounces = goesBack(request);
  const show = (share: number): Promise<void> =>
    isTurn(request) ? job.turn(share) : job.show(start + share * (end - start));
  const ground = pageColour('--stage-centre');
  const began = performance.now();
  const blob = await withCaptureCanvas(job.scene, sizeOf(request, format), true, (capture) =>
    writeVideo({
      format,
      frames,
      framesPerSecond: rate,
      canvas: capture.canvas,
      async draw(frame) {
        await show(shareOf(frame, frames, bounces));
        capture.take(ground);
        capture.takeTitles();
      },
      onFrame: (done) =>
        job.onProgress({
          stage: `Frame ${grouped(done)} of ${grouped(frames)}${timeLeft(performance.now() - began, done / frames)}`,
          fraction: done / frames,
        }),
      signal: job.signal,
    }),
  );
  download(blob, `${job.name}.${format}`);
}

async function table(request: ExportRequest, job: ExportJob): Promise<void> {
  const version = packageJson.version;
  if (request.numbers === 'patches') {
    const text = patchesCsv(await job.sequence.shape.patches(), job.doc, version);
    return download(new Blob([text], { type: 'text/csv' }), `${job.name}-patches.csv`);
  }
  const numbers = counted(exportNumbers(request, job.playing, null));
  const report = (fraction: number): void => job.onProgress({ stage: 'measuring', fraction });
  const analysis = await job.analyseAt(gridTimes(numbers), report, job.signal);
  if (!analysis) throw new Error('There is nothing to tabulate yet. Open some shapes first.');
  const text = measuresCsv(analysis, job.doc, version, numbers.speed);
  download(new Blob([text], { type: 'text/csv' }), `${job.name}-measures.csv`);
}
