/** The document of the same files read again, with other keys or objects: settings that still apply are kept. */
import type { KeysInfo, Pin, SceneObject } from '../../engine/api/types.ts';
import { relativeTo } from '../../model/orientation.ts';
import { TANGENT_NAME } from '../../model/speeds.ts';
import type { Doc } from '../../model/state.ts';
import type { PosePool } from '../session/pose-pool.ts';

export interface Carried {
  doc: Doc;
  /** What no longer applies, as sentences. */
  lost: string[];
}

/** `before`: the poses that the settings refer to; null if unknown, for keys of the same animation and mesh. */
export function carriedSettings(read: Doc, pool: PosePool, settings: Doc, before: PosePool | null): Carried {
  const lost: string[] = [];
  const vertexOf = before && vertexMap(before.keys.info, pool.keys.info);
  const poseOf = (pose: number): number | null => poseNow(pool, settings, before, pose);
  const later = laterTime(before?.keys.info ?? null, pool.keys.info) ?? ((t: number) => t);
  const stays = (pin: Pin, number: string): Pin => {
    const { stay, ...free } = pin;
    // A pin whose key was removed follows its own spline already.
    if (stay === undefined || !settings.keys.some((key) => key.pose === stay)) return free;
    const pose = poseOf(stay);
    if (pose !== null) return { ...free, stay: pose };
    lost.push(`Pin ${number} follows its own spline, because the key that it stayed at is gone.`);
    return free;
  };
  const pins = settings.motion.pins.flatMap((pin, index) => {
    const number = String(index + 1);
    const vertex = vertexOf ? (vertexOf[pin.vertex] ?? -1) : pin.vertex;
    const path = pin.path?.map((key) => ({ ...key, time: later(key.time) }));
    if (vertex >= 0) return [{ ...stays(pin, number), vertex, ...(path && { path }) }];
    lost.push(`Pin ${number} was removed, because its object is left out.`);
    return [];
  });
  const tangentOf = (end: 'start' | 'end'): number | null => {
    const pose = settings.encoding[TANGENT_NAME[end]];
    if (pose === null || !before) return null;
    const positions = positionsNow(before, pool, vertexOf, pose);
    if (positions) return pool.add(before.keys.info.names[pose] ?? `${end} tangent`, positions);
    lost.push(`The ${end} tangent was removed, because its shape lacks an object.`);
    return null;
  };
  if (settings.motion.regions.length > 0)
    lost.push('Regions have the timing of the whole again, because their timings belonged to other keys.');
  const { referencePose } = settings.encoding;
  return {
    doc: {
      ...read,
      motion: { ...settings.motion, period: read.motion.period, pins, regions: [] },
      encoding: {
        ...settings.encoding,
        referencePose: referencePose === null ? null : poseOf(referencePose),
        startTangentPose: tangentOf('start'),
        endTangentPose: tangentOf('end'),
      },
    },
    lost,
  };
}

/** The imported pose nearest in time to an earlier one; null for an added pose, or if the times are others. */
function poseNow(pool: PosePool, { keys }: Doc, before: PosePool | null, pose: number): number | null {
  const later = laterTime(before?.keys.info ?? null, pool.keys.info);
  const isImported = !before || pose < before.imported;
  const time = before ? before.keys.info.times[pose] : keys.find((key) => key.pose === pose)?.time;
  if (!later || !isImported || time === undefined) return null;
  const apart = pool.keys.info.times.slice(0, pool.imported).map((t) => Math.abs(t - later(time)));
  return apart.indexOf(Math.min(...apart));
}

/** Converts times to those of the keys now: from a project to its own animation; null for another animation. */
function laterTime(before: KeysInfo | null, now: KeysInfo): ((t: number) => number) | null {
  if (!before || before.animation === now.animation) return (t) => t;
  if (before.project === null || now.animation !== 0) return null;
  const { played, times, speed, animations } = before;
  const start = animations[0]?.start ?? 0;
  return (t) => start + (t - (played ?? times)[0]!) / (speed ?? 1);
}

/** An earlier pose with the vertices of now; null if it lacks some. */
function positionsNow(
  before: PosePool,
  pool: PosePool,
  vertexOf: Int32Array | null,
  pose: number,
): Float32Array | null {
  const { offset } = before.keys.info;
  const { info } = pool.keys;
  const positions = relativeTo(before.keys.positions(pose), offset, info.offset);
  if (!vertexOf) return positions;
  const own = new Float32Array(3 * info.report.vertices).fill(NaN);
  vertexOf.forEach((vertex, earlier) => {
    if (vertex >= 0) own.set(positions.subarray(3 * earlier, 3 * earlier + 3), 3 * vertex);
  });
  return own.some(Number.isNaN) ? null : own;
}

/** For each vertex of the earlier mesh, its index now, or -1; null for the same objects. Objects keep their faces. */
function vertexMap(before: KeysInfo, now: KeysInfo): Int32Array | null {
  const [objects, others] = [objectsByName(before), objectsByName(now)];
  if (before.faces.length === now.faces.length && [...objects.keys()].every((name) => others.has(name))) return null;
  const vertexOf = new Int32Array(before.report.vertices).fill(-1);
  for (const [name, { start, count }] of objects) {
    const other = others.get(name);
    if (other?.count !== count) continue;
    for (let corner = 0; corner < 3 * count; corner += 1)
      vertexOf[before.faces[3 * start + corner]!] = now.faces[3 * other.start + corner]!;
  }
  return vertexOf;
}

/** Objects of one name are numbered. */
function objectsByName({ scene }: KeysInfo): Map<string, SceneObject> {
  const seen = new Map<string, number>();
  return new Map(
    (scene?.objects ?? []).map((object) => {
      const number = (seen.get(object.name) ?? 0) + 1;
      seen.set(object.name, number);
      return [`${number} ${object.name}`, object];
    }),
  );
}
