/** Point caches: the vertices of every frame, for programs that animate a mesh with them (Mesh Cache in Blender). */
import { EngineError } from '../api/errors.ts';

const MAX_BYTES = 2 ** 31 - 1;
const PC2_HEADER = 32;

/**
 * PC2 (little-endian): "POINTCACHE2", version 1, points, first frame, frames per sample, samples, then all positions.
 * MDD (big-endian): samples, points, time of each sample in seconds, then all positions.
 */
export class PointCache {
  readonly bytes: Uint8Array;
  private readonly view: DataView;
  private readonly littleEndian: boolean;
  private next: number;

  constructor(format: 'pc2' | 'mdd', { seconds }: { seconds: readonly number[] }, points: number) {
    const samples = seconds.length;
    const header = format === 'pc2' ? PC2_HEADER : 8 + 4 * samples;
    const length = header + 12 * points * samples;
    if (length > MAX_BYTES)
      throw new EngineError(
        'too-large',
        `The point cache would be ${(length / 1e9).toFixed(1)} GB, but it can have at most 2.1 GB. Export fewer frames.`,
      );
    this.bytes = new Uint8Array(length);
    this.view = new DataView(this.bytes.buffer);
    this.littleEndian = format === 'pc2';
    this.next = header;
    if (format === 'pc2') {
      this.bytes.set(new TextEncoder().encode('POINTCACHE2\0'));
      this.view.setInt32(12, 1, true);
      this.view.setInt32(16, points, true);
      this.view.setFloat32(20, 0, true);
      this.view.setFloat32(24, 1, true);
      this.view.setInt32(28, samples, true);
    } else {
      this.view.setInt32(0, samples);
      this.view.setInt32(4, points);
      seconds.forEach((second, index) => this.view.setFloat32(8 + 4 * index, second));
    }
  }

  add(positions: Float32Array): void {
    const broken = positions.findIndex((value) => !Number.isFinite(value));
    if (broken >= 0)
      throw new EngineError(
        'not-finite',
        `Vertex ${Math.floor(broken / 3)} of a frame is not finite. Choose a range closer to the keys.`,
        { vertex: Math.floor(broken / 3) },
      );
    for (const value of positions) {
      this.view.setFloat32(this.next, value, this.littleEndian);
      this.next += 4;
    }
  }
}
