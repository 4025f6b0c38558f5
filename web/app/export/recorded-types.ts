/** Formats of the browser's recorder. */
import type { VideoFormat } from '../../model/export-request.ts';

const TYPES: Record<VideoFormat, readonly string[]> = {
  mp4: ['video/mp4;codecs=avc1.42E01E', 'video/mp4'],
  webm: ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'],
  gif: [],
};

export function recordableFormats(): VideoFormat[] {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return [];
  return (['webm', 'mp4'] as const).filter((format) => recordedType(format) !== undefined);
}

export function recordedType(format: VideoFormat): string | undefined {
  return TYPES[format].find((type) => MediaRecorder.isTypeSupported(type));
}
