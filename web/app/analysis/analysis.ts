/** Volume, area, bending energy and shape plane of the shown motions over time. */
import type { CallOptions } from '../../engine/api/api.ts';
import { endTangents, referenceKey } from '../../model/state.ts';
import type { Doc } from '../../model/state.ts';
import { plottedTimes } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { measureMotion } from '../../study/motion-measures.ts';
import type { MotionMeasures, MotionName } from '../../study/motion-measures.ts';
import type { RunningMotion } from '../../playback/frame-set.ts';
import type { ShapePlaneInput } from './shape-plane.ts';

/** The data of all plots and of the CSV. */
export interface Analysis {
  times: number[];
  keyTimes: readonly number[];
  range: Range;
  motions: MotionMeasures[];
}

export interface AnalysisInput extends ShapePlaneInput {
  /** Milliseconds per frame. Slow frames reduce the number of times. */
  ms: number;
  /** Index of the reference key, whose rotations and stretches are zero. */
  reference: number;
}

/** Motions with and without a ghost mesh are not comparable. Only those of the first one's kind are analysed. */
export function analysisInput(running: readonly RunningMotion[], doc: Doc, range: Range, ms: number): AnalysisInput {
  const [main] = running;
  return {
    sequences: running.filter((one) => one === main || one.ghost === main?.ghost),
    range,
    ms,
    keyTimes: doc.keys.map((key) => key.time),
    towards: endTangents(doc),
    reference: referenceKey(doc),
  };
}

const BUDGET_MS = 1200;
const MIN_TIMES = 13;
const MAX_TIMES = 97;

export async function analyse(
  { sequences, keyTimes, range, ms }: AnalysisInput,
  { signal, onProgress }: Required<CallOptions>,
): Promise<Analysis> {
  const affordable = BUDGET_MS / Math.max(ms * sequences.length, 0.1);
  const times = plottedTimes(range, keyTimes, Math.round(Math.min(Math.max(affordable, MIN_TIMES), MAX_TIMES)));
  const done = sequences.map(() => 0);
  const motions = await Promise.all(
    sequences.map((running, index) => {
      const report: typeof onProgress = ({ stage, fraction }) => {
        done[index] = fraction;
        onProgress({ stage, fraction: done.reduce((sum, share) => sum + share, 0) / done.length });
      };
      return measureMotion(running.sequence, running, times, { signal, onProgress: report });
    }),
  );
  return { times, keyTimes, range, motions };
}

/** Times per request. The analysis can be cancelled between requests. */
const AT_ONCE = 16;

/** Analyses the motions at these times, any number of them. Rejects when `signal` aborts. */
export async function analyseAt(
  { sequences, keyTimes, range }: AnalysisInput,
  times: readonly number[],
  report: (fraction: number) => void,
  signal: AbortSignal,
): Promise<Analysis> {
  const motions: MotionMeasures[] = [];
  for (const [index, running] of sequences.entries()) {
    const parts: MotionMeasures[] = [];
    for (let from = 0; from < times.length; from += AT_ONCE) {
      signal.throwIfAborted();
      parts.push(await measureMotion(running.sequence, running, times.slice(from, from + AT_ONCE)));
      report((index + Math.min((from + AT_ONCE) / times.length, 1)) / sequences.length);
    }
    motions.push(joined(running, parts));
  }
  return { times: [...times], keyTimes, range, motions };
}

function joined({ method, plain }: MotionName, parts: readonly MotionMeasures[]): MotionMeasures {
  const all = (of: (part: MotionMeasures) => number[] | null): number[] => parts.flatMap((part) => of(part) ?? []);
  return {
    method,
    ...(plain && { plain }),
    volume: all(({ volume }) => volume),
    area: all(({ area }) => area),
    bending: all(({ bending }) => bending),
    sliding: all(({ sliding }) => sliding),
    plane: parts[0]?.plane ? all(({ plane }) => plane) : null,
  };
}

/** The values in percent of that at the first key; NaN if that value is 0, like the volume of a flat surface. */
export function relativeToFirstKey(values: readonly number[], { times, keyTimes }: Analysis): number[] {
  const base = values[times.indexOf(keyTimes[0] ?? 0)] ?? NaN;
  return values.map((value) => (base === 0 ? NaN : (100 * value) / base));
}
