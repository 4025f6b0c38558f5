/** Adds poses of the open mesh from other files, as keys or end tangents. */
import type { Engine } from '../../engine/api/api.ts';
import { modelName } from '../../engine/api/paths.ts';
import { readPoses } from '../../engine/api/read-poses.ts';
import { addKey, setEncoding, timesAt } from '../../model/edits.ts';
import type { InsertPosition } from '../../model/edits.ts';
import { undoName } from '../../model/option-words.ts';
import { TANGENT_NAME } from '../../model/speeds.ts';
import type { End } from '../../model/speeds.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import { readFiles } from './input-files.ts';

export interface AddPosesParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
}

/** A pose in the pool with its name. */
interface Pooled {
  pose: number;
  name: string;
}

/**
 * Adds all poses of the files, by default after the last key. Resolves to their number; null if other files were opened
 * meanwhile, or nothing is open. Fails for another mesh.
 */
export async function addPoses(
  parts: AddPosesParts,
  files: readonly PickedFile[],
  place: InsertPosition | null = null,
): Promise<number | null> {
  const added = await pooled(parts, files);
  if (!added) return null;
  nameSource(parts.store, files);
  parts.store.edit(added.length > 1 ? `add ${added.length} keys` : 'add a key', (doc) => {
    const times = timesAt(doc, place ?? { before: doc.keys.length }, added.length);
    return added.reduce((next, key, index) => addKey(next, { ...key, time: times[index]! }), doc);
  });
  return added.length;
}

/** Adds the files' names to the motion's source. */
function nameSource(store: Store, files: readonly PickedFile[]): void {
  const { source } = store.get();
  if (source.kind !== 'files') return;
  const names = [...new Set([...source.names, ...files.map(({ name }) => name)])];
  store.set({ source: { ...source, names } });
}

/**
 * Uses a file's shape for the tangent at an end. Resolves to its name; null if other files were opened meanwhile, or
 * nothing is open. Fails for another mesh, and for several poses.
 */
export async function takeTangent(
  parts: AddPosesParts,
  files: readonly PickedFile[],
  end: End,
): Promise<string | null> {
  const [shape] = (await pooled(parts, files, 1)) ?? [];
  if (!shape) return null;
  const change = { [TANGENT_NAME[end]]: shape.pose };
  parts.store.edit(undoName(change), (doc) => setEncoding(doc, change));
  return shape.name;
}

async function pooled(
  { engine, workspace }: AddPosesParts,
  files: readonly PickedFile[],
  most = Infinity,
): Promise<Pooled[] | null> {
  const { pool } = workspace;
  if (!pool) return null;
  const poses = await readPoses(engine, await readFiles(files), pool.keys, workspace.options);
  if (workspace.pool !== pool) return null;
  if (poses.length > most)
    throw new Error(`These files have ${poses.length} poses, but a tangent is one shape. Choose a file with one pose.`);
  return poses.map(({ name, positions }) => ({ name: modelName(name), pose: pool.add(modelName(name), positions) }));
}
