/** Error of a motion relative to another at the same times: vertex distances and the KG error. */
import { KgError } from '../engine/timing/kg-error.ts';

export interface ErrorsOverTime {
  /** Largest distance per time, in percent of the diagonal; NaN without a reference. */
  largest: number[];
  mean: number[];
}

export class MotionError {
  readonly over: ErrorsOverTime = { largest: [], mean: [] };
  private readonly kg = new KgError();

  /** `diagonal`: the reference length of distances. */
  constructor(private readonly diagonal: number) {}

  /** Adds the next time, 3 x vertices of both; null without a reference. */
  add(reference: Float32Array | null, positions: Float32Array): void {
    if (!reference) {
      this.over.largest.push(NaN);
      this.over.mean.push(NaN);
      return;
    }
    let [largest, sum] = [0, 0];
    for (let i = 0; i < positions.length; i += 3) {
      const distance = Math.hypot(
        positions[i]! - reference[i]!,
        positions[i + 1]! - reference[i + 1]!,
        positions[i + 2]! - reference[i + 2]!,
      );
      largest = Math.max(largest, distance);
      sum += distance;
    }
    this.over.largest.push((100 * largest) / this.diagonal);
    this.over.mean.push((100 * sum) / (positions.length / 3) / this.diagonal);
    this.kg.add(reference, positions);
  }

  /** KG error of all compared times, in percent. */
  get percent(): number {
    return this.kg.percent;
  }

  get largest(): number {
    return this.over.largest.reduce((most, value) => (value > most ? value : most), 0);
  }

  get mean(): number {
    const compared = this.over.mean.filter((value) => !Number.isNaN(value));
    return compared.reduce((sum, value) => sum + value, 0) / Math.max(compared.length, 1);
  }
}
