/**
 * Rotation and stretch of every face relative to the reference pose, as amounts at the vertices. They are computed from
 * the drawn shape, by any method, so no frame is evaluated again. D_f = R_f S_f as in the core (lri/face_frame), by the
 * closed-form polar decomposition of a 3x2 matrix.
 */

import type { FaceAmount } from '../../model/state.ts';

export interface VertexAmounts {
  /** Amount at each vertex: the mean over its faces, weighted by their area in the reference pose. */
  values: Float32Array;
  /** Maximum over the vertices. */
  largest: number;
  /** Mean over the surface of the reference pose. */
  mean: number;
}

/**
 * Numbers stored per face of the reference pose: the frame t1, t2, n; and p, q, s of [p q; 0 s], the inverse of the
 * matrix of two edges in (t1, t2).
 */
const NUMBERS = 12;
/** Faces whose area over the square of their longest edge is below this have no frame. */
const DEGENERATE = 1e-12;
/** Lower bound on principal stretches. */
const MIN_STRETCH = 1e-3;

export class FaceHeat {
  private readonly frames: Float64Array;
  private readonly area: Float64Array;
  /** Sum of face areas at each vertex. */
  private readonly share: Float64Array;
  private readonly sums: Float64Array;

  /** `reference`: 3 x vertices; `faces`: 3 x faces. */
  constructor(
    reference: Float32Array,
    private readonly faces: Uint32Array,
  ) {
    const count = faces.length / 3;
    this.frames = new Float64Array(NUMBERS * count);
    this.area = new Float64Array(count);
    this.share = new Float64Array(reference.length / 3);
    this.sums = new Float64Array(reference.length / 3);
    for (let face = 0; face < count; face += 1) this.encode(reference, face);
  }

  /** `positions`: 3 x vertices; fills `values` if given. */
  amounts(
    positions: Float32Array,
    kind: FaceAmount,
    values: Float32Array = new Float32Array(positions.length / 3),
  ): VertexAmounts {
    const { faces, area, share, sums } = this;
    sums.fill(0);
    for (let face = 0; face < area.length; face += 1) {
      const weight = area[face]!;
      if (weight === 0) continue;
      const amount = weight * this.amountOf(positions, face, kind);
      sums[faces[3 * face]!]! += amount;
      sums[faces[3 * face + 1]!]! += amount;
      sums[faces[3 * face + 2]!]! += amount;
    }
    let [largest, total, surface] = [0, 0, 0];
    for (let v = 0; v < values.length; v += 1) {
      const value = share[v]! > 0 ? sums[v]! / share[v]! : 0;
      values[v] = value;
      if (value > largest) largest = value;
      total += sums[v]!;
      surface += share[v]!;
    }
    return { values, largest, mean: surface > 0 ? total / surface : 0 };
  }

  /**
   * The amount of one face. `rotation`: the angle of R_f in degrees. `stretch`: the principal stretch furthest from 1,
   * as the ratio of the longer to the shorter length minus 1, in percent. 0 for faces without area in the reference.
   */
  amountOf(positions: Float32Array, face: number, kind: FaceAmount): number {
    const { faces, frames } = this;
    if (this.area[face] === 0) return 0;
    const at = NUMBERS * face;
    const a = 3 * faces[3 * face]!;
    const b = 3 * faces[3 * face + 1]!;
    const c = 3 * faces[3 * face + 2]!;
    const x = positions[a]!;
    const y = positions[a + 1]!;
    const z = positions[a + 2]!;
    const ux = positions[b]! - x;
    const uy = positions[b + 1]! - y;
    const uz = positions[b + 2]! - z;
    const vx = positions[c]! - x;
    const vy = positions[c + 1]! - y;
    const vz = positions[c + 2]! - z;
    const p = frames[at + 9]!;
    const q = frames[at + 10]!;
    const s = frames[at + 11]!;
    // The columns of J = [u v] [p q; 0 s], which maps the reference's (t1, t2) to space.
    const jx = ux * p;
    const jy = uy * p;
    const jz = uz * p;
    const kx = ux * q + vx * s;
    const ky = uy * q + vy * s;
    const kz = uz * q + vz * s;
    const jj = jx * jx + jy * jy + jz * jz;
    const kk = kx * kx + ky * ky + kz * kz;
    const jk = jx * kx + jy * ky + jz * kz;
    const determinant = Math.sqrt(Math.max(jj * kk - jk * jk, 0));
    if (kind === 'stretch') {
      // Singular values: their sum and difference from |J|^2 and det.
      const sum = Math.sqrt(jj + kk + 2 * determinant);
      const difference = Math.sqrt(Math.max(jj + kk - 2 * determinant, 0));
      const least = Math.max((sum - difference) / 2, MIN_STRETCH);
      return 100 * (Math.max((sum + difference) / 2, 1 / least) - 1);
    }
    if (!(determinant > 0)) return 0;
    // S = (J^T J + det I) / trace; R's columns are those of J S^-1, and j x k over its length, which is det.
    const trace = Math.sqrt(jj + kk + 2 * determinant);
    const sa = (jj + determinant) / trace;
    const sb = jk / trace;
    const sd = (kk + determinant) / trace;
    const j1 = jx * frames[at]! + jy * frames[at + 1]! + jz * frames[at + 2]!;
    const j2 = jx * frames[at + 3]! + jy * frames[at + 4]! + jz * frames[at + 5]!;
    const k1 = kx * frames[at]! + ky * frames[at + 1]! + kz * frames[at + 2]!;
    const k2 = kx * frames[at + 3]! + ky * frames[at + 4]! + kz * frames[at + 5]!;
    const normal =
      (jy * kz - jz * ky) * frames[at + 6]! +
      (jz * kx - jx * kz) * frames[at + 7]! +
      (jx * ky - jy * kx) * frames[at + 8]!;
    const turned = (sd * j1 - sb * (k1 + j2) + sa * k2 + normal) / determinant;
    return (180 / Math.PI) * Math.acos(Math.min(Math.max((turned - 1) / 2, -1), 1));
  }

  private encode(reference: Float32Array, face: number): void {
    const corner = (which: number): [number, number, number] => {
      const at = 3 * this.faces[3 * face + which]!;
      return [reference[at]!, reference[at + 1]!, reference[at + 2]!];
    };
    const [a, b, c] = [corner(0), corner(1), corner(2)];
    const u = minus(b, a);
    const v = minus(c, a);
    const normal = cross(u, v);
    const twice = Math.hypot(...normal);
    const longest = Math.max(dot(u, u), dot(v, v));
    if (!(twice > DEGENERATE * longest)) return;
    const n = scaled(normal, 1 / twice);
    const length = Math.hypot(...u);
    const t1 = scaled(u, 1 / length);
    const t2 = cross(n, t1);
    // Edges in (t1, t2) are [length x; 0 y], with this inverse.
    const [x, y] = [dot(v, t1), dot(v, t2)];
    this.frames.set([...t1, ...t2, ...n, 1 / length, -x / (length * y), 1 / y], NUMBERS * face);
    this.area[face] = twice / 2;
    for (let which = 0; which < 3; which += 1) this.share[this.faces[3 * face + which]!]! += twice / 2;
  }
}

type Vector = readonly [number, number, number];

function minus(a: Vector, b: Vector): [number, number, number] {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function cross(a: Vector, b: Vector): [number, number, number] {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function scaled(a: Vector, factor: number): [number, number, number] {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}
