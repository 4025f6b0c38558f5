/** The numbers of regions with timings of their own follow their keys. */
import type { TimingRegion } from '../engine/api/types.ts';

type Regions = readonly TimingRegion[];

/** The region of each face; -1 for faces in none. A face in several regions belongs to the first. */
export function regionOfFaces(regions: Regions, faces: number): Int32Array {
  const regionOf = new Int32Array(faces).fill(-1);
  for (const [region, { faces: runs }] of [...regions.entries()].reverse())
    for (let i = 0; i + 1 < runs.length; i += 2) regionOf.fill(region, runs[i], runs[i]! + runs[i + 1]!);
  return regionOf;
}

function mapped(regions: Regions, change: (values: number[], name: 'earlier' | 'swing') => number[]): TimingRegion[] {
  const listOf = (region: TimingRegion, name: 'earlier' | 'swing'): number[] =>
    region[name].length > 0 ? change(region[name], name) : [];
  return regions.map((one) => ({ ...one, earlier: listOf(one, 'earlier'), swing: listOf(one, 'swing') }));
}

/** `from`: the former number of each key, or null for a new key, beside which the intervals have the default motion. */
export function regionsOfKeys(regions: Regions, from: readonly (number | null)[]): TimingRegion[] {
  const isNew = (key: number): boolean => from[key % from.length] === null;
  return mapped(regions, (values) => from.map((old, key) => (isNew(key) || isNew(key + 1) ? 0 : values[old!]!)));
}

/** For the reversed motion: each key takes the timing of the previous one, reversed. */
export function reversedRegions(regions: Regions): TimingRegion[] {
  return mapped(regions, (values, name) => {
    const sign = name === 'earlier' ? -1 : 1;
    return values.map((_, key) => sign * values.at(key - 1)! + 0).reverse();
  });
}
