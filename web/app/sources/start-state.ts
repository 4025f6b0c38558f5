/** Initial state of opened content: document, view, time and playback. */
import { goneIn, goneSentence } from '../../engine/api/gone-options.ts';
import type { KeysInfo } from '../../engine/api/types.ts';
import { isInside } from '../../model/camera.ts';
import { setMotion } from '../../model/edits.ts';
import { storedDocument } from '../../model/stored-document.ts';
import { relativeTo, reoriented, reorientedDoc } from '../../model/orientation.ts';
import type { AppState, Doc, LoopMode, Play, View } from '../../model/state.ts';
import { DEFAULT_VIEW, comfortableSpeed, offeredSpeed } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { clampTime, length } from '../../model/time-scale.ts';
import { newProjectId } from '../storage/project-shelf.ts';
import type { StoredProject } from '../storage/project-shelf.ts';
import type { Snapshot } from '../storage/snapshot.ts';
import { motionRange } from '../session/motion-range.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Turn } from '../session/store.ts';
import type { LoadedKeys, Start } from '../session/workspace.ts';
import { carriedSettings } from './carried-settings.ts';
import type { OpenRequest } from './open-request.ts';
import { applyPermalink } from './permalink.ts';
import type { Permalink } from './permalink.ts';
import type { Sample } from './samples.ts';

export interface StartState extends Start {
  /** The files' initial document without other settings; links store differences from it. */
  initial: Doc;
  /** The applied part of a link. */
  link: Permalink | null;
  /** Settings that no longer apply, as sentences. */
  lost: string[];
}

/** Initial document of imported files; `present`: the content that is still open, with its poses. */
export function startOf(
  request: OpenRequest,
  read: Doc,
  pool: PosePool,
  present: Snapshot | null,
  before: PosePool | null = null,
): StartState {
  const { begins, left, settings, turn } = request;
  const { info } = pool.keys;
  const { doc: base, lost } = settings ? carriedSettings(read, pool, settings, before) : { doc: read, lost: [] };
  const begun = begins === 'files' ? ofFiles(base, info) : begins ? ofSample(base, begins) : base;
  const initial = turn && present ? restored(present, pool, turn) : begun;
  if (left) {
    const gone = goneSentence(goneIn(left.state.doc.motion));
    return {
      initial,
      doc: restored(left, pool),
      camera: leftView(left).camera,
      link: null,
      lost: gone ? [...lost, gone] : lost,
    };
  }
  const doc = request.link ? applyPermalink(initial, request.link, info.report.components) : initial;
  const link = request.link ? outside(request.link, doc, pool) : null;
  return { initial, doc, camera: link?.view.camera ?? null, link, lost };
}

/** Added poses come first, because the document's keys refer to poses by index. */
export function restored({ poses, offset = [0, 0, 0], state }: StoredProject, pool: PosePool, turn?: Turn): Doc {
  const offsets = [offset, pool.keys.info.offset] as const;
  for (const { name, positions } of poses.slice(pool.count - pool.imported))
    pool.add(name, turn ? reoriented(positions, turn.before, turn.after, offsets) : relativeTo(positions, ...offsets));
  const doc = storedDocument(state.doc);
  return turn ? reorientedDoc(doc, turn.before, turn.after) : doc;
}

/** A sample's document: its end condition, holding and pose names. */
function ofSample(doc: Doc, { boundary, hold, names }: Sample): Doc {
  const keys = doc.keys.map((key, index) => ({ ...key, name: names?.[index] ?? key.name }));
  return setMotion({ ...doc, keys }, { boundary, hold });
}

/**
 * The document of the user's files. Keys sampled from an animation, other than its own keys, hold resting parts by
 * default. Poses use the published method. Projects have their own settings.
 */
export function ofFiles(doc: Doc, { animation, animations, project }: OfFiles): Doc {
  const keys = animations[animation]?.keys ?? doc.keys.length;
  const sampled = project === null && keys !== doc.keys.length;
  return sampled && doc.keys.length >= 3 ? setMotion(doc, { hold: 'on' }) : doc;
}

type OfFiles = Pick<KeysInfo, 'animation' | 'animations' | 'project'>;

/** The initial state after opening, based on the previous state. */
export function openedState(
  request: OpenRequest,
  opening: LoadedKeys & StartState,
  before: AppState,
  range: Range,
  reducedMotion: boolean,
): AppState {
  const { source, project, left, stays, turn } = request;
  const { doc, link } = opening;
  const own = source.kind === 'files' ? (project ?? newProjectId()) : null;
  const wanted = stays ? before.time : (link?.time ?? doc.keys[0]?.time ?? 0);
  // Limited to the slider's range.
  const time = clampTime(wanted, motionRange(doc, range));
  const opened = { source, project: own, doc, time, view: before.view, play: before.play };
  if (left) {
    const play = { ...left.state.play, playing: false };
    return { ...opened, view: leftView(left), play, time: left.state.time ?? time };
  }
  if (turn) return { ...opened, view: { ...before.view, camera: null } };
  if (stays) return opened;
  const play = openingPlay(opening, request, before.play, reducedMotion);
  return { ...opened, view: openingView(before.view, link), play };
}

/** Fields that an earlier version lacked get their defaults. */
const leftView = ({ state }: StoredProject): View => ({ ...DEFAULT_VIEW, ...state.view });

/** The look stays, but the divider does not. The camera is fitted unless a link specifies it. */
function openingView(view: View, link: Permalink | null): View {
  if (link) return { ...DEFAULT_VIEW, ...link.view };
  const compare = view.split === null ? view.compare : [];
  return { ...view, compare, split: null, camera: null, window: null, film: false };
}

/** Opened content plays immediately, unless the user prefers reduced motion or follows a link to a time. */
function openingPlay(
  { info, doc, link }: LoadedKeys & StartState,
  { source, settings }: OpenRequest,
  { loop, fps }: Play,
  reducedMotion: boolean,
): Play {
  const range = [doc.keys[0]?.time ?? 0, doc.keys.at(-1)?.time ?? 1] as const;
  // Samples and projects of earlier versions have times without a unit.
  const timed = source.kind === 'files' && info.project === null;
  const own = timed ? 1 : info.speed !== null ? offeredSpeed(info.speed) : comfortableSpeed(length(range));
  const speed = link?.speed ?? own;
  const playing = (link?.playing ?? true) && !reducedMotion;
  if (link) return { playing, speed, loop: link.loop ?? loop, between: link.between, fps: link.fps };
  const ends = openingLoop(loop, timed && info.animation >= 0);
  // The frame rate belongs to the files.
  return { playing, speed, loop: ends, between: null, fps: settings ? fps : null };
}

/** A clip loops and poses play back and forth, unless the user has chosen to play once. */
function openingLoop(before: LoopMode, clip: boolean): LoopMode {
  if (before === 'once') return before;
  return clip ? 'loop' : 'bounce';
}

/**
 * Drops a link's camera that is inside the shape at its time, where only the surface's inside is visible. Tests the key
 * at that time, or both neighbouring keys.
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
