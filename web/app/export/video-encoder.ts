/** Videos by WebCodecs: every frame at its exact time, as fast as frames are drawn and encoded. */
import {
  BufferTarget,
  CanvasSource,
  Mp4OutputFormat,
  Output,
  Quality,
  WebMOutputFormat,
  getFirstEncodableVideoCodec,
} from 'mediabunny';
import type { VideoCodec } from 'mediabunny';
import type { VideoFormat } from '../../ui/export-dialog.ts';
import { videoFrames } from './video.ts';
import type { VideoOptions } from './video.ts';

const CODECS: Record<VideoFormat, VideoCodec[]> = { mp4: ['avc'], webm: ['vp9', 'vp8'] };
const QUALITY = new Quality({ bitrate: 12e6 });
/** Seconds between the frames that a player can jump to at once. */
const KEY_FRAME_INTERVAL = 1;

export async function write(options: VideoOptions): Promise<Blob> {
  const { format, framesPerSecond } = options;
  const picture = stillOf(options);
  const codec = await getFirstEncodableVideoCodec(CODECS[format], {
    width: picture.canvas.width,
    height: picture.canvas.height,
    quality: QUALITY,
    frameRate: framesPerSecond,
  });
  if (!codec) throw new Error('This browser cannot write a video of this size. Make the window smaller.');
  const target = new BufferTarget();
  const output = new Output({ format: format === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new CanvasSource(picture.canvas, { codec, quality: QUALITY, keyFrameInterval: KEY_FRAME_INTERVAL });
  output.addVideoTrack(source, { frameRate: framesPerSecond });
  try {
    await output.start();
    await addFrames(options, source, picture.take);
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  return new Blob([target.buffer!], { type: `video/${format}` });
}

async function addFrames(
  { seconds, framesPerSecond, draw, onProgress, signal }: VideoOptions,
  source: CanvasSource,
  take: () => void,
): Promise<void> {
  const frames = videoFrames(seconds, framesPerSecond);
  for (let frame = 0; frame < frames; frame += 1) {
    signal.throwIfAborted();
    await draw(Math.min(frame / (framesPerSecond * seconds), 1));
    take();
    await source.add(frame / framesPerSecond, 1 / framesPerSecond);
    onProgress((frame + 1) / frames);
  }
  signal.throwIfAborted();
}

/**
 * A canvas for one frame, of even size as encoders want it, and what puts the view on it: in the middle, should its
 * size change.
 */
function stillOf({ snapshot }: VideoOptions): { canvas: HTMLCanvasElement; take(): void } {
  const canvas = document.createElement('canvas');
  const even = (size: number): number => Math.max(size - (size % 2), 2);
  snapshot(({ width, height }) => Object.assign(canvas, { width: even(width), height: even(height) }));
  const context = canvas.getContext('2d', { alpha: false })!;
  const put = (view: HTMLCanvasElement): void => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(view, Math.ceil((canvas.width - view.width) / 2), Math.ceil((canvas.height - view.height) / 2));
  };
  return { canvas, take: () => snapshot(put) };
}
