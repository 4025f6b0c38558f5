/** Names and descriptions of the curves. */
import { written } from '../../plots/scale.ts';
import type { Ends } from '../splines/slopes.ts';
import type { Layer } from '../state.ts';

export const LAYER_WORDS: Record<Layer, { name: string; what: string }> = {
  linear: { name: 'Straight lines', what: 'Linear: the shortest path, with a corner at every key' },
  natural: { name: 'Natural cubic', what: 'Free ends, as in Blender with handle smoothing “Continuous Acceleration”' },
  samples: {
    name: 'Brute force',
    what: 'K samples that bend least with fixed keys, and the smoothest curve through all of them',
  },
  'catmull-rom': {
    name: 'Catmull-Rom',
    what: 'The slope at a key depends only on its two neighbours, as in Blender with handle smoothing “None”',
  },
  hermite: { name: 'Given speeds', what: 'Hermite ends: drag the handles; 0 eases in and out' },
  periodic: { name: 'Loop', what: 'Periodic: the last key is followed by the first' },
  shaped: { name: 'Tension and bias', what: 'Set for each key, after Kochanek and Bartels' },
};

export const ENDS_WORDS: Record<Ends, string> = { natural: 'Free', hermite: 'Given speeds', periodic: 'Loop' };

/** Three significant digits, a proper minus sign, powers of ten for large numbers, and a dash for missing values. */
export function number(value: number): string {
  if (Number.isNaN(value)) return '–';
  if (value === Infinity) return '∞';
  const rounded = Math.abs(value) < 5e-4 ? 0 : Number(value.toPrecision(3));
  return written(Math.abs(rounded) < 1e6 ? String(rounded) : rounded.toExponential());
}
