/** The document that an import starts with: its keys, and the options that a saved project brought along. */
import type { KeysInfo, SequenceOptions } from '../../engine/api/types.ts';
import type { Doc, PartTurns } from '../../model/state.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION } from '../../model/state.ts';
import type { PosePool } from './pose-pool.ts';

export function docOf(info: KeysInfo, pool: PosePool): Doc {
  const project = info.project ?? {};
  return {
    keys: info.times.map((time, pose) => ({ pose, time, name: shortName(info.names[pose] ?? '', pose) })),
    motion: {
      method: project.method ?? DEFAULT_MOTION.method,
      boundary: project.boundary ?? DEFAULT_MOTION.boundary,
      startSpeed: project.startSpeed ?? DEFAULT_MOTION.startSpeed,
      endSpeed: project.endSpeed ?? DEFAULT_MOTION.endSpeed,
      period: project.period ?? DEFAULT_MOTION.period,
    },
    encoding: {
      referencePose: project.reference ? project.reference : null,
      patches: project.patches ?? DEFAULT_ENCODING.patches,
      stretch: project.stretch ?? DEFAULT_ENCODING.stretch,
      ghostFaces: project.ghostFaces ?? DEFAULT_ENCODING.ghostFaces,
      transfer: project.transfer ?? DEFAULT_ENCODING.transfer,
      placement: project.placement ?? DEFAULT_ENCODING.placement,
      startTangentPose: tangentPose(project, 'startTangent', pool),
      endTangentPose: tangentPose(project, 'endTangent', pool),
    },
    tension: project.tension ?? [],
    bias: project.bias ?? [],
    turns: turnsOf(project, info.times.length),
    partTurns: partTurns(project, info.times.length),
  };
}

function turnsOf({ turns = [] }: Partial<SequenceOptions>, keys: number): number[] {
  const ofWhole = turns.filter(({ component }) => component === undefined);
  return ofWhole.length === 0 ? [] : Array.from({ length: keys }, (_, index) => ofWhole.find(({ key }) => key === index)?.turns ?? 0);
}

function partTurns({ turns = [] }: Partial<SequenceOptions>, keys: number): PartTurns[][] {
  const ofKey = (index: number): PartTurns[] =>
    turns.flatMap(({ key, component, turns: count }) => (key === index && component !== undefined ? [{ component, turns: count }] : []));
  return turns.every(({ component }) => component === undefined) ? [] : Array.from({ length: keys }, (_, index) => ofKey(index));
}

function tangentPose(project: Partial<SequenceOptions>, end: 'startTangent' | 'endTangent', pool: PosePool): number | null {
  const shape = project[end];
  if (!shape) return null;
  return pool.add(end === 'startTangent' ? 'start tangent' : 'end tangent', shape);
}

/** The file's name without folder and ending; it is the user's own word for the pose. */
function shortName(name: string, pose: number): string {
  const short = name.replace(/^.*[/\\]/, '').replace(/\.(glb|gltf|obj|ply|off)$/i, '');
  return short || `pose ${pose + 1}`;
}
