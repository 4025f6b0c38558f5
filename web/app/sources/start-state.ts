/** What is shown first of what was opened: its document with what is known of it, view, time and playing. */
import type { KeysInfo } from '../../engine/api/types.ts';
import { isInside } from '../../model/camera.ts';
import { setMotion } from '../../model/edits.ts';
import { keptDoc } from '../../model/kept-document.ts';
import { relativeTo, reoriented } from '../../model/orientation.ts';
import type { AppState, Doc, LoopMode, Play, Source, View } from '../../model/state.ts';
import { DEFAULT_VIEW, comfortableSpeed, offeredSpeed } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { clampTime, length } from '../../model/time-scale.ts';
import { newProjectId } from '../kept/project-shelf.ts';
import type { StoredProject } from '../kept/project-shelf.ts';
import type { Snapshot } from '../kept/snapshot.ts';
import { motionRange } from '../session/motion-range.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Turn } from '../session/store.ts';
import type { LoadedKeys, Start } from '../session/workspace.ts';
import type { OpenRequest } from './open-request.ts';
import { applyPermalink } from './permalink.ts';
import type { Permalink } from './permalink.ts';
import type { Sample } from './samples.ts';

export interface StartState extends Start {
  /** The document that the files start with when nothing else is known: links are written against it. */
  initial: Doc;
  /** What is followed of a link. */
  link: Permalink | null;
}

/** What becomes of the document of files that are read; `present`: what is still open. */
export function startOf(request: OpenRequest, read: Doc, pool: PosePool, present: Snapshot | null): StartState {
  const { begins, left, settings, turn } = request;
  const { info } = pool.keys;
  const base = settings ? withSettings(read, settings) : read;
  const begun = begins === 'files' ? ofFiles(base, info) : begins ? ofSample(base, begins) : base;
  const initial = turn && present ? restored(present, pool, turn) : begun;
  if (left) return { initial, doc: restored(left, pool), camera: leftView(left).camera, link: null };
  const doc = request.link ? applyPermalink(initial, request.link, info.report.components) : initial;
  const link = request.link ? outside(request.link, doc, pool) : null;
  return { initial, doc, camera: link?.view.camera ?? null, link };
}

/** The poses that are not of the files come back first: the document's keys name them by their place. */
export function restored({ poses, offset = [0, 0, 0], state }: StoredProject, pool: PosePool, turn?: Turn): Doc {
  const offsets = [offset, pool.keys.info.offset] as const;
  for (const { name, positions } of poses.slice(pool.count - pool.imported))
    pool.add(name, turn ? reoriented(positions, turn.before, turn.after, offsets) : relativeTo(positions, ...offsets));
  return keptDoc(state.doc);
}

/** With the settings of another document, but for those that name its keys. */
function withSettings(fresh: Doc, { motion, encoding }: Doc): Doc {
  const { referencePose, startTangentPose, endTangentPose } = fresh.encoding;
  return {
    ...fresh,
    motion: { ...motion, period: fresh.motion.period },
    encoding: { ...encoding, referencePose, startTangentPose, endTangentPose },
  };
}

/** The document of a sample: its end condition, what it holds, and the names of its poses. */
function ofSample(doc: Doc, { boundary, hold, names }: Sample): Doc {
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

/** What is there when the request is met: what is shown of it first, for what was shown before. */
export function openedState(
  { source, project, left, stays, turn }: OpenRequest,
  opening: LoadedKeys & StartState,
  before: AppState,
  range: Range,
  reducedMotion: boolean,
): AppState {
  const { doc, link } = opening;
  const own = source.kind === 'files' ? (project ?? newProjectId()) : null;
  const wanted = stays ? before.time : (link?.time ?? doc.keys[0]?.time ?? 0);
  // No further than the slider reaches.
  const time = clampTime(wanted, motionRange(doc, range));
  const opened = { source, project: own, doc, time, view: before.view, play: before.play };
  if (left) {
    const play = { ...left.state.play, playing: false };
    return { ...opened, view: leftView(left), play, time: left.state.time ?? time };
  }
  if (turn) return { ...opened, view: { ...before.view, camera: null } };
  if (stays) return opened;
  const play = openingPlay(opening, source, before.play, reducedMotion);
  return { ...opened, view: openingView(before.view, link), play };
}

/** What an earlier version did not have starts as it is by default. */
const leftView = ({ state }: StoredProject): View => ({ ...DEFAULT_VIEW, ...state.view });

/** The look stays, but not a divider; the camera is fitted unless a link says where it was. */
function openingView(view: View, link: Permalink | null): View {
  if (link) return { ...DEFAULT_VIEW, ...link.view };
  const compare = view.split === null ? view.compare : [];
  return { ...view, compare, split: null, camera: null, window: null, film: false };
}

/** What is opened moves at once, unless the visitor wants no motion or came by a link to a moment. */
function openingPlay(
  { info, doc, link }: LoadedKeys & StartState,
  source: Source,
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
  return { playing, speed, loop: openingLoop(loop, timed && info.animation >= 0), between: null, fps };
}

/** A clip plays in a loop, poses back and forth, unless the visitor lets motions play once. */
function openingLoop(before: LoopMode, clip: boolean): LoopMode {
  if (before === 'once') return before;
  return clip ? 'loop' : 'bounce';
}

/**
 * The link without a camera that is inside of the shape at its moment, where nothing can be seen but its inner side:
 * inside of the key there, or of both that it is between.
 */
function outside(link: Permalink, { keys }: Doc, pool: PosePool): Permalink {
  const { camera } = link.view;
  const t = link.time ?? keys[0]?.time ?? 0;
  const around = [keys.findLast(({ time }) => time <= t), keys.find(({ time }) => time >= t)];
  const { faces } = pool.keys.info;
  const seen = around.some((key) => key && camera && !isInside(camera.position, pool.keys.positions(key.pose), faces));
  if (!camera || seen) return link;
  return { ...link, view: { ...link.view, camera: null }, unfit: [...link.unfit, 'camera'] };
}
