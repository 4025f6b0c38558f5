/** The KG error of several samples over ghost mesh sizes (the paper's Fig. 8a), one sample at a time. */
import type { CallOptions, Engine } from '../../engine/api/api.ts';
import type { Progress } from '../../engine/api/types.ts';
import { GHOST_SIZES, studyGhosts, studyTimes } from '../../study/ghost-study.ts';
import { fetchSample, readingOf } from '../sources/samples.ts';
import type { Sample } from '../sources/samples.ts';

/** Samples of different shape and error, sorted by decreasing error as in the chart. */
const SHAPES: readonly string[] = ['octopus', 'hand', 'dachshund', 'cactus'];

/** The page's samples that are compared. */
export function chosenSamples(samples: readonly Sample[]): Sample[] {
  return SHAPES.map((id) => {
    const sample = samples.find((one) => one.id === id);
    if (!sample) throw new Error(`The shapes cannot be compared: this page has no sample “${id}”.`);
    return sample;
  });
}

export interface ShapeErrors {
  id: string;
  title: string;
  /** KG errors in percent, for the first sizes. A ghost has fewer faces than its shape. */
  kg: number[];
}

export interface ShapesCall {
  signal: AbortSignal;
  onProgress: NonNullable<CallOptions['onProgress']>;
}

/** Uses the paper's transfer. */
export async function studyShapes(
  engine: Engine,
  samples: readonly Sample[],
  { signal, onProgress }: ShapesCall,
): Promise<ShapeErrors[]> {
  const found: ShapeErrors[] = [];
  for (const [index, sample] of samples.entries()) {
    const report = (progress: Progress): void => {
      const name = `${sample.title} (${index + 1} of ${samples.length})`;
      onProgress(partOf(progress, name, index, samples.length));
    };
    report({ stage: 'reading', fraction: 0 });
    const keys = await engine.importKeyframes(await fetchSample(sample, signal), readingOf(sample), { signal });
    try {
      const { boundary, hold, id, title } = sample;
      const { times } = keys.info;
      const call = { times: studyTimes(times[0]!, times.at(-1)!), signal, onProgress: report };
      const { rows } = await studyGhosts(engine, keys, { boundary, hold }, { ...call, transfers: ['paper'] });
      found.push({ id, title, kg: rows.map(({ kg }) => kg) });
    } finally {
      keys.dispose();
    }
  }
  return found;
}

/** Converts progress of one of several equal parts into total progress. */
export function partOf({ stage, fraction }: Progress, name: string, index: number, count: number): Progress {
  return { stage: `${name}: ${stage}`, fraction: (index + fraction) / count };
}

/** One line per shape, over all sizes that any of the shapes has. */
export function shapeLines(shapes: readonly ShapeErrors[]) {
  return {
    faces: GHOST_SIZES.slice(0, Math.max(...shapes.map(({ kg }) => kg.length))),
    series: shapes.map(({ id, title, kg }) => ({ label: title, style: `ghost-${id}`, values: kg })),
  };
}
