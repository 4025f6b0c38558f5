/** The open content with all edits, enough to restore it exactly. */
import type { Pose } from '../../engine/api/read-poses.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { History, Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { StoredProject } from './project-shelf.ts';

export interface Snapshot extends StoredProject {
  history: History;
}

/** A snapshot of the open content; null if nothing is open, or if state and files do not belong together. */
export function currentSnapshot(store: Store, workspace: Workspace): Snapshot | null {
  const { options, pool, input, aheadOfState } = workspace;
  if (!pool || aheadOfState) return null;
  const { offset } = pool.keys.info;
  return { files: input, options, poses: addedPoses(pool), offset, state: store.get(), history: store.history() };
}

/** Copies of the poses that are not from the files. They never change, so each is copied once. */
const copies = new WeakMap<PosePool, readonly Pose[]>();

function addedPoses(pool: PosePool): Pose[] {
  const poses = [...(copies.get(pool) ?? [])];
  for (let pose = pool.imported + poses.length; pose < pool.count; pose += 1)
    poses.push({ name: pool.keys.info.names[pose] ?? '', positions: pool.keys.positions(pose) });
  copies.set(pool, poses);
  return poses;
}

export function bytesOf({ files, poses }: StoredProject): number {
  const sum = (sizes: number[]): number => sizes.reduce((total, size) => total + size, 0);
  return sum(files.map(({ bytes }) => bytes.byteLength)) + sum(poses.map(({ positions }) => positions.byteLength));
}
