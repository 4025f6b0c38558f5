/** Pins of the document, where `stay` is a pose. Each edit returns the next list, or the same one. */
import { PIN_RADIUS, MOTION } from '../engine/api/option-table.ts';
import { validationError } from '../engine/api/options.ts';
import type { PathKey, Pin } from '../engine/api/types.ts';

export type Pins = readonly Pin[];
type Point = PathKey['move'];

/** Offered sizes of a pin. */
export const PIN_SIZES = [
  { radius: 0, label: 'Patch' },
  { radius: PIN_RADIUS / 2, label: 'Small' },
  { radius: PIN_RADIUS, label: 'Medium' },
  { radius: 2 * PIN_RADIUS, label: 'Large' },
] as const;

/** The closest offered size. */
export function pinSize({ radius }: Pin): number {
  const distance = (other: number): number => (radius === 0 || other === 0 ? Number(radius !== other) : 0);
  const off = (other: number): number => distance(other) + Math.abs(radius - other);
  return PIN_SIZES.map((size) => size.radius).reduce((best, other) => (off(other) < off(best) ? other : best));
}

export function withPin(pins: Pins, vertex: number): Pin[] {
  return [...pins, { vertex, radius: PIN_RADIUS }];
}

export function withoutPin(pins: Pins, index: number): Pin[] {
  return pins.filter((_, other) => other !== index);
}

/** `undefined` removes a field of the pin. */
export function changedPin(pins: Pins, index: number, change: { [N in keyof Pin]?: Pin[N] | undefined }): Pin[] {
  const known = (pin: object): Pin =>
    Object.fromEntries(Object.entries(pin).filter(([, value]) => value !== undefined)) as unknown as Pin;
  return pins.map((pin, at) => (at === index ? known({ ...pin, ...change }) : pin));
}

/** Sets a key of the pin's path at t, replacing a key at nearly the same time. */
export function withPathKey(path: readonly PathKey[], key: PathKey, sameTime: number): PathKey[] {
  const others = path.filter(({ time }) => Math.abs(time - key.time) > sameTime);
  return [...others, key].sort((a, b) => a.time - b.time);
}

/**
 * Offset of the path at t, as in the core (pin_path): a natural cubic spline that is constant at and beyond its ends,
 * or a periodic one.
 */
export function moveAt(path: readonly PathKey[], t: number, period: number | null): Point {
  const [first] = path;
  if (!first) return [0, 0, 0];
  if (path.length === 1) return first.move;
  const keys = period === null ? path : unrolled(path, period);
  const at = period === null ? t : t - Math.floor((t - first.time) / period) * period;
  return [0, 1, 2].map((axis) => splineAt(keys, axis, at, period === null)) as Point;
}

/** Number of periods on either side after which the natural ends have no visible effect. */
const PERIODS = 12;

function unrolled(path: readonly PathKey[], period: number): PathKey[] {
  return Array.from({ length: 2 * PERIODS + 1 }, (_, k) => (k - PERIODS) * period).flatMap((later) =>
    path.map(({ time, move }) => ({ time: time + later, move })),
  );
}

/** Quintic between knots with the spline's velocity and acceleration, both zero at the constant ends. */
function splineAt(keys: readonly PathKey[], axis: number, t: number, stands: boolean): number {
  const x = keys.map(({ time }) => time);
  const y = keys.map(({ move }) => move[axis]!);
  const last = x.length - 1;
  if (t <= x[0]!) return y[0]!;
  if (t >= x[last]!) return y[last]!;
  const bend = secondDerivatives(x, y);
  const span = Math.max(x.findIndex((time) => time > t) - 1, 0);
  const h = x[span + 1]! - x[span]!;
  const step = (y[span + 1]! - y[span]!) / h;
  const ends = [0, 1].map((end) => {
    const knot = span + end;
    if (stands && (knot === 0 || knot === last)) return { velocity: 0, acceleration: 0 };
    const [own, other] = [bend[knot]!, bend[span + 1 - end]!];
    return { velocity: step + ((end === 0 ? -1 : 1) * h * (2 * own + other)) / 6, acceleration: own };
  });
  const [from, to] = ends as [(typeof ends)[0], (typeof ends)[0]];
  const u = (t - x[span]!) / h;
  const [v0, v1] = [h * from.velocity, h * to.velocity];
  const [a0, a1] = [h * h * from.acceleration, h * h * to.acceleration];
  const rise = y[span + 1]! - y[span]!;
  const c3 = 10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
  const c4 = -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
  const c5 = 6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1;
  return y[span]! + u * (v0 + u * (a0 / 2 + u * (c3 + u * (c4 + u * c5))));
}

/** Second derivatives of the natural cubic spline at its knots. */
function secondDerivatives(x: readonly number[], y: readonly number[]): number[] {
  const last = x.length - 1;
  const bend = new Array<number>(last + 1).fill(0);
  const upper = new Array<number>(last + 1).fill(0);
  for (let i = 1; i < last; i++) {
    const [before, after] = [x[i]! - x[i - 1]!, x[i + 1]! - x[i]!];
    const right = 6 * ((y[i + 1]! - y[i]!) / after - (y[i]! - y[i - 1]!) / before);
    const diagonal = 2 * (before + after) - before * upper[i - 1]!;
    upper[i] = after / diagonal;
    bend[i] = (right - before * bend[i - 1]!) / diagonal;
  }
  for (let i = last - 1; i > 0; i--) bend[i]! -= upper[i]! * bend[i + 1]!;
  return bend;
}

/** Link format: VERTEX:RADIUS[:POSE][:T/X/Y/Z,...], separated by semicolons. */
export function pinsText(pins: Pins, shortest: (value: number) => string): string {
  const keyText = ({ time, move }: PathKey): string => [time, ...move].map(shortest).join('/');
  return pins
    .map(({ vertex, radius, stay, path }) =>
      [vertex, shortest(radius), stay ?? '', ...(path ? [path.map(keyText).join(',')] : [])].join(':'),
    )
    .join(';');
}

/** Parses the pins of a link; undefined if invalid. */
export function pinsFromText(text: string): Pin[] | undefined {
  const pins = text.split(';').map((part): Pin => {
    const [vertex, radius, stay = '', path] = part.split(':');
    const pin: Pin = { vertex: Number(vertex || NaN), radius: Number(radius || NaN) };
    if (stay !== '') pin.stay = Number(stay);
    if (path) pin.path = path.split(',').map(pathKeyFrom);
    return pin;
  });
  return validationError(MOTION.pins, pins) === null ? pins : undefined;
}

function pathKeyFrom(text: string): PathKey {
  const [time = NaN, x = NaN, y = NaN, z = NaN] = text.split('/').map(Number);
  return { time, move: [x, y, z] };
}
