/** Additional shapes in the viewport: onion skins around the current time, or a film strip of evenly spaced shapes. */
import type { Frame } from '../../engine/api/types.ts';
import { PHASE_COLOURS, clamp, formatTime, length, phaseOf } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { ONION_COLOURS } from '../../model/state.ts';
import type { View } from '../../model/state.ts';
import { rangeAlong } from '../../viewer/bounds.ts';
import type { Extra } from '../../viewer/types.ts';

type OnionView = Pick<View, 'onionSkins' | 'onionSpacing'>;

/** Default spacing of onion skins, as a share of the range. */
const ONION_STEP = 0.09;
/** Opacity of the nearest and of the farthest skin. */
const SOLID = 0.35;
const FAINT = 0.12;
const FILM_STEPS = 6;
const MAX_FILM_STEPS = 16;
const FILM_BEYOND = 1;

export interface OnionSkinInput {
  t: number;
  keys: readonly { time: number; name: string }[];
  range: Range;
  periodic: boolean;
}

/** Skins before and after the time, the farthest first, so nearer skins are drawn over them. */
export function onionTimes({ t, range }: OnionSkinInput, { onionSkins, onionSpacing }: OnionView): number[] {
  const step = onionSpacing ?? ONION_STEP * length(range);
  return Array.from({ length: onionSkins }, (_, i) => (onionSkins - i) * step).flatMap((away) => [t - away, t + away]);
}

/** `frames`: evaluated at onionTimes(). */
export function onionExtras({ t }: Pick<OnionSkinInput, 't'>, frames: readonly Frame[]): Extra[] {
  const pairs = frames.length / 2;
  return frames.map((frame, index) => {
    const near = pairs > 1 ? Math.floor(index / 2) / (pairs - 1) : 1;
    return {
      positions: frame.positions,
      normals: frame.normals,
      offset: 0,
      opacity: FAINT + near * (SOLID - FAINT),
      colour: frame.t < t ? ONION_COLOURS.before : ONION_COLOURS.after,
    };
  });
}

/**
 * Evenly spaced over the keys and slightly beyond both ends; the nearest time to a key becomes the key's time. `count`:
 * number of shapes, null for the default.
 */
export function filmTimes({ keys, range, periodic }: OnionSkinInput, count: number | null): number[] {
  const beyond = periodic ? 0 : FILM_BEYOND;
  const usual = clamp(keys.length - 1, FILM_STEPS, MAX_FILM_STEPS);
  const steps = count === null ? usual : count - 1 - 2 * beyond;
  const times = Array.from(
    { length: steps + 1 + 2 * beyond },
    (_, index) => range[0] + ((index - beyond) / steps) * length(range),
  );
  for (const { time } of keys) times[Math.round(((time - range[0]) / length(range)) * steps) + beyond] = time;
  return times;
}

/** Label positions for a strip's shapes, xyz interleaved: centred below each shape. */
export function filmLabelPositions(strip: readonly Extra[]): Float32Array {
  const lowest = Math.min(...strip.map(({ positions }) => rangeAlong(positions, 1)[0]));
  return Float32Array.from(
    strip.flatMap(({ positions, offset }) => {
      const middle = (axis: 0 | 2): number => rangeAlong(positions, axis).reduce((sum, end) => sum + end / 2, 0);
      return [middle(0) + offset, lowest, middle(2)];
    }),
  );
}

export interface FilmName {
  text: string;
  isKey: boolean;
}

/** Label of each shape of a strip: its key or its time. */
export function filmNames({ keys, range }: OnionSkinInput, times: readonly number[]): FilmName[] {
  return times.map((t) => {
    const key = keys.findIndex(({ time }) => time === t);
    return key < 0 ? { text: `${formatTime(t, range)} s`, isKey: false } : { text: `Key ${key + 1}`, isKey: true };
  });
}

/**
 * Strips of several motions, each along x. Shapes of the same time share a column, and column spacing follows the
 * widest shapes.
 */
export function filmStrips(input: OnionSkinInput, motions: readonly (readonly Frame[])[]): Extra[][] {
  const boxes = motions.map((frames) => frames.map(({ positions }) => rangeAlong(positions, 0)));
  const columns = columnsOf(boxes.map((strip) => strip.map(([low, high]) => high - low)));
  return motions.map((frames, motion) =>
    frames.map((frame, index) => {
      const [low, high] = boxes[motion]![index]!;
      return {
        positions: frame.positions,
        normals: frame.normals,
        opacity: 1,
        offset: columns[index]! - (low + high) / 2,
        colour: colourAt(frame.t, input, 0.01),
      };
    }),
  );
}

/** Distance between centres, in mean widths of neighbours. */
const FILM_SPACING = 1.08;

/** Column centres, symmetric about 0. `widths`: one width per shape of each strip. */
export function columnsOf(widths: readonly (readonly number[])[]): number[] {
  const widest = (widths[0] ?? []).map((_, column) => Math.max(...widths.map((strip) => strip[column]!)));
  const middles: number[] = [];
  widest.forEach((width, column) => {
    const before = middles[column - 1];
    middles.push(before === undefined ? 0 : before + (FILM_SPACING * (width + widest[column - 1]!)) / 2);
  });
  const middle = ((middles.at(-1) ?? 0) + ((widest.at(-1) ?? 0) - (widest[0] ?? 0)) / 2) / 2;
  return middles.map((x) => x - middle);
}

function colourAt(t: number, { keys, range, periodic }: OnionSkinInput, tolerance: number): string {
  return PHASE_COLOURS[phaseOf({ t, keys, range, periodic, tolerance }).kind];
}
