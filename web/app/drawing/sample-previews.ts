/**
 * Pictures of the samples in motion, for their gallery: as long as it is open, one sample after the other is fetched,
 * fitted and drawn by the same engine and viewer that show it when it is chosen.
 */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { Boundary, InputFile } from '../../engine/api/types.ts';
import type { Viewer } from '../../viewer/viewer.ts';
import { extentOf } from './bounds.ts';

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
}

export interface SamplePreviews {
  start(): void;
  stop(): void;
}

const SIZE = { width: 152, height: 104 };
const DETAIL = 0.3;
/** Of a loop; there and back it is twice as many. */
const PICTURES = 10;

export function createSamplePreviews<Known extends Sample>(parts: SamplePreviewsParts<Known>): SamplePreviews {
  const { samples, has } = parts;
  let running: AbortController | null = null;

  const work = async (signal: AbortSignal): Promise<void> => {
    for (const sample of samples()) {
      if (signal.aborted) return;
      if (!has(sample.id)) await drawSample(parts, sample, signal);
    }
  };

  return {
    start() {
      if (running) return;
      const abort = new AbortController();
      running = abort;
      work(abort.signal)
        .catch((error: unknown) => {
          // A card without a picture says by its words what it is; what is wrong is said where it is opened.
          if (!abort.signal.aborted && !isCancelled(error)) return;
        })
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

async function drawSample<Known extends Sample>(
  { engine, viewer, fetch, isDark, onPictures }: SamplePreviewsParts<Known>,
  sample: Known,
  signal: AbortSignal,
): Promise<void> {
  const files = await fetch(sample, signal, DETAIL);
  const keys = await engine.importKeyframes(files, sample.times ? { keyTimes: sample.times } : {}, { signal });
  try {
    const sequence = await engine.createSequence(keys, { boundary: sample.boundary }, { signal });
    const poses = sequence.keyTimes.map((_, index) => keys.positions(index));
    const { bounds, points } = extentOf(poses);
    const pictures = await viewer.pictures(keys.info, bounds, points);
    try {
      const drawn: HTMLCanvasElement[] = [];
      for (const t of momentsOf(sequence.range, sample.boundary)) {
        if (signal.aborted) return;
        const frame = await sequence.evaluate(t);
        if (!frame) continue;
        const picture = pictures.draw(frame.positions, frame.normals, SIZE.width, SIZE.height, isDark());
        frame.release();
        if (picture) drawn.push(picture);
      }
      const back = sample.boundary === 'periodic' ? [] : drawn.slice(1, -1).reverse();
      onPictures(sample.id, [...drawn, ...back]);
    } finally {
      pictures.dispose();
      sequence.dispose();
    }
  } finally {
    keys.dispose();
  }
}

/** Evenly, from the first key to the last, or once round. */
function momentsOf([first, last]: readonly [number, number], boundary: Boundary): number[] {
  const steps = boundary === 'periodic' ? PICTURES : PICTURES - 1;
  return Array.from({ length: PICTURES }, (_, i) => first + ((last - first) * i) / steps);
}
