/** Options of an export and the resulting numbers. The dialog shows the file's numbers. */
import { EXPORT } from '../engine/api/option-table.ts';
import { frameCount, frameTimes } from '../engine/api/whole-frames.ts';
import type { Range } from './time-scale.ts';
import { clamp, length } from './time-scale.ts';

export type ExportKind = 'animation' | 'pose' | 'picture' | 'numbers';
export type AnimationFormat = 'glb' | 'obj' | 'pc2' | 'mdd' | 'video';
/** For a GLB: the fewest within the tolerance, one per frame, or the keys with in-betweens. */
export type Targets = 'few' | 'every' | 'principal';
export type Compression = 'none' | 'quantized' | 'meshopt';
export type PoseFormat = 'glb' | 'obj' | 'ply';
export type PictureFormat = 'png' | 'turntable';
export type VideoFormat = 'mp4' | 'webm' | 'gif';
export type NumbersFormat = 'measures' | 'patches';

/** Size in pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

/** Offered sizes by name; `window` is the size on the screen, `own` is typed. */
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
/** Bounds of either side. */
export const PIXELS = { min: 16, max: 8192, step: 1 };

/** Choices of the dialog, stored for the next export while the page is open. */
export interface ExportRequest {
  /** Name of the file and the clip; '' for the default. Not stored when other files are opened. */
  name: string;
  kind: ExportKind;
  animation: AnimationFormat;
  pose: PoseFormat;
  picture: PictureFormat;
  numbers: NumbersFormat;
  /** Video format; null: the first that the browser can write. */
  video: VideoFormat | null;
  targets: Targets;
  /** Tolerance in percent of the diagonal. */
  tolerance: number;
  compression: Compression;
  /** Number of frames; null: determined by the rate. At most one of the two is set. */
  frames: number | null;
  /** Export frames per second; null: the timeline's whole frames, or the default rate without them. */
  rate: number | null;
  /** First and last time; null: the playing range. */
  range: [number, number] | null;
  /** Duration of the range in the export, in seconds; null: as on the page. */
  duration: number | null;
  /** Duration of one turn in seconds. */
  turn: number;
  /** Plays forwards, then backwards. */
  bounce: boolean;
  inPlace: boolean;
  /** Puts a GLB in a zip, with a page that shows it. */
  page: boolean;
  /** Size of an image; null: as on the screen. */
  size: SizeName | null;
  /** Size of a video; null: as on the screen, or small for a GIF. */
  videoSize: SizeName | null;
  own: PictureSize;
  /** Removes the background of a PNG. */
  transparent: boolean;
  crop: boolean;
}

export const DEFAULT_REQUEST: Readonly<ExportRequest> = {
  name: '',
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
export const MAX_SECONDS = 3600;
const MAX_VIDEO_SECONDS = 600;
const USUAL_RATE = 30;
/** A GIF can represent this rate exactly, in hundredths of a second. */
const USUAL_GIF_RATE = 25;
const MAX_RATE = { mp4: 60, webm: 60, gif: 50 } as const satisfies Record<VideoFormat, number>;

/** Playback settings of the page. */
export interface Playing {
  range: Range;
  /** Whole frames per unit of time; null: as smooth as the screen allows. */
  fps: number | null;
  /** Speed in units of time per second. */
  speed: number;
  /** Frame rate of the animation that the keys were taken from; null or absent if unknown. */
  own?: number | null;
}

export interface ExportNumbers {
  range: Range;
  /** Duration of the range, or of a turn, in one direction. */
  seconds: number;
  /** Frames per second. */
  rate: number;
  /** Total number of frames, doubled if it also plays backwards. */
  frames: number;
  /** The frames are the timeline's whole frames. */
  whole: boolean;
  /** Speed relative to the timeline. */
  speed: number;
}

/** Whether the request is for a video of an animation or of a turn. */
export function isVideoRequest({ kind, animation, picture }: ExportRequest): boolean {
  return (kind === 'animation' && animation === 'video') || isTurn({ kind, picture });
}

export function isTurn({ kind, picture }: Pick<ExportRequest, 'kind' | 'picture'>): boolean {
  return kind === 'picture' && picture === 'turntable';
}

/** Whether it can play backwards: videos of the motion, and GLB. */
export function canBounce({ kind, animation }: ExportRequest): boolean {
  return kind === 'animation' && (animation === 'video' || animation === 'glb');
}

export function goesBack(request: ExportRequest): boolean {
  return canBounce(request) && request.bounce;
}

/** `video`: the format of a requested video. */
export function exportNumbers(request: ExportRequest, playing: Playing, video: VideoFormat | null): ExportNumbers {
  const range = request.range ?? playing.range;
  const played = request.duration ?? length(range) / playing.speed;
  const wanted = isTurn(request) ? request.turn : played;
  const isVideo = isVideoRequest(request);
  const seconds = clamp(wanted, 0.01, isVideo ? MAX_VIDEO_SECONDS : Infinity);
  const speed = length(range) / seconds;
  const of = { range, seconds, speed };
  return isVideo
    ? { ...of, ...videoFrames(request, playing, video ?? 'mp4', seconds) }
    : { ...of, ...grid(request, playing, of) };
}

type Frames = Pick<ExportNumbers, 'rate' | 'frames' | 'whole'>;

/** Each frame of a video covers its part of a second, so the frames fill the time exactly. */
function videoFrames(request: ExportRequest, playing: Playing, video: VideoFormat, seconds: number): Frames {
  const usual = video === 'gif' ? USUAL_GIF_RATE : USUAL_RATE;
  const own = video === 'gif' ? null : playing.own;
  const rate = Math.min(request.rate ?? playing.fps ?? own ?? usual, MAX_RATE[video]);
  const oneWay = Math.max(Math.round(seconds * rate), 1);
  return { rate, frames: goesBack(request) ? 2 * oneWay : oneWay, whole: false };
}

/** Frame times of files, from the first to the last time, both included. */
function grid(
  { frames, rate }: ExportRequest,
  { fps, own }: Playing,
  { range, seconds, speed }: Pick<ExportNumbers, 'range' | 'seconds' | 'speed'>,
): Frames {
  const wholeFrames = frames === null && rate === null && fps !== null ? frameCount(range, fps) : 0;
  if (wholeFrames > 1) return { rate: fps! * speed, frames: wholeFrames, whole: true };
  const count = frames ?? Math.round(seconds * (rate ?? own ?? USUAL_RATE)) + 1;
  const clamped = clamp(count, 2, MAX_FRAMES);
  return { rate: (clamped - 1) / seconds, frames: clamped, whole: false };
}

/** The frame times of files. */
export function gridTimes({ range: [start, end], frames, whole, rate, speed }: ExportNumbers): number[] {
  if (!whole) return Array.from({ length: frames }, (_, i) => start + ((end - start) * i) / (frames - 1));
  return frameTimes([start, end], rate / speed);
}

/** Position of a video frame in the motion, in [0, 1], forwards and then backwards if it bounces. */
export function shareOf(frame: number, frames: number, bounce: boolean): number {
  if (!bounce) return frame / frames;
  const half = frames / 2;
  return frame <= half ? frame / half : (frames - frame) / half;
}

/** Size of the image; null: the size of the view on the screen. */
export function sizeOf(request: ExportRequest, video: VideoFormat | null): PictureSize | null {
  const name = sizeName(request, video);
  if (name === 'window') return null;
  return name === 'own' ? request.own : SIZES[name];
}

export function sizeName(request: ExportRequest, video: VideoFormat | null): SizeName {
  if (!isVideoRequest(request)) return request.size ?? 'window';
  return request.videoSize ?? (video === 'gif' ? 'small' : 'window');
}
