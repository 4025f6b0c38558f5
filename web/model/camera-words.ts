/** A camera in the text form of <model-viewer>: `camera-orbit="30deg 75deg 105%"`, `camera-target="0m 1m 0m"`. */

import type { CameraPose } from './camera.ts';

/** Angles in radians: azimuth from the front, and polar angle from the up axis. */
export interface CameraOrbit {
  theta: number;
  phi: number;
  /** Relative to the distance that shows the whole shape, or in the shape's unit. */
  radius: { share: number } | { distance: number };
}

export const AUTO_ORBIT: Readonly<CameraOrbit> = { theta: 0, phi: (75 * Math.PI) / 180, radius: { share: 1 } };

const ANGLES: Readonly<Record<string, number>> = { rad: 1, deg: Math.PI / 180, turn: 2 * Math.PI };
const LENGTHS: Readonly<Record<string, number>> = { m: 1, cm: 0.01, mm: 0.001 };
/** Least polar angle. At 0 the eye would look straight down, without an up direction. */
const MIN_PHI = 0.01;

/** Parses an orbit, in which each value may be `auto`; null if invalid. */
export function orbitOf(words: string): CameraOrbit | null {
  const [theta, phi, radius, ...more] = wordsOf(words);
  if (theta === undefined || phi === undefined || radius === undefined || more.length > 0) return null;
  const angles = [theta, phi].map((word, i) =>
    word === 'auto' ? [AUTO_ORBIT.theta, AUTO_ORBIT.phi][i]! : measured(word, ANGLES),
  );
  const distance = radius === 'auto' ? AUTO_ORBIT.radius : radiusOf(radius);
  if (angles.some(Number.isNaN) || !distance) return null;
  const tilt = Math.min(Math.max(angles[1]!, MIN_PHI), Math.PI - MIN_PHI);
  return { theta: angles[0]!, phi: tilt, radius: distance };
}

/** The point that the camera looks at; NaN for the middle of the shape, null if invalid. */
export function targetOf(words: string): [number, number, number] | null {
  const parts = wordsOf(words);
  if (parts.length === 1 && parts[0] === 'auto') return [NaN, NaN, NaN];
  if (parts.length !== 3) return null;
  const place = parts.map((word) => (word === 'auto' ? null : measured(word, LENGTHS)));
  if (place.some(Number.isNaN)) return null;
  return place.map((at) => at ?? NaN) as [number, number, number];
}

/** Unit vector from the target to the eye. */
export function directionOfOrbit({ theta, phi }: CameraOrbit): [number, number, number] {
  return [Math.sin(phi) * Math.sin(theta), Math.cos(phi), Math.sin(phi) * Math.cos(theta)];
}

/** The inverse: text of a camera's direction, at the distance that shows the whole shape. */
export function orbitWords({ position, target }: CameraPose): string {
  const [x, y, z] = position.map((at, i) => at - target[i]!) as [number, number, number];
  const degrees = (angle: number): string => `${Math.round((angle * 180) / Math.PI)}deg`;
  return `${degrees(Math.atan2(x, z))} ${degrees(Math.atan2(Math.hypot(x, z), y))} auto`;
}

const wordsOf = (text: string): string[] => text.trim().toLowerCase().split(/\s+/).filter(Boolean);

function radiusOf(word: string): CameraOrbit['radius'] | null {
  const share = /^(\d*\.?\d+)%$/.exec(word);
  if (share) return Number(share[1]) > 0 ? { share: Number(share[1]) / 100 } : null;
  const distance = measured(word, LENGTHS);
  return distance > 0 ? { distance } : null;
}

/** Parses a number with a unit; NaN if invalid. */
function measured(word: string, units: Readonly<Record<string, number>>): number {
  const [, number, unit] = /^([-+]?\d*\.?\d+(?:e[-+]?\d+)?)([a-z]+)$/.exec(word) ?? [];
  const scale = units[unit ?? ''];
  return number === undefined || scale === undefined ? NaN : Number(number) * scale;
}
