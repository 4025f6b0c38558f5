/** The input of video encoders. */
import type { VideoFormat } from '../../model/export-request.ts';

export interface VideoOptions {
  format: VideoFormat;
  /** Each frame covers its part of a second, so frames fill the time exactly. */
  frames: number;
  framesPerSecond: number;
  /** The canvas for drawing frames, of even size. */
  canvas: HTMLCanvasElement;
  /** Draws a frame; resolves when it is on the canvas. */
  draw(frame: number): Promise<void>;
  /** Receives the number of finished frames. */
  onFrame(done: number): void;
  signal: AbortSignal;
}

/** Bits per second: enough for sharp edges, with fewer bits per pixel in larger images. */
export function bitrateOf({ width, height }: { width: number; height: number }, framesPerSecond: number): number {
  const pixels = (width * height * framesPerSecond) / (1920 * 1080 * 30);
  return Math.round(12e6 * Math.max(pixels, 0.5) ** 0.75);
}
