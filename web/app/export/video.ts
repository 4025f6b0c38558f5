/** What a video of the canvas is made of. */
import type { VideoFormat } from '../../ui/export-dialog.ts';

export interface VideoOptions {
  format: VideoFormat;
  seconds: number;
  framesPerSecond: number;
  /** Draws the moment at a share of the whole, in [0, 1]; resolves when it is on the canvas. */
  draw(share: number): Promise<void>;
  /** Draws the same again and gives the canvas to `use` while it holds the picture. */
  snapshot<T>(use: (canvas: HTMLCanvasElement) => T): T;
  onProgress(fraction: number): void;
  signal: AbortSignal;
}

/** Number of frames of a video: each stands for its part of a second, so that they fill the time exactly. */
export function videoFrames(seconds: number, framesPerSecond: number): number {
  return Math.max(Math.round(seconds * framesPerSecond), 1);
}
