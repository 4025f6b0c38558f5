/**
 * Pictures of the samples in motion, for their gallery: as long as it is open, one sample after the other is fetched,
 * fitted and drawn by the same engine and viewer that show it when it is chosen.
 */
import type { Engine, Keys } from '../../engine/api/api.ts';
import type { Boundary, InputFile } from '../../engine/api/types.ts';
import type { Pictures } from '../../viewer/pictures.ts';
import type { Viewer } from '../../viewer/viewer.ts';
import { extentOf } from '../../viewer/bounds.ts';
import { vertexNormals } from './vertex-normals.ts';

interface Sample {
  id: string;
  times: number[] | null;
  boundary: Boundary;
}

export interface SamplePreviewsParts<Known extends Sample> {
  engine: Engine;
  viewer: Viewer;
  samples(): readonly Known[];
  /** `detail` 1 is what is opened; less is enough here. */
  fetch(sample: Known, signal: AbortSignal, detail: number): Promise<InputFile[]>;
  isDark(): boolean;
  has(id: string): boolean;
  /** In the order in which they are shown, over and over. */
  onPictures(id: string, pictures: readonly HTMLCanvasElement[]): void;
  /** Samples are without a picture yet, which are being made. */
  onDrawing(drawing: boolean): void;
}

export interface SamplePreviews {
  start(): void;
  stop(): void;
}

const SIZE = { width: 152, height: 104 };
const DETAIL = 0.3;
/** Of a loop; there and back it is twice as many. */
const MOMENTS = 10;

export function createSamplePreviews<Known extends Sample>(parts: SamplePreviewsParts<Known>): SamplePreviews {
  let running: AbortController | null = null;
  const moving = new Set<string>();

  /** First a picture of each, then each in motion. */
  const work = async (signal: AbortSignal): Promise<void> => {
    const read: Read<Known>[] = [];
    const still = parts.samples().filter(({ id }) => !moving.has(id));
    try {
      parts.onDrawing(still.some(({ id }) => !parts.has(id)));
      let files = fetched(parts, still[0], signal);
      for (const [index, sample] of still.entries()) {
        const these = await files;
        signal.throwIfAborted();
        // The next one comes while this one is drawn.
        files = fetched(parts, still[index + 1], signal);
        read.push(await drawStill(parts, sample, these!, signal));
      }
      parts.onDrawing(false);
      for (const one of read) {
        signal.throwIfAborted();
        await drawMotion(parts, one, signal);
        moving.add(one.sample.id);
      }
    } finally {
      if (!running || running.signal === signal) parts.onDrawing(false);
      for (const { keys, pictures } of read) {
        pictures.dispose();
        keys.dispose();
      }
    }
  };

  return {
    start() {
      if (running) return;
      const abort = new AbortController();
      running = abort;
      work(abort.signal)
        // A card without a picture says by its words what it is; what is wrong is said where it is opened.
        .catch(() => undefined)
        .finally(() => {
          if (running === abort) running = null;
        });
    },
    stop() {
      running?.abort();
      running = null;
    },
  };
}

interface Read<Known> {
  sample: Known;
  keys: Keys;
  pictures: Pictures;
}

/** Whose failure is that of who waits for it. */
function fetched<Known extends Sample>(
  { fetch }: SamplePreviewsParts<Known>,
  sample: Known | undefined,
  signal: AbortSignal,
): Promise<InputFile[] | null> {
  const files = sample ? fetch(sample, signal, DETAIL) : Promise.resolve(null);
  files.catch(() => undefined);
  return files;
}

async function drawStill<Known extends Sample>(
  { engine, viewer, isDark, has, onPictures }: SamplePreviewsParts<Known>,
  sample: Known,
  files: InputFile[],
  signal: AbortSignal,
): Promise<Read<Known>> {
  const keys = await engine.importKeyframes(files, sample.times ? { keyTimes: sample.times } : {}, { signal });
  const poses = keys.info.times.map((_, index) => keys.positions(index));
  const { bounds, points } = extentOf(poses);
  const pictures = await viewer.pictures(keys.info, bounds, points);
  const [first] = poses;
  if (first && !has(sample.id)) {
    const normals = new Float32Array(first.length);
    vertexNormals(first, keys.info.faces, normals);
    const picture = pictures.draw(first, normals, SIZE.width, SIZE.height, isDark());
    if (picture) onPictures(sample.id, [picture]);
  }
  return { sample, keys, pictures };
}

async function drawMotion<Known extends Sample>(
  { engine, isDark, onPictures }: SamplePreviewsParts<Known>,
  { sample, keys, pictures }: Read<Known>,
  signal: AbortSignal,
): Promise<void> {
  const sequence = await engine.createSequence(keys, { boundary: sample.boundary }, { signal });
  try {
    const drawn: HTMLCanvasElement[] = [];
    for (const t of momentsOf(sequence.range, sample.boundary)) {
      signal.throwIfAborted();
      const frame = await sequence.evaluate(t);
      if (!frame) continue;
      const picture = pictures.draw(frame.positions, frame.normals, SIZE.width, SIZE.height, isDark());
      frame.release();
      if (picture) drawn.push(picture);
    }
    const back = sample.boundary === 'periodic' ? [] : drawn.slice(1, -1).reverse();
    onPictures(sample.id, [...drawn, ...back]);
  } finally {
    sequence.dispose();
  }
}

/** Evenly, from the first key to the last, or once round. */
function momentsOf([first, last]: readonly [number, number], boundary: Boundary): number[] {
  const steps = boundary === 'periodic' ? MOMENTS : MOMENTS - 1;
  return Array.from({ length: MOMENTS }, (_, i) => first + ((last - first) * i) / steps);
}
