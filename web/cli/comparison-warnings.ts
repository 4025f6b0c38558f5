/** Reasons why comparing a motion with an animation may be meaningless, with advice. */

/** Ratio of two sizes or errors above which one is doubtful. */
const OTHER_SIZE = 3;
const BETTER = 0.25;
/** Share of the shape's size within which positions are equal. */
const SAME_PLACE = 0.01;
/** A comparison with fewer frames is not meaningful. */
const FEW_FRAMES = 5;
/** Tolerance of equal ranges, relative to the range of the keys. */
const SAME_SPAN = 1e-3;

export interface Spans {
  keys: readonly [number, number];
  animation: readonly [number, number];
  /** Number of frames in the animation, and of compared frames. */
  frames: number;
  compared: number;
}

export function timeWarnings({ keys, animation, frames, compared }: Spans): string[] {
  const warnings: string[] = [];
  const [first, last] = keys;
  const [start, end] = animation;
  if (Math.abs(start - first) + Math.abs(end - last) > SAME_SPAN * (last - first))
    warnings.push(
      `the keys run from ${text(first)} to ${text(last)} s, and the animation from ${text(start)} to ${text(end)} s. ` +
        `${compared === frames ? 'All' : `${compared} of its ${frames}`} frames are compared with the motion at the frames' own times. ` +
        'If both are the same motion, give its times with --key-times',
    );
  const few = compared === 1 ? '1 frame is' : `${compared} frames are`;
  if (compared < FEW_FRAMES) warnings.push(`only ${few} compared, too few to judge the motion`);
  return warnings;
}

/** Both shapes at one time, 3 x vertices. */
export interface Pair {
  motion: Float32Array;
  animation: Float32Array;
}

export interface AxisAndUnit {
  /** Up axis of the animation; null if its files specify Y up. */
  up: 'y' | 'z' | null;
  unit: number;
}

export function alignmentWarnings(pairs: readonly Pair[], { up, unit }: AxisAndUnit): string[] {
  const ratio = sizeOf(pairs, 'animation') / sizeOf(pairs, 'motion');
  if (ratio > OTHER_SIZE || ratio < 1 / OTHER_SIZE)
    return [
      `the animation is ${text(ratio)} times as large as the keys. If its unit differs, give ` +
        `--against-unit ${text(unit / ratio)}`,
    ];
  const own = offBy(pairs, (x, y, z) => [x, y, z]);
  const stoodUp = offBy(pairs, (x, y, z) => [x, z, -y]);
  const laidBack = offBy(pairs, (x, y, z) => [x, -z, y]);
  if (Math.min(stoodUp, laidBack) < BETTER * own) {
    const animation = up === null ? null : stoodUp < laidBack ? (up === 'y' ? 'z' : null) : up === 'z' ? 'y' : null;
    const keys = stoodUp < laidBack ? 'y' : 'z';
    return [
      `the animation fits the keys far better with a different up axis. Give ` +
        (animation ? `--against-up ${animation}` : `--up ${keys}`),
    ];
  }
  const offset = meanOffset(pairs);
  const away = Math.hypot(...offset) / sizeOf(pairs, 'motion');
  const explains =
    away > SAME_PLACE && offBy(pairs, (x, y, z) => [x - offset[0]!, y - offset[1]!, z - offset[2]!]) < BETTER * own;
  return away > 1 || explains
    ? [
        `the animation is offset from the motion by ${text(100 * away)} % of the shape's size. ` +
          `${explains ? 'This offset causes most of the error: move' : 'Move'} the animation or the keys to compare their motions`,
      ]
    : [];
}

const text = (value: number): string => String(Number(value.toPrecision(3)));

function sizeOf(pairs: readonly Pair[], which: keyof Pair): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const pair of pairs)
    pair[which].forEach((value, i) => {
      low[i % 3] = Math.min(low[i % 3]!, value);
      high[i % 3] = Math.max(high[i % 3]!, value);
    });
  return Math.hypot(...high.map((value, axis) => value - low[axis]!));
}

type Turn = (x: number, y: number, z: number) => readonly [number, number, number];

/** Sum of squared distances between the motion and the rotated animation. */
function offBy(pairs: readonly Pair[], turn: Turn): number {
  let sum = 0;
  for (const { motion, animation } of pairs)
    for (let i = 0; i < motion.length; i += 3) {
      const [x, y, z] = turn(animation[i]!, animation[i + 1]!, animation[i + 2]!);
      sum += (x - motion[i]!) ** 2 + (y - motion[i + 1]!) ** 2 + (z - motion[i + 2]!) ** 2;
    }
  return sum;
}

/** Mean displacement from the motion to the animation, over all vertices and times. */
function meanOffset(pairs: readonly Pair[]): number[] {
  const sum = [0, 0, 0];
  let count = 0;
  for (const { motion, animation } of pairs) {
    animation.forEach((value, i) => (sum[i % 3]! += value - motion[i]!));
    count += motion.length / 3;
  }
  return sum.map((value) => value / Math.max(count, 1));
}
