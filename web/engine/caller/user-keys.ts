/**
 * The user's keys of a motion with fitted shapes, which itself runs through the keys of a derived shape. Plots compare
 * it with the motion in LRI space through the user's keys.
 */
import { invalidOption } from '../api/errors.ts';
import { MOTION_DEFAULTS, type Frame, type KeySpacing, type ShapePlane } from '../api/types.ts';
import type { MotionSpec } from '../wire/protocol.ts';
import type { ShapeClient } from './shape.ts';

export class UserKeys {
  /** The worker makes it for the first plot. */
  private readonly plain: MotionSpec;

  /** `intervals`: whether the shapes between two keys were fitted. */
  constructor(
    readonly shape: ShapeClient,
    readonly spec: MotionSpec,
    readonly intervals: readonly boolean[],
  ) {
    this.plain = shape.spec(MOTION_DEFAULTS, spec.keyTimes);
  }

  async spacing(): Promise<KeySpacing> {
    return this.shape.query('keySpacing', () => ({ motion: this.plain }));
  }

  /** Bending energies relative to the deformation between the user's keys, as for other methods. */
  async relative(energies: number[], derived: KeySpacing): Promise<number[]> {
    const scale = meanSquare(derived.distance) / meanSquare((await this.spacing()).distance);
    return energies.map((energy) => (Number.isFinite(scale) ? scale * energy : energy));
  }

  /** The plane of the keys in LRI space. The motion leaves it, and its shapes have no weights. */
  async plane(times: readonly number[], frame: (t: number) => Promise<Frame>): Promise<ShapePlane> {
    const ask = (at: number[], shape: Float32Array | null): Promise<ShapePlane> =>
      this.shape.query('plane', () => ({ motion: this.plain, times: at, shape }));
    const plane = await ask([], null);
    for (const t of times) {
      const { positions, release } = await frame(t);
      const { curve, distance } = await ask([t], positions);
      release();
      plane.curve.push(...curve);
      plane.distance.push(...distance);
    }
    return plane;
  }

  refuseBlend(): never {
    throw invalidOption(
      "Fitted motions have no mixtures of keys. Choose a method other than 'lengths' and 'shell', and set keepLengths to 0.",
    );
  }

  end(derived: ShapeClient): void {
    this.shape.drop(this.plain);
    derived.dispose();
  }
}

function meanSquare(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value * value, 0) / values.length;
}
