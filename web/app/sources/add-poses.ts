/** Poses of the open mesh, from files of their own, become keys. */
import type { Engine } from '../../engine/api/api.ts';
import { modelName } from '../../engine/api/paths.ts';
import { readPoses } from '../../engine/api/read-poses.ts';
import { addKey, timesAt } from '../../model/edits.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { readFiles } from './input-files.ts';

export interface AddPosesParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
}

/**
 * Adds all that the files hold before the key `place`, by default after the last one. Resolves to how many there were;
 * null where other files were opened meanwhile, or none are. Fails on another mesh.
 */
export async function addPoses(
  { engine, store, workspace }: AddPosesParts,
  files: readonly PickedFile[],
  place: number | null = null,
): Promise<number | null> {
  const { pool } = workspace;
  if (!pool) return null;
  const poses = await readPoses(engine, await readFiles(files), pool.keys, workspace.options);
  if (workspace.pool !== pool) return null;
  const added = poses.map(({ name, positions }) => ({ name: modelName(name), pose: pool.add(name, positions) }));
  store.edit(added.length > 1 ? `add ${added.length} keys` : 'add a key', (doc) => {
    const times = timesAt(doc, place ?? doc.keys.length, added.length);
    return added.reduce((next, key, index) => addKey(next, { ...key, time: times[index]! }), doc);
  });
  return added.length;
}
