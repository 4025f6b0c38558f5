/**
 * The only serialisable state: loaded content, keys and times, options, current time and view. Permalinks, undo, the
 * saved project and the test hook read only this.
 */
import { METHOD } from '../engine/api/methods.ts';
import type { CameraPose } from './camera.ts';
import { ENCODING, MOTION } from '../engine/api/option-table.ts';
import type { Boundary, Method } from '../engine/api/types.ts';
import type { PageOptions } from './page-options.ts';
import { pageDefaults } from './page-options.ts';
import type { Shaping } from './shaping.ts';

export type Source = { kind: 'none' } | { kind: 'sample'; id: string } | { kind: 'files'; names: string[] };

/** One key: pose of the import, name, time, and options. */
export interface KeyRef {
  /** Index into the session's poses; never changes during an import's life. */
  pose: number;
  name: string;
  time: number;
  shaping: Shaping;
}

export type Motion = PageOptions<typeof MOTION>;
export type Encoding = PageOptions<typeof ENCODING>;

/** State covered by undo and redo. */
export interface Doc {
  keys: KeyRef[];
  motion: Motion;
  encoding: Encoding;
}

export type LoopMode = 'once' | 'loop' | 'bounce';

export interface Play {
  playing: boolean;
  /** Playback speed in units of time per second. */
  speed: number;
  loop: LoopMode;
  /** First and last time to play; null: the range of the keys. */
  between: [number, number] | null;
  /** Whole frames per unit of time; null: as smooth as the screen allows. */
  fps: number | null;
}

/**
 * `texture`: the file's materials, or clay without any. `distance`: distance of every vertex of the compared motion
 * from the first motion or the animation of the keys.
 */
export type Colouring = 'texture' | 'phase' | 'patches' | 'regions' | FaceAmount | 'distance';
/** Heat map of every face relative to the reference pose. */
export type FaceAmount = 'rotation' | 'stretch';

/** Content of a presentation: the shape alone, or beside one of the permanent plots. */
export const PRESENTED = ['shape', 'plane', 'volume', 'area', 'bending'] as const;
/** Plots of clicked or computed items. Links do not restore them, so they are enlarged only by the user. */
export const PASSING_PLOTS = [
  'face-rotation',
  'face-stretch',
  'patch-angles',
  'patch-rotation',
  'patch-stretch',
  'ghost-error',
  'ghost-time',
  'distance',
  'sliding',
] as const;
export type Presented = (typeof PRESENTED)[number] | (typeof PASSING_PLOTS)[number];
/** The plots among the presented content. */
export type Plot = Exclude<Presented, 'shape'>;

export interface View {
  colouring: Colouring;
  shading: 'smooth' | 'flat';
  wireframe: boolean;
  floor: boolean;
  onion: boolean;
  /** Number of onion skins on either side of the time. */
  onionSkins: number;
  /** Time between onion skins; null: a share of the range. */
  onionSpacing: number | null;
  film: boolean;
  /** Number of shapes in a film strip; null: chosen from the keys. */
  filmShapes: number | null;
  /** Methods shown beside the main one, at most MAX_COMPARED. */
  compare: Method[];
  /** Position of the divider between two motions, relative to the width; null: side by side. */
  split: number | null;
  /**
   * Display options of a ghost mesh: its wireframe over the shape, the ghost beside the shape, and colours for the
   * difference from the full solve.
   */
  ghostWire: boolean;
  ghostBeside: boolean;
  ghostDifference: boolean;
  /** Also show ghost meshes with two and four times the faces, side by side. */
  ghostSizes: boolean;
  /** The camera; null: fitted to the shape. */
  camera: CameraPose | null;
  /** The visible part of the timeline; null: the default. */
  window: [number, number] | null;
  /** The presented content; null: the page with all its controls. */
  present: Presented | null;
}

export interface AppState {
  source: Source;
  /** Key under which the user's own files and all edits are stored between visits; otherwise null. */
  project: string | null;
  doc: Doc;
  time: number;
  play: Play;
  view: View;
}

/** Limit for compared motions. A page has room for four views, including the motion itself. */
export const MAX_COMPARED = 3;
/** Limit for onion skins on either side of the current time. */
export const MAX_ONION_SKINS = 6;
/** Least spacing of onion skins, in units of time. */
export const MIN_ONION_SPACING = 0.001;
/** Colours of shapes before and after the current time. */
export const ONION_COLOURS = { before: '#8a5cd6', after: '#d9622b' } as const;
/** Limits for the shapes of a film strip. */
export const [MIN_FILM_SHAPES, MAX_FILM_SHAPES] = [4, 24];
export const BOUNDARIES: readonly Boundary[] = MOTION.boundary.choices;
/** Default number of ghost mesh faces, as in the paper. */
export const GHOST_FACES = 2000;
export const SPEEDS: readonly number[] = [0.1, 0.25, 0.5, 1, 2, 4];

export const DEFAULT_MOTION: Readonly<Motion> = pageDefaults(MOTION);
export const DEFAULT_ENCODING: Readonly<Encoding> = pageDefaults(ENCODING);

export const DEFAULT_VIEW: Readonly<View> = {
  colouring: 'texture',
  shading: 'smooth',
  wireframe: false,
  floor: true,
  onion: false,
  onionSkins: 2,
  onionSpacing: null,
  film: false,
  filmShapes: null,
  compare: [],
  split: null,
  ghostWire: false,
  ghostBeside: false,
  ghostDifference: false,
  ghostSizes: false,
  camera: null,
  window: null,
  present: null,
};

export const EMPTY_STATE: AppState = {
  source: { kind: 'none' },
  project: null,
  doc: { keys: [], motion: { ...DEFAULT_MOTION }, encoding: { ...DEFAULT_ENCODING } },
  time: 0,
  play: { playing: false, speed: 0.25, loop: 'bounce', between: null, fps: null },
  view: { ...DEFAULT_VIEW },
};

export function isFaceAmount(colouring: Colouring): colouring is FaceAmount {
  return colouring === 'rotation' || colouring === 'stretch';
}

/** Whether holding or pins change the motion from the published method. */
export function holds({ method, hold, pins }: Motion): boolean {
  return METHOD[method].holds && (hold !== 'off' || pins.length > 0);
}

/** Index of the reference among the keys; the first key if the chosen pose is no longer a key. */
export function referenceKey(doc: Doc): number {
  const index = doc.keys.findIndex((key) => key.pose === doc.encoding.referencePose);
  return Math.max(index, 0);
}

/** Target of an end tangent of a Hermite motion: the neighbouring key, or a separate shape. */
export type Towards = 'neighbour' | 'shape';

/** Targets of the end tangents; null if the boundary has no tangents. */
export function endTangents({ motion, encoding }: Doc): { start: Towards; end: Towards } | null {
  const towards = (pose: number | null): Towards => (pose === null ? 'neighbour' : 'shape');
  if (motion.boundary !== 'hermite') return null;
  return { start: towards(encoding.startTangentPose), end: towards(encoding.endTangentPose) };
}

/** The offered speed at which the range plays in about four seconds. */
export function comfortableSpeed(length: number): number {
  return offeredSpeed(length / 4);
}

/** The closest offered speed. */
export function offeredSpeed(wanted: number): number {
  const distance = (speed: number): number => Math.abs(Math.log(speed / wanted));
  return SPEEDS.reduce((best, speed) => (distance(speed) < distance(best) ? speed : best));
}
