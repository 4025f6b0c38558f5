/** Videos of the canvas: finds the formats and the encoder that this browser supports. */
import type { PictureSize, VideoFormat } from '../../model/export-request.ts';
import { recordableFormats } from './recorded-types.ts';
import type { VideoOptions } from './video.ts';

/** Codecs to test, in a profile that every encoder supports. The final profile follows from the size. */
const CODECS = { mp4: ['avc1.42001f'], webm: ['vp09.00.10.08', 'vp8'] } as const;

/** Formats that this browser can write, the most widely playable first. GIF needs no browser support. */
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

/** Loads encoders and muxer with the first video. */
export async function writeVideo(options: VideoOptions): Promise<Blob> {
  const { write } = await encoderOf(options.format);
  return write(options);
}

function encoderOf(format: VideoFormat): Promise<{ write(options: VideoOptions): Promise<Blob> }> {
  if (format === 'gif') return import('./gif-encoder.ts');
  return typeof VideoEncoder === 'undefined' ? import('./media-recorder.ts') : import('./video-encoder.ts');
}
