/** Onion skins: their times and colours. */
import { describe, expect, it } from 'vitest';
import type { Frame } from '../../web/engine/api/types.ts';
import { onionExtras, onionTimes } from '../../web/app/drawing/onion-skin.ts';
import { ONION_COLOURS } from '../../web/model/state.ts';

const input = { t: 1, keys: [], range: [0, 2], periodic: false } as const;
const frameAt = (t: number): Frame => ({ t, positions: new Float32Array(3), normals: new Float32Array(3) }) as Frame;

describe('onion skins', () => {
  it('are equally many before and after, evenly spaced, the farthest first', () => {
    expect(onionTimes(input, { onionSkins: 2, onionSpacing: 0.25 })).toEqual([0.5, 1.5, 0.75, 1.25]);
    expect(onionTimes(input, { onionSkins: 1, onionSpacing: null })).toEqual([1 - 0.18, 1 + 0.18]);
  });

  it('have different colours before and after, and fade with the distance', () => {
    const skins = onionExtras(input, onionTimes(input, { onionSkins: 3, onionSpacing: 0.1 }).map(frameAt));
    const { before, after } = ONION_COLOURS;
    expect(skins.map(({ colour }) => colour)).toEqual([before, after, before, after, before, after]);
    const opacities = skins.filter((_, i) => i % 2 === 0).map(({ opacity }) => opacity);
    expect(opacities).toEqual([...opacities].sort((a, b) => a - b));
    expect(new Set(opacities).size).toBe(3);
  });
});
