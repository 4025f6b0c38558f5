/** A video of the canvas, frame by frame, in the browser's own encoder. */

const TYPES = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];
const BITS_PER_SECOND = 12e6;

export interface Video {
  blob: Blob;
  extension: 'webm' | 'mp4';
}

export interface RecordOptions {
  canvas: HTMLCanvasElement;
  seconds: number;
  framesPerSecond: number;
  /** Draws the moment at a share of the whole, in [0, 1]; resolves when it is on the canvas. */
  draw(share: number): Promise<void>;
  onProgress(fraction: number): void;
  signal: AbortSignal;
}

/** The video type this browser can write, or null. */
export function videoType(): string | null {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  return TYPES.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

/** Real time passes between the frames, because the encoder stamps them by the clock. */
export async function record({
  canvas,
  seconds,
  framesPerSecond,
  draw,
  onProgress,
  signal,
}: RecordOptions): Promise<Video> {
  const type = videoType();
  if (!type) throw new Error('This browser cannot write videos. Export OBJ frames or a GLB instead.');
  const recorder = new MediaRecorder(canvas.captureStream(framesPerSecond), {
    mimeType: type,
    videoBitsPerSecond: BITS_PER_SECOND,
  });
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
    const frames = Math.max(Math.round(seconds * framesPerSecond), 1);
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
  const extension = type.startsWith('video/mp4') ? 'mp4' : 'webm';
  return { blob: new Blob(chunks, { type: type.split(';')[0]! }), extension };
}

function until(time: number): Promise<void> {
  return new Promise((resolve) => window.setTimeout(resolve, Math.max(time - performance.now(), 0)));
}
