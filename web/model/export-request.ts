/** Options of an export and the numbers that follow from them: the dialog shows the numbers of the file. */
import { EXPORT } from '../engine/api/option-table.ts';
import { frameCount } from '../engine/api/whole-frames.ts';
import type { Range } from './time-scale.ts';
import { clamp, length } from './time-scale.ts';

export type ExportKind = 'animation' | 'pose' | 'picture' | 'numbers';
export type AnimationFormat = 'glb' | 'obj' | 'pc2' | 'mdd' | 'video';
/** For a GLB: as few as the tolerance allows, one per frame, or the keys with in-betweens. */
export type Targets = 'few' | 'every' | 'principal';
export type Compression = 'none' | 'quantized' | 'meshopt';
export type PoseFormat = 'glb' | 'obj' | 'ply';
export type PictureFormat = 'png' | 'turntable';
export type VideoFormat = 'mp4' | 'webm' | 'gif';
export type NumbersFormat = 'measures' | 'patches';

/** Pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

/** Offered sizes by name; `window` is the view on the screen, `own` is typed. */
export const SIZES = {
  small: { width: 640, height: 360 },
  '720p': { width: 1280, height: 720 },
  '1080p': { width: 1920, height: 1080 },
  '1440p': { width: 2560, height: 1440 },
  '4k': { width: 3840, height: 2160 },
  square: { width: 1080, height: 1080 },
  upright: { width: 1080, height: 1920 },
} as const satisfies Record<string, PictureSize>;
export type SizeName = 'window' | keyof typeof SIZES | 'own';
/** Of either side. */
export const [LEAST_PIXELS, MOST_PIXELS] = [16, 8192];

/** Choices of the dialog, kept while the page is open for the next export. */
export interface ExportRequest {
  kind: ExportKind;
  animation: AnimationFormat;
  pose: PoseFormat;
  picture: PictureFormat;
  numbers: NumbersFormat;
  /** null = the first that the browser can write. */
  video: VideoFormat | null;
  targets: Targets;
  /** In percent of the diagonal. */
  tolerance: number;
  compression: Compression;
  /** null = given by the rate. At most one of the two is not null. */
  frames: number | null;
  /** Frames per second of the export; null = the whole frames of the timeline, or the usual rate without them. */
  rate: number | null;
  /** First and last time; null = the range that plays. */
  range: [number, number] | null;
  /** Seconds that the range takes in the export; null = as it plays on the page. */
  duration: number | null;
  /** Seconds of one turn. */
  turn: number;
  /** Plays forwards, then backwards. */
  bounce: boolean;
  inPlace: boolean;
  /** A GLB comes in a zip, with a page that shows it. */
  page: boolean;
  /** Of a picture; null = as on the screen. */
  size: SizeName | null;
  /** Of a video; null = as on the screen, of a GIF small. */
  videoSize: SizeName | null;
  own: PictureSize;
  /** Of a PNG. */
  transparent: boolean;
  crop: boolean;
}

export const DEFAULT_REQUEST: Readonly<ExportRequest> = {
  kind: 'animation',
  animation: 'glb',
  pose: 'glb',
  picture: 'png',
  numbers: 'measures',
  video: null,
  targets: 'few',
  tolerance: EXPORT.tolerance.default,
  compression: EXPORT.compression.default,
  frames: null,
  rate: null,
  range: null,
  duration: null,
  turn: 6,
  bounce: false,
  inPlace: false,
  page: false,
  size: null,
  videoSize: null,
  own: SIZES['1080p'],
  transparent: true,
  crop: false,
};

export const MAX_FRAMES = 2000;
export const MOST_SECONDS = 3600;
const MOST_VIDEO_SECONDS = 600;
const USUAL_RATE = 30;
/** A GIF can state this exactly: its frames take whole hundredths of a second. */
const USUAL_GIF_RATE = 25;
const MOST_RATE = { mp4: 60, webm: 60, gif: 50 } as const satisfies Record<VideoFormat, number>;

/** How the page plays. */
export interface Playing {
  range: Range;
  /** Whole frames per unit of time; null = as smooth as the screen allows. */
  fps: number | null;
  /** Units of time per second. */
  speed: number;
}

export interface ExportNumbers {
  range: Range;
  /** Duration of the range, or of a turn, in one direction. */
  seconds: number;
  /** Frames a second. */
  rate: number;
  /** Number of all frames; playing back as well doubles it. */
  frames: number;
  /** The frames are the whole ones of the timeline. */
  whole: boolean;
  /** How many times faster than the time on the timeline. */
  speed: number;
}

/** Whether it is a video, of an animation or a turn. */
export function isVideoRequest({ kind, animation, picture }: ExportRequest): boolean {
  return (kind === 'animation' && animation === 'video') || isTurn({ kind, picture });
}

export function isTurn({ kind, picture }: Pick<ExportRequest, 'kind' | 'picture'>): boolean {
  return kind === 'picture' && picture === 'turntable';
}

/** May go back the way that it came: videos of the motion, and GLB. */
export function canBounce({ kind, animation }: ExportRequest): boolean {
  return kind === 'animation' && (animation === 'video' || animation === 'glb');
}

export function goesBack(request: ExportRequest): boolean {
  return canBounce(request) && request.bounce;
}

/** `video`: the format, where a video is asked for. */
export function exportNumbers(request: ExportRequest, playing: Playing, video: VideoFormat | null): ExportNumbers {
  const range = request.range ?? playing.range;
  const played = request.duration ?? length(range) / playing.speed;
  const wanted = isTurn(request) ? request.turn : played;
  const isVideo = isVideoRequest(request);
  const seconds = clamp(wanted, 0.01, isVideo ? MOST_VIDEO_SECONDS : Infinity);
  const speed = length(range) / seconds;
  const of = { range, seconds, speed };
  return isVideo
    ? { ...of, ...videoFrames(request, playing, video ?? 'mp4', seconds) }
    : { ...of, ...grid(request, playing, of) };
}

type Frames = Pick<ExportNumbers, 'rate' | 'frames' | 'whole'>;

/** Each frame of a video covers its part of a second, so they fill the time exactly. */
function videoFrames(request: ExportRequest, playing: Playing, video: VideoFormat, seconds: number): Frames {
  const usual = video === 'gif' ? USUAL_GIF_RATE : USUAL_RATE;
  const rate = Math.min(request.rate ?? playing.fps ?? usual, MOST_RATE[video]);
  const oneWay = Math.max(Math.round(seconds * rate), 1);
  return { rate, frames: goesBack(request) ? 2 * oneWay : oneWay, whole: false };
}

/** The frames of files go from the first time to the last, both included. */
function grid(
  { frames, rate }: ExportRequest,
  { fps }: Playing,
  { range, seconds, speed }: Pick<ExportNumbers, 'range' | 'seconds' | 'speed'>,
): Frames {
  const wholeFrames = frames === null && rate === null && fps !== null ? frameCount(range, fps) : 0;
  if (wholeFrames > 1) return { rate: fps! * speed, frames: wholeFrames, whole: true };
  const count = frames ?? Math.round(seconds * (rate ?? USUAL_RATE)) + 1;
  const clamped = clamp(count, 2, MAX_FRAMES);
  return { rate: (clamped - 1) / seconds, frames: clamped, whole: false };
}

/** The times of the frames of files. */
export function gridTimes({ range: [start, end], frames, whole, rate, speed }: ExportNumbers): number[] {
  if (!whole) return Array.from({ length: frames }, (_, i) => start + ((end - start) * i) / (frames - 1));
  const fps = rate / speed;
  const first = Math.ceil(start * fps - 1e-6);
  return Array.from({ length: frames }, (_, i) => (first + i) / fps);
}

/** Position of a video frame in the motion, in [0, 1], forwards and then backwards if it bounces. */
export function shareOf(frame: number, frames: number, bounce: boolean): number {
  if (!bounce) return frame / frames;
  const half = frames / 2;
  return frame <= half ? frame / half : (frames - frame) / half;
}

/** null: the size that the view has on the screen. */
export function sizeOf(request: ExportRequest, video: VideoFormat | null): PictureSize | null {
  const name = sizeName(request, video);
  if (name === 'window') return null;
  return name === 'own' ? request.own : SIZES[name];
}

export function sizeName(request: ExportRequest, video: VideoFormat | null): SizeName {
  if (!isVideoRequest(request)) return request.size ?? 'window';
  return request.videoSize ?? (video === 'gif' ? 'small' : 'window');
}
