/** Videos of the canvas: what this browser can write, and by which of its two encoders. */
import type { VideoFormat } from '../../ui/export-dialog.ts';
import type { VideoOptions } from './video.ts';

/** Codecs that are asked about, in a profile that every encoder of theirs has; the real one follows from the size. */
const CODECS: Record<VideoFormat, readonly string[]> = { mp4: ['avc1.42001f'], webm: ['vp09.00.10.08', 'vp8'] };

/** What this browser can write, the format that plays in more places first. */
export async function videoFormats(): Promise<VideoFormat[]> {
  if (typeof VideoEncoder === 'undefined') return (await import('./media-recorder.ts')).recordableFormats();
  const formats = ['mp4', 'webm'] as const;
  const encodable = await Promise.all(formats.map((format) => isEncodable(CODECS[format])));
  return formats.filter((_, index) => encodable[index]);
}

async function isEncodable(codecs: readonly string[]): Promise<boolean> {
  const size = { width: 640, height: 480 };
  const supports = await Promise.all(codecs.map((codec) => VideoEncoder.isConfigSupported({ codec, ...size })));
  return supports.some(({ supported }) => supported);
}

/** Encoders and muxer are loaded when the first video is made. */
export async function writeVideo(options: VideoOptions): Promise<Blob> {
  const { write } =
    typeof VideoEncoder === 'undefined' ? await import('./media-recorder.ts') : await import('./video-encoder.ts');
  return write(options);
}
