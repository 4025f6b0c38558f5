/** A piecewise cubic through knots with given values and slopes; piecewise linear without slopes. */

export interface Curve {
  /** Strictly increasing. For a closed curve: one period, whose last value equals the first. */
  times: readonly number[];
  values: readonly number[];
  /** One slope per knot; null: straight between knots. */
  slopes: readonly number[] | null;
  closed: boolean;
}

export type Derivative = 0 | 1 | 2;

/** The value or a derivative at t. At a knot, uses the interval after it. Beyond the ends, the curve is straight. */
export function valueAt(curve: Curve, t: number, derivative: Derivative = 0): number {
  const { times, closed } = curve;
  const last = times.length - 1;
  const [start, end] = [times[0]!, times[last]!];
  if (closed) {
    const inside = t - Math.floor((t - start) / (end - start)) * (end - start);
    return inInterval(curve, intervalAt(times, inside), inside, derivative);
  }
  if (curve.slopes && (t < start || t > end)) return beyond(curve, t < start ? 0 : last, t, derivative);
  return inInterval(curve, intervalAt(times, t), t, derivative);
}

/** The interval that contains t; a knot belongs to the interval after it, or to the last one. */
export function intervalAt(times: readonly number[], t: number): number {
  let index = 0;
  while (index < times.length - 2 && t >= times[index + 1]!) index += 1;
  return index;
}

/** Evaluates the cubic of a given interval, for values on both sides of a knot. */
export function inInterval(curve: Curve, index: number, t: number, derivative: Derivative): number {
  const { times, values, slopes } = curve;
  const h = times[index + 1]! - times[index]!;
  const u = (t - times[index]!) / h;
  const [a, b] = [values[index]!, values[index + 1]!];
  if (!slopes) return derivative === 0 ? (1 - u) * a + u * b : derivative === 1 ? (b - a) / h : 0;
  const [p, q] = [slopes[index]!, slopes[index + 1]!];
  // The cubic Hermite basis and its derivatives.
  if (derivative === 0) {
    const w = 1 - u;
    return w * w * (1 + 2 * u) * a + u * u * (3 - 2 * u) * b + h * u * w * w * p - h * u * u * w * q;
  }
  if (derivative === 1) return ((6 * u * (1 - u)) / h) * (b - a) + (1 - u) * (1 - 3 * u) * p + u * (3 * u - 2) * q;
  return ((6 - 12 * u) / (h * h)) * (b - a) + ((6 * u - 4) / h) * p + ((6 * u - 2) / h) * q;
}

/** Linear extrapolation (paper section 3.2): f(t) = f(t_e) + f'(t_e) (t - t_e). */
function beyond({ times, values, slopes }: Curve, end: number, t: number, derivative: Derivative): number {
  const slope = slopes![end]!;
  if (derivative === 0) return values[end]! + slope * (t - times[end]!);
  return derivative === 1 ? slope : 0;
}

/**
 * Total bending: the integral of the squared second derivative (paper Eq. 1) over the first `intervals` intervals, by
 * default all. Corners have infinite bending.
 */
export function totalBending(curve: Curve, intervals = curve.times.length - 1): number {
  let sum = 0;
  for (let i = 0; i < intervals; i += 1) {
    const [from, to] = [curve.times[i]!, curve.times[i + 1]!];
    const [a, b] = [inInterval(curve, i, from, 2), inInterval(curve, i, to, 2)];
    sum += ((to - from) * (a * a + a * b + b * b)) / 3;
    if (curve.slopes || i === 0) continue;
    const [before, after] = [inInterval(curve, i - 1, from, 1), inInterval(curve, i, from, 1)];
    if (Math.abs(after - before) > 1e-9 * (Math.abs(after) + Math.abs(before))) return Infinity;
  }
  return sum;
}
