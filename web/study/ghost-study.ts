/**
 * Costs and benefits of a ghost mesh (the paper's Fig. 8): error against the motion without a ghost, and frame time,
 * over ghost sizes and both transfers. Each motion has a separate worker and is released afterwards.
 */
import type { CallOptions, Engine, Keys, Sequence } from '../engine/api/api.ts';
import { fitWarnings, isOwnAt, unfittedNote } from './fitted-intervals.ts';
import { KgError } from '../engine/timing/kg-error.ts';
import type { SequenceOptions, SequenceStats, Transfer } from '../engine/api/types.ts';

/** Sizes in the paper's figure. */
export const GHOST_SIZES: readonly number[] = [500, 1000, 2000, 3000, 5000, 10000];
export const TRANSFERS: readonly Transfer[] = ['exact', 'paper'];
const FRAMES = 24;
/** Relative difference up to which two frame times are reported as equal. */
const SAME_MS = 0.1;

export interface GhostRow {
  /** Requested number of faces, and the ghost's number. */
  wanted: number;
  faces: number;
  transfer: Transfer;
  /** Error against the motion without a ghost, in percent. */
  kg: number;
  /** Median time of a frame in the worker. */
  ms: number;
  /** Median time of the ghost mesh's shape, from the splines to its vertices. */
  ghostMs: number;
  /** Milliseconds from the keys until the first frame can be computed. */
  buildMs: number;
  stats: SequenceStats;
  fits: Fits;
}

/** Warnings about the fits of a method that fits shapes, and the intervals without fits, which are not measured. */
interface Fits {
  warnings: string[];
  note: string;
}

const fitsOf = (sequence: Sequence): Fits => ({ warnings: fitWarnings(sequence), note: unfittedNote(sequence) });

export interface GhostStudy {
  /** Number of faces of the shape. */
  faces: number;
  /** Frame time without a ghost. */
  ms: number;
  buildMs: number;
  fits: Fits;
  rows: GhostRow[];
}

export interface GhostStudyOptions extends CallOptions {
  times: readonly number[];
  /** Default: those of the paper's figure. Only ghosts smaller than the shape are made. */
  sizes?: readonly number[];
  transfers?: readonly Transfer[];
}

/** Times between start and end at which motions are measured. */
export function studyTimes(start: number, end: number): number[] {
  return Array.from({ length: FRAMES }, (_, i) => start + ((i + 0.5) / FRAMES) * (end - start));
}

export async function studyGhosts(
  engine: Engine,
  keys: Keys,
  options: Partial<SequenceOptions>,
  { times, sizes = GHOST_SIZES, transfers = TRANSFERS, signal, onProgress }: GhostStudyOptions,
): Promise<GhostStudy> {
  const { faces } = keys.info.report;
  const wanted = sizes
    .filter((size) => size < faces)
    .flatMap((size) => transfers.map((transfer) => ({ size, transfer })));
  const steps = wanted.length + 1;
  const build = async (step: number, change: Partial<SequenceOptions>): Promise<Built> => {
    const start = performance.now();
    const report = (fraction: number, stage: string): void =>
      onProgress?.({ stage, fraction: (step + fraction) / steps });
    const sequence = await engine.createSequence(
      keys,
      { ...options, ...change },
      {
        ...(signal && { signal }),
        onProgress: ({ stage, fraction }) => report(0.5 * fraction, stage),
      },
    );
    return {
      sequence,
      buildMs: performance.now() - start,
      evaluated: (fraction) => report(0.5 + 0.5 * fraction, 'evaluating'),
    };
  };
  const full = await build(0, { ghostFaces: 0 });
  try {
    const own = await compare(full, null, times, signal);
    const rows: GhostRow[] = [];
    for (const [index, { size, transfer }] of wanted.entries()) {
      const ghost = await build(index + 1, { ghostFaces: size, transfer });
      try {
        const { kg, ms } = await compare(ghost, full.sequence, times, signal);
        const ghostMs = await ghostTime(ghost.sequence, times);
        const stats = await ghost.sequence.stats();
        const fits = fitsOf(ghost.sequence);
        const { buildMs } = ghost;
        rows.push({ wanted: size, faces: stats.ghostFaces, transfer, kg, ms, ghostMs, buildMs, stats, fits });
      } finally {
        ghost.sequence.dispose();
      }
    }
    return { faces, ms: own.ms, buildMs: full.buildMs, fits: fitsOf(full.sequence), rows };
  } finally {
    full.sequence.dispose();
  }
}

/** KG error of a sequence relative to a reference over these times, in percent. */
export async function kgBetween(reference: Sequence, sequence: Sequence, times: readonly number[]): Promise<number> {
  return (await compare({ sequence, evaluated: () => undefined }, reference, times, undefined)).kg;
}

/** One or two sentences that summarise the numbers. */
export function verdictOf({ ms, rows }: GhostStudy): string {
  if (rows.length === 0) return 'The shape has fewer faces than the smallest of these ghost meshes.';
  const measured = rows.filter((row) => !Number.isNaN(row.ms));
  if (Number.isNaN(ms) || measured.length === 0) return 'The method fitted no shapes, so there is nothing to measure.';
  const fastest = measured.reduce((best, row) => (row.ms < best.ms ? row : best));
  const ghost = `${fastest.faces.toLocaleString('en')} ghost faces (${fastest.transfer}, KG ${percentText(fastest.kg)})`;
  if (fastest.ms > ms * (1 - SAME_MS)) {
    return `The full solve is as fast: ${msText(ms)} per frame without a ghost, at best ${msText(fastest.ms)} with ${ghost}.`;
  }
  return `The fastest ghost saves ${Math.round(100 * (1 - fastest.ms / ms))} % of the frame time: ${msText(fastest.ms)} with ${ghost}, ${msText(ms)} without.`;
}

const textOf = (value: number, unit: string): string =>
  Number.isNaN(value) ? 'none' : `${Number(value.toPrecision(2))} ${unit}`;
export const msText = (ms: number): string => textOf(ms, 'ms');
export const percentText = (percent: number): string => textOf(percent, '%');

interface Built {
  sequence: Sequence;
  buildMs: number;
  /** Called with the fraction of finished times. */
  evaluated(fraction: number): void;
}

/** Compares one frame after the other, which saves memory and keeps the two time measurements independent. */
async function compare(
  { sequence, evaluated }: Pick<Built, 'sequence' | 'evaluated'>,
  reference: Sequence | null,
  times: readonly number[],
  signal: AbortSignal | undefined,
): Promise<{ kg: number; ms: number }> {
  const error = new KgError();
  const ms: number[] = [];
  // Elsewhere, the numbers would be those of another method.
  const own = times.filter((t) => isOwnAt(sequence, t) && (!reference || isOwnAt(reference, t)));
  for (const [index, t] of own.entries()) {
    const [frame] = await sequence.evaluateMany([t], signal && { signal });
    const [other] = reference ? await reference.evaluateMany([t], signal && { signal }) : [];
    if (other) error.add(other.positions, frame!.positions);
    ms.push(frame!.ms);
    frame!.release();
    other?.release();
    evaluated((index + 1) / own.length);
  }
  return { kg: own.length > 0 ? error.percent : NaN, ms: median(ms) };
}

async function ghostTime(sequence: Sequence, times: readonly number[]): Promise<number> {
  const ms: number[] = [];
  for (const t of times.filter((one) => isOwnAt(sequence, one))) {
    await sequence.ghostPositions(t);
    ms.push((await sequence.stats()).ghostMs);
  }
  return median(ms);
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
