/**
 * Samples made in the browser: closed, painted, with the specified size, and with constant volume unless they shrink.
 */
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { measure } from '../../web/app/drawing/measures.ts';
import { column } from '../../web/sculpt/column.ts';
import type { Sculpture } from '../../web/sculpt/glb.ts';
import { make } from '../../web/sculpt/make.ts';
import { serpent } from '../../web/sculpt/serpent.ts';
import { turret } from '../../web/sculpt/turret.ts';

/** Traversals of each edge in one direction minus those in the other, with coincident vertices merged. */
function openEdges({ skin, keys }: Sculpture): number {
  const first = new Map<string, number>();
  const welded = Array.from({ length: keys[0]!.length / 3 }, (_, v) => {
    const place = keys[0]!.subarray(3 * v, 3 * v + 3).join();
    if (!first.has(place)) first.set(place, v);
    return first.get(place)!;
  });
  const runs = new Map<string, number>();
  for (let i = 0; i < skin.faces.length; i += 3) {
    for (let c = 0; c < 3; c += 1) {
      const [a, b] = [welded[skin.faces[i + c]!]!, welded[skin.faces[i + ((c + 1) % 3)]!]!];
      const edge = `${Math.min(a, b)} ${Math.max(a, b)}`;
      runs.set(edge, (runs.get(edge) ?? 0) + (a < b ? 1 : -1));
    }
  }
  return [...runs.values()].filter((sum) => sum !== 0).length;
}

describe.each([
  ['column', column],
  ['serpent', serpent],
  ['turret', turret],
] as const)('the %s', (name, sculptor) => {
  it('is closed, with faces oriented outwards', async () => {
    const made = await sculptor(0.3);
    expect(openEdges(made)).toBe(0);
    for (const key of made.keys) expect(measure(key, made.skin.faces).volume).toBeGreaterThan(0);
  });

  it.runIf(name !== 'turret')('has the same volume in every pose', async () => {
    const { skin, keys } = await sculptor(0.6);
    const [first, ...others] = keys.map((key) => measure(key, skin.faces).volume);
    for (const volume of others) expect(volume / first!).toBeCloseTo(1, 1.4);
  });

  it('is painted in several colours', async () => {
    const { data } = PNG.sync.read(Buffer.from((await sculptor(0.2)).picture));
    const colours = new Set(Array.from({ length: data.length / 4 }, (_, i) => data.subarray(4 * i, 4 * i + 3).join()));
    expect(colours.size).toBeGreaterThan(3);
  });

  it('is a GLB of the stated length', async () => {
    const { bytes } = await make(name, 0.2);
    const view = new DataView(bytes.buffer);
    expect([view.getUint32(0, true), view.getUint32(8, true)]).toEqual([0x46546c67, bytes.length]);
  });
});

it('the upper part of the turret is a fifth as high and as wide in its last pose', async () => {
  const { keys } = await turret(1);
  const pose = (key: Float32Array) => {
    const heights = key.filter((_, i) => i % 3 === 1);
    const high = Math.max(...heights);
    const places = [...Array(key.length / 3).keys()].filter((v) => v % 80 === 0);
    return { high, width: (v: number) => Math.hypot(key[3 * v]!, key[3 * v + 2]!), places };
  };
  const [first, last] = [pose(keys[0]!), pose(keys[2]!)];
  const heightOf = (v: number): number => keys[0]![3 * v + 1]!;
  const above = first.places.filter((v) => heightOf(v) > 2.3 && heightOf(v) < first.high - 0.2);
  expect(above.length).toBeGreaterThan(5);
  for (const v of above) {
    expect(last.width(v) / first.width(v)).toBeCloseTo(0.2, 4);
    expect((last.high - keys[2]![3 * v + 1]!) / (first.high - heightOf(v))).toBeCloseTo(0.2, 3);
  }
});

it('the serpent has more than 300,000 faces', async () => {
  expect((await serpent(1)).skin.faces.length / 3).toBeGreaterThan(300_000);
});
