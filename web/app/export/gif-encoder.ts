/** Videos as animated, looping GIF: 256 colours per frame, times in hundredths of a second. */
import { GIFEncoder, applyPalette, quantize } from 'gifenc';
import type { VideoOptions } from './video.ts';

const COLOURS = 256;

export async function write({ frames, framesPerSecond, canvas, draw, onFrame, signal }: VideoOptions): Promise<Blob> {
  const { width, height } = canvas;
  const context = canvas.getContext('2d')!;
  const gif = GIFEncoder();
  for (let frame = 0; frame < frames; frame += 1) {
    signal.throwIfAborted();
    await draw(frame);
    const { data } = context.getImageData(0, 0, width, height);
    const palette = quantize(data, COLOURS);
    gif.writeFrame(applyPalette(data, palette), width, height, {
      palette,
      delay: 10 * (hundredths(frame + 1, framesPerSecond) - hundredths(frame, framesPerSecond)),
    });
    onFrame(frame + 1);
  }
  signal.throwIfAborted();
  gif.finish();
  return new Blob([gif.bytes() as Uint8Array<ArrayBuffer>], { type: 'image/gif' });
}

/** Start time of a frame, rounded from the beginning so rounding errors do not accumulate. */
function hundredths(frame: number, framesPerSecond: number): number {
  return Math.round((100 * frame) / framesPerSecond);
}
