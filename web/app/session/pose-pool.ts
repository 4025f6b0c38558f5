/** The poses of an import and those taken from shapes since; an index into it never changes its meaning. */
import type { Keys } from '../../engine/api/api.ts';

export class PosePool {
  count: number;
  /** How many of them are the import's own. */
  readonly imported: number;

  constructor(public keys: Keys) {
    this.imported = keys.info.times.length;
    this.count = this.imported;
  }

  /** The first poses, one after the other: each is a copy. */
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
