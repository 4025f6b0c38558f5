/** Videos by WebCodecs: exact frame times, as fast as drawing and encoding allow. */
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
import { bitrateOf } from './video.ts';
import type { VideoOptions } from './video.ts';

const CODECS: Record<string, VideoCodec[]> = { mp4: ['avc'], webm: ['vp9', 'vp8'] };
/** Seconds between key frames, for seeking. */
const KEY_FRAME_INTERVAL = 1;

export async function write(options: VideoOptions): Promise<Blob> {
  const { format, framesPerSecond, canvas } = options;
  const quality = new Quality({ bitrate: bitrateOf(canvas, framesPerSecond) });
  const codec = await getFirstEncodableVideoCodec(CODECS[format]!, {
    width: canvas.width,
    height: canvas.height,
    quality,
    frameRate: framesPerSecond,
  });
  if (!codec) throw new Error('This browser cannot write a video of this size. Choose a smaller size.');
  const target = new BufferTarget();
  const container = format === 'mp4' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const output = new Output({ format: container, target });
  const source = new CanvasSource(canvas, { codec, quality, keyFrameInterval: KEY_FRAME_INTERVAL });
  output.addVideoTrack(source, { frameRate: framesPerSecond });
  try {
    await output.start();
    await addFrames(options, source);
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  return new Blob([target.buffer!], { type: `video/${format}` });
}

async function addFrames(
  { frames, framesPerSecond, draw, onFrame, signal }: VideoOptions,
  source: CanvasSource,
): Promise<void> {
  for (let frame = 0; frame < frames; frame += 1) {
    signal.throwIfAborted();
    await draw(frame);
    await source.add(frame / framesPerSecond, 1 / framesPerSecond);
    onFrame(frame + 1);
  }
  signal.throwIfAborted();
}
