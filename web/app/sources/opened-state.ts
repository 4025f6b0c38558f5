/** What is shown first of what was opened: its document with what is known of it, view, time and playing. */
import { IMPORT } from '../../engine/api/option-table.ts';
import { extensionOf, isModel } from '../../engine/api/paths.ts';
import type { ImportOptions, InputFile, KeysInfo } from '../../engine/api/types.ts';
import { isInside } from '../../model/camera.ts';
import { setMotion } from '../../model/edits.ts';
import { keptDoc } from '../../model/kept-document.ts';
import type { Doc, Play, Source, View } from '../../model/state.ts';
import { DEFAULT_VIEW, comfortableSpeed, offeredSpeed } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { clampTime, length } from '../../model/time-scale.ts';
import { relativeTo } from '../../model/orientation.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { Remembered } from '../kept/project-shelf.ts';
import { motionRange } from '../session/motion-range.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Opened } from '../session/workspace.ts';
import type { Permalink } from './permalink.ts';
import type { Sample } from './samples.ts';

/** The poses that are not of the files come back first: the document's keys name them by their place. */
export function restored({ poses, offset = [0, 0, 0], state }: Remembered, pool: PosePool): Doc {
  for (const { name, positions } of poses.slice(pool.count - pool.imported))
    pool.add(name, relativeTo(positions, offset, pool.keys.info.offset));
  return keptDoc(state.doc);
}

/** With the settings of another document, but for those that name its keys. */
export function withSettings(fresh: Doc, { motion, encoding }: Doc): Doc {
  const { referencePose, startTangentPose, endTangentPose } = fresh.encoding;
  return {
    ...fresh,
    motion: { ...motion, period: fresh.motion.period },
    encoding: { ...encoding, referencePose, startTangentPose, endTangentPose },
  };
}

/** The document of a sample: its end condition, what it holds, and the names of its poses. */
export function ofSample(doc: Doc, { boundary, hold, names }: Sample): Doc {
  const keys = doc.keys.map((key, index) => ({ ...key, name: names?.[index] ?? key.name }));
  return setMotion({ ...doc, keys }, { boundary, hold });
}

/**
 * The document of the user's files. Moments that are sampled from an animation, which are others than its own keys, are
 * of a world in which feet stand; poses move by the method as published, and a project as it says.
 */
export function ofFiles(doc: Doc, { animation, animations, project }: OfFiles): Doc {
  const keys = animations[animation]?.keys ?? doc.keys.length;
  const sampled = project === null && keys !== doc.keys.length;
  return sampled && doc.keys.length >= 3 ? setMotion(doc, { hold: 'on' }) : doc;
}

type OfFiles = Pick<KeysInfo, 'animation' | 'animations' | 'project'>;

/** The look stays, but not a divider; the camera is fitted unless a link says where it was. */
export function openingView(view: View, link: Permalink | null): View {
  if (link) return { ...DEFAULT_VIEW, ...link.view };
  const compare = view.split === null ? view.compare : [];
  return { ...view, compare, split: null, camera: null, window: null, film: false };
}

/** glTF says which way is up and how long a metre is; the other formats do not. */
export function orientationOf(
  input: readonly InputFile[],
  { up = IMPORT.up.default, unit = IMPORT.unit.default }: ImportOptions,
): Orientation | null {
  return input.some(({ name }) => !['glb', 'gltf'].includes(extensionOf(name)) && isModel(name)) ? { up, unit } : null;
}

/** The time that is shown first: no further than the slider reaches. */
export function openingTime(doc: Doc, range: Range, wanted: number | null): number {
  return clampTime(wanted ?? doc.keys[0]?.time ?? 0, motionRange(doc, range));
}

/** What is opened moves at once, unless the visitor wants no motion or came by a link to a moment. */
export function openingPlay(
  { info, doc }: Opened,
  source: Source,
  link: Permalink | null,
  { loop, fps }: Play,
  reducedMotion: boolean,
): Play {
  const range = [doc.keys[0]?.time ?? 0, doc.keys.at(-1)?.time ?? 1] as const;
  // Samples and projects of earlier versions have times of no unit.
  const timed = source.kind === 'files' && info.project === null;
  const own = timed ? 1 : info.speed !== null ? offeredSpeed(info.speed) : comfortableSpeed(length(range));
  const speed = link?.speed ?? own;
  const playing = (link?.playing ?? true) && !reducedMotion;
  if (link) return { playing, speed, loop: link.loop ?? loop, between: link.between, fps: link.fps };
  return { playing, speed, loop, between: null, fps };
}

/**
 * Whether a camera is inside of the shape at a moment, where nothing can be seen but its inner side: inside of the key
 * there, or of both that it is between.
 */
export function isBuried(camera: View['camera'], t: number, doc: Doc, pool: PosePool, faces: Uint32Array): boolean {
  if (!camera) return false;
  const before = doc.keys.findLast(({ time }) => time <= t);
  const after = doc.keys.find(({ time }) => time >= t);
  return [before, after].every((key) => !key || isInside(camera.position, pool.keys.positions(key.pose), faces));
}
