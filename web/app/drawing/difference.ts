/** Distance of each vertex from its position without a ghost mesh (the paper's Fig. 7), and its colour. */
import { viridis } from '../../plots/viridis.ts';

/** The drawn distances at one time. */
export interface Difference {
  /** One value per vertex, in percent of the diagonal. */
  percent: Float32Array;
  largest: number;
  mean: number;
}

const SHADES = 256;
/** Values below this, in percent, are rounding errors. */
const MIN_TOP = 0.001;

/** Positions are 3 x vertices; fills `percent` if given. */
export function differenceOf(
  positions: Float32Array,
  reference: Float32Array,
  diagonal: number,
  percent: Float32Array = new Float32Array(positions.length / 3),
): Difference {
  let largest = 0;
  let sum = 0;
  for (let v = 0; v < percent.length; v += 1) {
    const i = 3 * v;
    const dx = positions[i]! - reference[i]!;
    const dy = positions[i + 1]! - reference[i + 1]!;
    const dz = positions[i + 2]! - reference[i + 2]!;
    const value = (100 * Math.sqrt(dx * dx + dy * dy + dz * dz)) / diagonal;
    percent[v] = value;
    largest = Math.max(largest, value);
    sum += value;
  }
  return { percent, largest, mean: percent.length > 0 ? sum / percent.length : 0 };
}

/** Rounds up to a round number: the upper end of the colour bar. */
export function roundTop(largest: number): number {
  if (!(largest > MIN_TOP)) return MIN_TOP;
  const power = 10 ** Math.floor(Math.log10(largest));
  const factor = [1, 2, 5].find((digit) => digit * power >= largest * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(3));
}

/** The colour of each vertex, 3 x vertices, linear RGB; fills `colours` if given. */
export function heatColours(
  { percent }: Pick<Difference, 'percent'>,
  top: number,
  colours: Float32Array = new Float32Array(3 * percent.length),
): Float32Array {
  for (let v = 0; v < percent.length; v += 1) {
    const shade = Math.min(Math.round((percent[v]! / top) * (SHADES - 1)), SHADES - 1);
    for (let c = 0; c < 3; c += 1) colours[3 * v + c] = TABLE[3 * shade + c]!;
  }
  return colours;
}

const TABLE = Float32Array.from(Array.from({ length: SHADES }, (_, i) => viridis(i / (SHADES - 1))).flat(), (value) =>
  value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4,
);
