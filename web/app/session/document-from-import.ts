/** The initial document of an import: its keys, and the options of a saved project. */
import { ENCODING, MOTION } from '../../engine/api/option-table.ts';
import type { OptionTable, ShapeName } from '../../engine/api/option-table.ts';
import type { KeysInfo, SequenceOptions } from '../../engine/api/types.ts';
import type { PageOptions } from '../../model/page-options.ts';
import { forPage } from '../../model/page-options.ts';
import { shapingOf } from '../../model/shaping.ts';
import type { Doc } from '../../model/state.ts';
import type { PosePool } from './pose-pool.ts';

export function documentFromImport(info: KeysInfo, pool: PosePool): Doc {
  const project = info.project ?? {};
  return {
    keys: info.times.map((time, pose) => ({
      pose,
      time,
      name: ownName(info.names[pose] ?? ''),
      shaping: shapingOf(project, pose),
    })),
    motion: fromProject(MOTION, project, pool),
    encoding: fromProject(ENCODING, project, pool),
  };
}

type Project = Partial<SequenceOptions>;

function fromProject<T extends OptionTable>(table: T, project: Project, pool: PosePool): PageOptions<T> {
  return forPage(table, ({ name, option }) => {
    if (option.kind === 'shape') return tangentPose(project, name as ShapeName, pool);
    const value = project[name as keyof SequenceOptions];
    // The first key is the reference unless another is chosen.
    return option.kind === 'key' ? value || null : (value ?? option.default);
  });
}

function tangentPose(project: Project, end: ShapeName, pool: PosePool): number | null {
  const shape = project[end];
  return shape ? pool.add(end === 'startTangent' ? 'start tangent' : 'end tangent', shape) : null;
}

/**
 * Keys of an animation are named by their time. Such a name is dropped, because it would not change when the key moves.
 */
const A_TIME = /^-?\d+(\.\d+)?(e[+-]?\d+)? s$/;

function ownName(name: string): string {
  return A_TIME.test(name) ? '' : name;
}
