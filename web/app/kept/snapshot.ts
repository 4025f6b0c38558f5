/** The open content with all edits, enough to restore it exactly. */
import type { History, Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { StoredProject } from './project-shelf.ts';

export interface Snapshot extends StoredProject {
  history: History;
}

/** A snapshot of the open content; null if nothing is open. */
export function currentSnapshot(store: Store, workspace: Workspace): Snapshot | null {
  const { options, pool, input } = workspace;
  if (!pool) return null;
  const poses = Array.from({ length: pool.count - pool.imported }, (_, index) => pool.imported + index).map((pose) => ({
    name: pool.keys.info.names[pose] ?? '',
    positions: pool.keys.positions(pose),
  }));
  const { offset } = pool.keys.info;
  return { files: input, options, poses, offset, state: store.get(), history: store.history() };
}

export function bytesOf({ files, poses }: StoredProject): number {
  const sum = (sizes: number[]): number => sizes.reduce((total, size) => total + size, 0);
  return sum(files.map(({ bytes }) => bytes.byteLength)) + sum(poses.map(({ positions }) => positions.byteLength));
}
