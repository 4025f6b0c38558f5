/** Tests whether a motion ends in its first pose, so it can loop. */
import { farthest } from '../../engine/api/distances.ts';
import type { Doc } from '../../model/state.ts';
import type { PosePool } from '../session/pose-pool.ts';

/** Share of the diagonal. Equal poses can differ by this much through rounding in files or manual placement. */
const SAME = 0.01;

/** The last pose equals the first up to its position. Two keys make no loop. */
export function isClosed({ keys }: Doc, { keys: poses }: PosePool): boolean {
  const [first, last] = [keys[0], keys.at(-1)];
  if (!first || !last || keys.length < 3) return false;
  const [a, b] = [poses.positions(first.pose), poses.positions(last.pose)];
  const [from, to] = [centreOf(a), centreOf(b)];
  const reach = SAME * poses.info.report.diagonal;
  const moved = [0, 1, 2].map((axis) => to[axis]! - from[axis]!);
  for (let i = 0; i < a.length; i += 1) b[i]! -= moved[i % 3]!;
  return farthest(a, b, b, 0) <= reach;
}

function centreOf(positions: Float32Array): number[] {
  const sum = [0, 0, 0];
  for (let i = 0; i < positions.length; i += 1) sum[i % 3]! += positions[i]!;
  return sum.map((value) => (3 * value) / positions.length);
}
