/**
 * The one serialisable state: what is loaded, the keys and their times, the options, the moment and the view.
 * Permalinks, undo, the saved project and the test hook all read this and nothing else.
 */
import { ENCODING_DEFAULTS, MOTION_DEFAULTS } from '../engine/api/types.ts';
import type { Boundary, Method, MotionOptions, Placement, Stretch, Transfer } from '../engine/api/types.ts';

export type Source = { kind: 'none' } | { kind: 'sample'; id: string } | { kind: 'files'; names: string[] };

/** One key: which pose of the import, under which name, at which time. */
export interface KeyRef {
  /** Index into the poses that the session holds; stays the same for the whole life of an import. */
  pose: number;
  name: string;
  time: number;
}

/** Motion options as the app edits them; what shapes the slope at a key is kept per key and travels with it. */
export type Motion = Omit<MotionOptions, Shaping | 'inPlace'>;

export interface Encoding {
  /** Pose that deformations are measured from; null = the first key. */
  referencePose: number | null;
  /** 0 = the default formula. */
  patches: number;
  stretch: Stretch;
  /** 0 = no ghost mesh. */
  ghostFaces: number;
  transfer: Transfer;
  placement: Placement;
  /** Hermite: pose that takes the neighbour's place at that end; null = the keys' own difference. */
  startTangentPose: number | null;
  endTangentPose: number | null;
}

/** What undo and redo step through. */
export interface Doc {
  keys: KeyRef[];
  motion: Motion;
  encoding: Encoding;
  /** One value a key, in the keys' order; empty = all 0. */
  tension: number[];
  bias: number[];
  /** Whole turns that are added on the way to a key; the first key has no way to it. */
  turns: number[];
  /** The same of separate parts, against those that carry them: a list for each key; empty = none. */
  partTurns: (readonly PartTurns[])[];
}

/** At least one whole turn of one of the shape's components. */
export interface PartTurns {
  /** 0-based, counted by the components' first faces in the file. */
  component: number;
  turns: number;
}

/** What makes the motion about a key another than the smooth spline's own. */
export const SHAPINGS = ['tension', 'bias', 'turns'] as const;
export type Shaping = (typeof SHAPINGS)[number];

export type LoopMode = 'once' | 'loop' | 'bounce';

export interface Play {
  playing: boolean;
  /** Units of time a second. */
  speed: number;
  loop: LoopMode;
  /** First and last time that play; null = the range of the keys. */
  between: [number, number] | null;
  /** Whole frames a unit of time; null = as smooth as the screen allows. */
  fps: number | null;
}

export interface CameraPose {
  position: [number, number, number];
  target: [number, number, number];
}

export type Colouring = 'phase' | 'texture' | 'patches';

export interface View {
  colouring: Colouring;
  shading: 'smooth' | 'flat';
  wireframe: boolean;
  floor: boolean;
  onion: boolean;
  film: boolean;
  /** Methods shown beside the main one. */
  compare: Method[];
  /** With a ghost mesh: its wireframe over the shape; the ghost beside it; colours for what differs without it. */
  ghostWire: boolean;
  ghostBeside: boolean;
  ghostDifference: boolean;
  /** null = fitted to the shape. */
  camera: CameraPose | null;
  /** The part of the time that the slider shows; null = all that it reaches. */
  window: [number, number] | null;
}

export interface AppState {
  source: Source;
  doc: Doc;
  time: number;
  play: Play;
  view: View;
}

export const METHODS: readonly Method[] = ['lri', 'geodesic', 'linear', 'cubic-vertex'];
export const BOUNDARIES: readonly Boundary[] = ['natural', 'hermite', 'periodic'];
/** Faces of a ghost mesh when it is switched on: the paper's choice. */
export const GHOST_FACES = 2000;
/** More added turns than anybody means. */
export const MAX_TURNS = 100;
export const SPEEDS: readonly number[] = [0.1, 0.25, 0.5, 1, 2, 4];

export const DEFAULT_MOTION: Readonly<Motion> = {
  method: MOTION_DEFAULTS.method,
  boundary: MOTION_DEFAULTS.boundary,
  startSpeed: MOTION_DEFAULTS.startSpeed,
  endSpeed: MOTION_DEFAULTS.endSpeed,
  period: MOTION_DEFAULTS.period,
};

export const DEFAULT_ENCODING: Readonly<Encoding> = {
  referencePose: null,
  patches: 0,
  stretch: 'linear',
  ghostFaces: ENCODING_DEFAULTS.ghostFaces,
  transfer: ENCODING_DEFAULTS.transfer,
  placement: ENCODING_DEFAULTS.placement,
  startTangentPose: null,
  endTangentPose: null,
};

export const DEFAULT_VIEW: Readonly<View> = {
  colouring: 'phase',
  shading: 'smooth',
  wireframe: false,
  floor: true,
  onion: false,
  film: false,
  compare: [],
  ghostWire: false,
  ghostBeside: false,
  ghostDifference: false,
  camera: null,
  window: null,
};

export const EMPTY_STATE: AppState = {
  source: { kind: 'none' },
  doc: { keys: [], motion: { ...DEFAULT_MOTION }, encoding: { ...DEFAULT_ENCODING }, tension: [], bias: [], turns: [], partTurns: [] },
  time: 0,
  play: { playing: false, speed: 0.25, loop: 'bounce', between: null, fps: null },
  view: { ...DEFAULT_VIEW },
};

/** The methods in which the end derivatives have no meaning: the motion is straight between the keys. */
export function ignoresHermite(method: Method): boolean {
  return method === 'geodesic' || method === 'linear';
}

/** The methods of LRI space; the others blend positions, where neither stretches nor a ghost mesh have a part. */
export function isInLri(method: Method): boolean {
  return method === 'lri' || method === 'geodesic';
}

/** Index of the reference among the keys; the first key where the chosen pose is no longer one of them. */
export function referenceKey(doc: Doc): number {
  const index = doc.keys.findIndex((key) => key.pose === doc.encoding.referencePose);
  return Math.max(index, 0);
}

/**
 * Hermite: the key that tells the direction at either end, the neighbour or the one that is taken as end tangent; null where
 * that pose is no longer a key. null with another boundary.
 */
export function tangentKeys({ keys, motion, encoding }: Doc): { start: number | null; end: number | null } | null {
  if (motion.boundary !== 'hermite') return null;
  const of = (pose: number | null, neighbour: number): number | null => {
    if (pose === null) return neighbour;
    const index = keys.findIndex((key) => key.pose === pose);
    return index < 0 ? null : index;
  };
  return { start: of(encoding.startTangentPose, 1), end: of(encoding.endTangentPose, keys.length - 2) };
}

/** Speed at which the range plays in about four seconds, among the offered ones. */
export function comfortableSpeed(length: number): number {
  const wanted = length / 4;
  const distance = (speed: number): number => Math.abs(Math.log(speed / wanted));
  return SPEEDS.reduce((best, speed) => (distance(speed) < distance(best) ? speed : best));
}
