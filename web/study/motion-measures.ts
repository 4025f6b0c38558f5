/** Volume, area, bending energy and shape plane of a motion over time, and a table for several motions. */
import { METHOD } from '../engine/api/methods.ts';
import type { CallOptions, Motion } from '../engine/api/api.ts';
import type { Method } from '../engine/api/types.ts';

/** Identifies a measured motion; `plain`: without holding, as published. */
export interface MotionName {
  method: Method;
  plain?: true;
}

export interface MotionMeasures extends MotionName {
  /** Volume and area, in cubic and square units of the positions. */
  volume: number[];
  area: number[];
  /**
   * Bending energy per unit of time to the fourth, relative to the mean deformation energy between keys. For vertex
   * blends, in the space of vertices, as in the paper's comparison (Fig. 9).
   */
  bending: number[];
  /** Bending energy by edge lengths and angles, the same measure for every method, where it was asked for. */
  shell?: number[];
  /** Displacement of resting vertices, % of the diagonal; NaN if none rest. */
  sliding: number[];
  /** Points in the shape plane, 2 numbers per time, relative to the distance of the keys; methods of LRI space only. */
  plane: number[] | null;
}

export async function measureMotion(
  sequence: Motion,
  name: MotionName,
  times: number[],
  call?: CallOptions,
): Promise<MotionMeasures> {
  const { method, plain } = name;
  const { volume, area, sliding } = await sequence.measures(times, call);
  const plane = METHOD[method].space === 'lri' ? (await sequence.shapePlane(times)).curve : null;
  const [start, end] = sequence.range;
  const none = NO_BENDING / (end - start) ** 4;
  const bending = (await sequence.bendingEnergy(times)).map((energy) => (energy < none ? 0 : energy));
  return { method, ...(plain && { plain }), volume, area, bending, sliding, plane };
}

/** Bending energy below this, for a range of length 1, is rounding error of a straight motion. */
const NO_BENDING = 1e-12;

/** One value per time; NaN if undefined. */
export interface Column {
  name: string;
  values: readonly number[];
}

/** Significant digits, limited by the engine's single precision. */
const DIGITS = 7;
/** Enough digits to distinguish times. */
const TIME_DIGITS = 12;

export const MEASURE_UNITS =
  '# units: time s on the timeline; seconds s from the start as exported; volume m^3; area m^2; ' +
  'bending energy 1/s^4, relative to the mean deformation energy between keys; ' +
  "sliding: displacement of resting vertices, % of the model's size; plane: relative to the mean distance between keys";

/** Unit of the columns of bending by edge lengths and angles. */
export const SHELL_UNITS =
  '# bending by edge lengths and angles: squared acceleration of edge lengths and of angles between faces, the same ' +
  'measure for every method; 1/s^4, relative to the mean squared change between keys';

export function columnsOf(measures: MotionMeasures): Column[] {
  const { method, plain, volume, area, bending, sliding, plane, shell } = measures;
  const name = plain ? `${method} plain` : method;
  const part = (points: readonly number[], axis: 0 | 1): number[] => points.filter((_, index) => index % 2 === axis);
  return [
    { name: `${name} volume`, values: volume },
    { name: `${name} area`, values: area },
    { name: `${name} bending energy`, values: bending },
    { name: `${name} sliding`, values: sliding },
    ...(plane
      ? [
          { name: `${name} plane x`, values: part(plane, 0) },
          { name: `${name} plane y`, values: part(plane, 1) },
        ]
      : []),
    ...(shell ? [{ name: `${name} bending by edge lengths and angles`, values: shell }] : []),
  ];
}

/** The header and a row per time. `speed`: playback speed of the export relative to the timeline. */
export function tableOf(times: readonly number[], speed: number, columns: readonly Column[]): string[] {
  const [first = 0] = times;
  const rows = times.map((t, index) =>
    [
      rounded(t, TIME_DIGITS),
      rounded((t - first) / speed, TIME_DIGITS),
      ...columns.map(({ values }) => cell(values[index] ?? NaN)),
    ].join(','),
  );
  return [['time', 'seconds', ...columns.map(({ name }) => name)].join(','), ...rows];
}

/**
 * The JSON of a value for a comment line of a table. Names contain no separators and no leading sign, so spreadsheets
 * do not read them as formulas. Parses back to the same value.
 */
export function tableJson(value: unknown): string {
  return JSON.stringify(value).replace(/"(?:[^"\\]|\\.)*"/g, (name) =>
    name.replace(/[,;]|(?<=^")[=+@-]/g, (mark) => `\\u00${mark.charCodeAt(0).toString(16)}`),
  );
}

function cell(value: number): string {
  return Number.isNaN(value) ? '' : String(rounded(value, DIGITS));
}

function rounded(value: number, digits: number): number {
  return Number(value.toPrecision(digits));
}
