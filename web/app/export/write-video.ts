/** Videos of the canvas: what this browser can write, and by which of its encoders. */
import type { PictureSize, VideoFormat } from '../../model/export-request.ts';
import { recordableFormats } from './recorded-types.ts';
import type { VideoOptions } from './video.ts';

/** Codecs that are asked about, in a profile that every encoder of theirs has; the real one follows from the size. */
const CODECS = { mp4: ['avc1.42001f'], webm: ['vp09.00.10.08', 'vp8'] } as const;

/** What this browser can write, the format that plays in more places first; GIF is written without its help. */
export async function videoFormats(): Promise<VideoFormat[]> {
  if (typeof VideoEncoder === 'undefined') return [...recordableFormats(), 'gif'];
  const formats = ['mp4', 'webm'] as const;
  const encodable = await Promise.all(
    formats.map((format) => isEncodable(CODECS[format], { width: 640, height: 480 })),
  );
  return [...formats.filter((_, index) => encodable[index]), 'gif'];
}

async function isEncodable(codecs: readonly string[], size: PictureSize): Promise<boolean> {
  const supports = await Promise.all(codecs.map((codec) => VideoEncoder.isConfigSupported({ codec, ...size })));
  return supports.some(({ supported }) => supported);
}

/** Encoders and muxer are loaded when the first video is made. */
export async function writeVideo(options: VideoOptions): Promise<Blob> {
  const { write } = await encoderOf(options.format);
  return write(options);
}

function encoderOf(format: VideoFormat): Promise<{ write(options: VideoOptions): Promise<Blob> }> {
  if (format === 'gif') return import('./gif-encoder.ts');
  return typeof VideoEncoder === 'undefined' ? import('./media-recorder.ts') : import('./video-encoder.ts');
}
