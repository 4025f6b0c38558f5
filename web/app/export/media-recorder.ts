/**
 * Videos where a browser has no WebCodecs: its recorder stamps frames by the clock, so that a video takes as long as it
 * plays.
 */
import type { VideoFormat } from '../../ui/export-dialog.ts';
import { videoFrames } from './video.ts';
import type { VideoOptions } from './video.ts';

const TYPES: Record<VideoFormat, readonly string[]> = {
  mp4: ['video/mp4;codecs=avc1.42E01E', 'video/mp4'],
  webm: ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'],
};
const BITS_PER_SECOND = 12e6;

export function recordableFormats(): VideoFormat[] {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return [];
  return (['webm', 'mp4'] as const).filter((format) => typeOf(format) !== undefined);
}

function typeOf(format: VideoFormat): string | undefined {
  return TYPES[format].find((type) => MediaRecorder.isTypeSupported(type));
}

export async function write({
  format,
  seconds,
  framesPerSecond,
  draw,
  snapshot,
  onProgress,
  signal,
}: VideoOptions): Promise<Blob> {
  const stream = snapshot((canvas) => canvas.captureStream(framesPerSecond));
  const recorder = new MediaRecorder(stream, { mimeType: typeOf(format), videoBitsPerSecond: BITS_PER_SECOND });
  const chunks: Blob[] = [];
  recorder.ondataavailable = (event) => {
    if (event.data.size > 0) chunks.push(event.data);
  };
  const stopped = new Promise<void>((resolve, reject) => {
    recorder.onstop = () => resolve();
    recorder.onerror = () => reject(new Error('The browser stopped writing the video.'));
  });
  await draw(0);
  recorder.start(500);
  try {
    const frames = videoFrames(seconds, framesPerSecond);
    const start = performance.now();
    for (let frame = 0; frame <= frames && !signal.aborted; frame += 1) {
      await draw(frame / frames);
      onProgress(frame / frames);
      await until(start + (1000 * frame) / framesPerSecond);
    }
  } finally {
    recorder.stop();
    await stopped;
    for (const track of recorder.stream.getTracks()) track.stop();
  }
  signal.throwIfAborted();
  return new Blob(chunks, { type: `video/${format}` });
}

function until(time: number): Promise<void> {
  return new Promise((resolve) => window.setTimeout(resolve, Math.max(time - performance.now(), 0)));
}
