/** Maps numbers to plot positions, and chooses round numbers for axes. */

export interface Scale {
  (value: number): number;
  readonly domain: readonly [number, number];
}

export function linearScale(domain: readonly [number, number], from: number, to: number): Scale {
  const [low, high] = domain;
  const factor = high === low ? 0 : (to - from) / (high - low);
  const middle = (from + to) / 2;
  return Object.assign((value: number) => (factor === 0 ? middle : from + (value - low) * factor), { domain });
}

/** Logarithmic. Values below the domain, such as 0, map to its lower edge. */
export function logScale(domain: readonly [number, number], from: number, to: number): Scale {
  const [low, high] = domain;
  const place = linearScale([Math.log10(low), Math.log10(high)], from, to);
  return Object.assign((value: number) => place(Math.log10(Math.max(value, low))), { domain });
}

/** On a linear axis, a curve below this share of the highest one looks flat. */
const FLAT = 1 / 30;
/** Values below this share of the highest one are rounding errors. */
const ROUNDING = 1e-9;
/** Number of decades shown below the peak of the lowest curve. */
const BELOW = 2;

/** Lower end of a logarithmic axis; null if every curve is visible on a linear one. */
export function logFloor(curves: readonly (readonly number[])[]): number | null {
  const peaks = curves.map((values) => Math.max(...values.filter(Number.isFinite)));
  const highest = Math.max(...peaks);
  const lowest = Math.min(...peaks.filter((peak) => peak > ROUNDING * highest));
  return lowest < FLAT * highest ? 10 ** (Math.floor(Math.log10(lowest)) - BELOW) : null;
}

/** At most `count` + 1 powers of ten inside the interval, starting with the lowest. */
export function decades([low, high]: readonly [number, number], count: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const step = Math.max(Math.ceil((last - first) / count), 1);
  return Array.from({ length: Math.floor((last - first) / step) + 1 }, (_, i) =>
    Number((10 ** (first + i * step)).toPrecision(12)),
  );
}

/** Lowest and highest finite value; [0, 1] if there are none. */
export function extent(values: Iterable<number>): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low <= high ? [low, high] : [0, 1];
}

/** The interval widened by a share of its length; a single point gets a default width. */
export function padded([low, high]: readonly [number, number], share: number, least = 0): [number, number] {
  const pad = Math.max((high - low) * share, least, Math.abs(high) * 1e-9, 1e-12);
  return [low - pad, high + pad];
}

/** About `count` round numbers inside the interval. */
export function ticks([low, high]: readonly [number, number], count: number): number[] {
  const step = niceStep((high - low) / Math.max(count, 1));
  if (!(step > 0)) return [];
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.min(last - first + 1, 50) }, (_, index) =>
    Number(((first + index) * step).toPrecision(12)),
  );
}

function niceStep(rough: number): number {
  if (!(rough > 0) || !Number.isFinite(rough)) return 0;
  const power = 10 ** Math.floor(Math.log10(rough));
  const digit = rough / power;
  return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

/** Indices of ascending positions at least `least` apart: the first, and each next one that fits. */
export function apart(places: readonly number[], least: number): number[] {
  let last = -Infinity;
  return [...places.keys()].filter((index) => {
    const fits = places[index]! - last >= least;
    if (fits) last = places[index]!;
    return fits;
  });
}

export function tickLabel(value: number): string {
  if (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3)) return written(value.toExponential(0));
  return written(String(Number(value.toPrecision(4))));
}

/** A number in JavaScript's notation, with proper minus sign and powers of ten. */
export function written(number: string): string {
  const [digits, power] = number.replace(/^-/, '−').split(/e\+?/);
  if (power === undefined) return digits!;
  const raised = power.replace('-', '⁻').replace(/\d/g, (digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]!);
  return `${digits === '1' ? '' : digits === '−1' ? '−' : `${digits}·`}10${raised}`;
}

/** SVG path of a polyline with gaps at values that are not finite. */
export function path(points: readonly (readonly [number, number])[]): string {
  let pen = 'M';
  return points
    .map(([x, y]) => {
      if (!Number.isFinite(x) || !Number.isFinite(y)) {
        pen = 'M';
        return '';
      }
      const part = `${pen}${x.toFixed(2)} ${y.toFixed(2)}`;
      pen = 'L';
      return part;
    })
    .join('');
}
