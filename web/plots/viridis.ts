/**
 * The colour map for amounts: viridis, which is perceptually uniform and readable for colour-blind users. Interpolates
 * ten of its colours.
 */

const STOPS: readonly (readonly [number, number, number])[] = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 73, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [109, 205, 89],
  [180, 222, 44],
  [253, 231, 37],
];

/** sRGB in [0, 255] at a share in [0, 1]; values beyond are clamped. */
export function viridis(share: number): [number, number, number] {
  const place = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const below = Math.min(Math.floor(place), STOPS.length - 2);
  const mix = (channel: 0 | 1 | 2): number => {
    const [from, to] = [STOPS[below]![channel], STOPS[below + 1]![channel]];
    return from + (to - from) * (place - below);
  };
  return [mix(0), mix(1), mix(2)];
}

/** The colour map as a CSS gradient, lowest value first. */
export function viridisGradient(direction: string): string {
  return `linear-gradient(${direction}, ${STOPS.map((stop) => `rgb(${stop.join(' ')})`).join(', ')})`;
}
