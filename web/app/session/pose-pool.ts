/** The poses of an import, and poses added from shapes. Indices into the pool never change. */
import type { Keys } from '../../engine/api/api.ts';

export class PosePool {
  count: number;
  /** Number of imported poses. */
  readonly imported: number;

  constructor(public keys: Keys) {
    this.imported = keys.info.times.length;
    this.count = this.imported;
  }

  /** The first poses, one at a time, because each is a copy. */
  *poses(count = this.count): Generator<Float32Array> {
    for (let pose = 0; pose < count; pose += 1) yield this.keys.positions(pose);
  }

  /** Returns the new pose's index. */
  add(name: string, positions: Float32Array): number {
    const last = this.keys.info.times.at(-1) ?? 0;
    const before = this.keys;
    this.keys = before.withPose(name, last + 1, positions);
    before.dispose();
    this.count += 1;
    return this.count - 1;
  }
}
