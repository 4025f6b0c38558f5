/**
 * Every option of the engine, described once: allowed values, default, command-line flag, name in the page. Types and
 * defaults (types.ts), checks (options.ts), project files, the command line with its help, the page's document with
 * links, undo and CSV, and OPTIONS.md all come from these tables. Plain data; imports nothing.
 */

/** Largest absolute time. A difference of 1e-6 is still representable there. */
export const MOST_TIME = 1e9;
export const MOST_FRAMES = 100_000;
export const MOST_KEYS = 10_000;
/** Pins, and keys of a path of one. */
export const MOST_PINS = 100;
export const MOST_PATH_KEYS = 1000;
/** More added turns than anybody means. */
export const MOST_TURNS = 100;
/** Upper bound on slopes, relative to the default slope at a key. */
const MOST_SLOPE = 1000;

/** Full turns between a key and the one before it, of the whole shape, or of a component relative to its parent. */
export interface AddedTurns {
  /** 0-based, at least 1. */
  key: number;
  /** Negative ones go the other way. */
  turns: number;
  /** 0-based, counted by the components' first faces in the file; absent: the whole shape. */
  component?: number;
}

/** A key of the path that a pin is moved along. */
export interface PathKey {
  time: number;
  /** From where the pin would be without a path, in the unit of the positions. */
  move: [x: number, y: number, z: number];
}

/** Vertices that are held by hand: those around one of the mesh. They follow their own splines, unless they stay. */
export interface Pin {
  /** 0-based index in the file. */
  vertex: number;
  /** Radius of the held ball, relative to the size of the shape; 0: the patch at the vertex. */
  radius: number;
  /** 0-based key whose positions they keep. */
  stay?: number;
  /** Offsets over time, in increasing order. */
  path?: PathKey[];
}

/** An object's run of faces. */
export interface SceneObject {
  /** Made up where the file has none. */
  name: string;
  /** First face and number of faces. */
  start: number;
  count: number;
  /** As the file has them, or empty: of the node, its mesh, and the nodes above it. */
  nodeName: string;
  meshName: string;
  path: string;
  /** OBJ: a group (g), not an object (o). */
  isGroup: boolean;
}

/** The values of each kind, if the kind determines them. */
interface Values {
  number: number;
  flag: boolean;
  /** Index of a key; the command line counts from 1. */
  key: number;
  /** 3 x vertices positions; a file on the command line, base64 in a project. */
  shape: Float32Array;
  turns: AddedTurns[];
  pins: Pin[];
  numbers: number[];
  /** One per key, sum 1. */
  weights: number[];
  /** First and last of a stretch of numbers. */
  range: [number, number];
  /** Name or index of an animation. */
  animation: string | number;
  /** Increasing times, or how many evenly spaced ones. */
  sample: number[] | number;
  /** 3 x faces. */
  faces: Uint32Array;
  point: readonly [x: number, y: number, z: number];
  objects: SceneObject[];
  names: string[];
  text: string;
}

interface Described {
  /** Text of the command-line help and OPTIONS.md. */
  help: string;
  /** On the command line: the flag without its dashes, and the placeholder of its value. */
  flag?: string;
  value?: string;
  /** In the page: name in the document and in links. Absent: the page does not offer it. */
  page?: string;
  /** In the page: undo's name of a change. */
  undo?: string;
  /** In the page: label and tooltip of the control. */
  label?: string;
  hint?: string;
}

export interface NumberOption extends Described {
  kind: 'number';
  /** null: it may be null. Absent: it may be absent. */
  default?: number | null;
  whole?: true;
  /** Bounds, which every number has; `above` is not reached itself. */
  above?: number;
  least?: number;
  most: number;
  /** The word for 0 on the command line; 0 is allowed in addition to the range. */
  zero?: string;
}

export interface ChoiceOption extends Described {
  kind: 'choice';
  choices: readonly string[];
  /** Former names of choices: still read in links, projects and commands. */
  formerly?: Readonly<Record<string, string>>;
  default?: string;
}

export interface OtherOption extends Described {
  kind: Exclude<keyof Values, 'number'>;
  default?: null | boolean | number | readonly never[];
  /** Of lists: at least one entry, and the largest number of entries. */
  some?: true;
  most?: number;
}

export type Option = NumberOption | ChoiceOption | OtherOption;
export type OptionTable = Readonly<Record<string, Option>>;
type Shown = Required<Pick<Described, 'undo' | 'label' | 'hint'>>;
/** An option per key: a number, or full turns. */
export type KeyOption =
  | (NumberOption & Shown & { default: number; slider: readonly [first: number, last: number] })
  | (OtherOption & Shown & { kind: 'turns' });

/** The type of an option's value. */
export type ValueOf<O> =
  | (O extends { choices: readonly (infer C)[] }
      ? C
      : O extends { kind: infer K extends keyof Values }
        ? Values[K]
        : never)
  | (O extends { default: null } ? null : never);
export type ValuesOf<T> = { -readonly [N in keyof T]: ValueOf<T[N]> };

/** Options that refit the spline only: they never encode again, and factor only for `hold` and `pins`. */
export const MOTION = {
  method: {
    kind: 'choice',
    choices: ['lri', 'geodesic', 'linear', 'cubic-vertex', 'rotation-strain', 'rimd'],
    default: 'lri',
    flag: 'method',
    help: "the paper's method (lri), or a method for comparison",
    page: 'method',
    undo: 'method',
  },
  hold: {
    kind: 'choice',
    choices: ['off', 'on'],
    formerly: { contact: 'on', anchored: 'on' },
    default: 'off',
    flag: 'hold',
    help: 'on: vertices that rest between two keys are kept in place; off (default): no correction, as in the paper',
    page: 'hold',
    undo: 'hold',
  },
  /** Held by hand, with the method 'lri'; the first pin that would hold a vertex has it. */
  pins: {
    kind: 'pins',
    most: MOST_PINS,
    default: [],
    flag: 'pin',
    value: 'VERTEX[:RADIUS][:stay=KEY][:path=T/X/Y/Z,...]',
    help:
      "pin the vertices around VERTEX (0-based index in the file), within RADIUS (fraction of the shape's size) or its " +
      'patch; they follow their own splines, or stay as in KEY, offset by X, Y, Z at time T; repeatable',
    page: 'pins',
    undo: 'pins',
  },
  boundary: {
    kind: 'choice',
    choices: ['natural', 'hermite', 'periodic'],
    default: 'natural',
    flag: 'boundary',
    help: 'no bending at the ends, given speeds at the ends, or a loop',
    page: 'boundary',
    undo: 'ends',
  },
  /** Hermite: times the one-sided difference at the first key; 0 = ease. */
  startSpeed: {
    kind: 'number',
    least: -MOST_SLOPE,
    most: MOST_SLOPE,
    default: 1,
    flag: 'start-speed',
    value: 'S',
    help: 'hermite: speed at the first key, relative to the speed between the first two keys; 0 eases in',
    page: 'startSpeed',
    undo: 'start speed',
  },
  /** Hermite: the same at the last key. */
  endSpeed: {
    kind: 'number',
    least: -MOST_SLOPE,
    most: MOST_SLOPE,
    default: 1,
    flag: 'end-speed',
    value: 'S',
    help: 'hermite: speed at the last key, relative to the speed between the last two keys; 0 eases out',
    page: 'endSpeed',
    undo: 'end speed',
  },
  /** Periodic: the whole period in units of time; null = the default. */
  period: {
    kind: 'number',
    above: 0,
    most: MOST_TIME,
    default: null,
    flag: 'period',
    value: 'P',
    help: 'periodic: length of one period',
    page: 'period',
    undo: 'period',
  },
  /** With the method 'lri' and no whole turns. */
  ownPaths: {
    kind: 'choice',
    choices: ['off', 'absolute', 'root'],
    default: 'off',
    flag: 'own-paths',
    help:
      'rotate each face separately from key to key where this agrees with its patch; absolute: closer to sampled ' +
      'animations; root: rotations relative to the largest patch, independent of the orientation of a key',
  },
  /** Take out the translation that accumulates along the sequence. */
  inPlace: { kind: 'flag', default: false, flag: 'in-place', help: 'remove the overall translation' },
} as const satisfies OptionTable;

/**
 * Options per key, which refit the spline only. In the page's document each key has its own; the engine takes lists: of
 * numbers (empty, or one per key), and of turns.
 */
export const PER_KEY = {
  /** Slope at the key = (1 - tension) times the C2 spline's own. */
  tension: {
    kind: 'number',
    least: -MOST_SLOPE,
    most: MOST_SLOPE,
    default: 0,
    flag: 'tension',
    value: 'X,X,...',
    help: 'one per key: 0 keeps the smooth slope, 1 stops at the key',
    undo: 'tension',
    label: 'Tension',
    hint: 'Scales the slope at this key. 0: smooth; 1: stops at the key, which removes overshoot',
    slider: [0, 1],
  },
  /** Above 0 the slope goes over to the difference from the key before, below 0 to that to the key after. */
  bias: {
    kind: 'number',
    least: -1,
    most: 1,
    default: 0,
    flag: 'bias',
    value: 'X,X,...',
    help:
      'one per key, -1 to 1: negative biases the slope toward the step to the next key, positive toward the step from ' +
      'the previous key',
    undo: 'bias',
    label: 'Bias (earlier / later)',
    hint:
      'Bias of the slope at this key: negative toward the step to the next key, positive toward the step from the ' +
      'previous key',
    slider: [-1, 1],
  },
  /** Full turns added between the previous key and this one. */
  turns: {
    kind: 'turns',
    flag: 'turns',
    value: 'KEY:N[@COMPONENT],...',
    help:
      'add N full turns between the previous key and KEY, to the whole shape or to COMPONENT (1-based, in the order of ' +
      'their faces in the file)',
    undo: 'turns',
    label: 'Extra turns since the previous key',
    hint:
      'Full turns to add since the previous key. The keys cannot determine their number; ' +
      'negative turns have the opposite direction',
  },
} as const satisfies Readonly<Record<string, KeyOption>>;

/** Choices that change the encoding: a new sequence is built for them. */
export const ENCODING = {
  /** 0-based key that deformation gradients are measured from. */
  reference: {
    kind: 'key',
    default: 0,
    flag: 'reference',
    value: 'KEY',
    help: 'key from which deformations are measured',
    page: 'referencePose',
    undo: 'reference pose',
  },
  /** Approximate number of patches; 0 = the default formula. */
  patches: {
    kind: 'number',
    whole: true,
    least: 0,
    most: 100_000,
    default: 0,
    flag: 'patches',
    value: 'N',
    help: 'number of patches; default: about the square root of the number of faces',
    page: 'patches',
    undo: 'patches',
  },
  stretch: {
    kind: 'choice',
    choices: ['linear', 'log'],
    default: 'linear',
    flag: 'stretch',
    help: 'how stretch is interpolated; with log, faces cannot turn inside out',
    page: 'stretch',
    undo: 'stretch',
  },
  /**
   * 0 = off, otherwise at least 4: the splines run on a ghost mesh of about this many faces, and the shape follows it.
   */
  ghostFaces: {
    kind: 'number',
    whole: true,
    least: 4,
    most: 16_000_000,
    zero: 'off',
    default: 0,
    flag: 'ghost-faces',
    value: 'N|off',
    help: 'let a ghost mesh of about N faces lead the motion; default: off',
    page: 'ghostFaces',
    undo: 'ghost faces',
  },
  /** With a ghost mesh. */
  transfer: {
    kind: 'choice',
    choices: ['exact', 'paper'],
    default: 'exact',
    flag: 'transfer',
    help: 'with a ghost mesh: pass exactly through every key (default), or transfer as in the paper',
    page: 'transfer',
    undo: 'transfer',
  },
  placement: {
    kind: 'choice',
    choices: ['vertices', 'optimal'],
    default: 'vertices',
    flag: 'placement',
    help: "placement of the ghost mesh's vertices; default: on vertices of the shape",
    page: 'placement',
    undo: 'placement',
  },
  precision: {
    kind: 'choice',
    choices: ['single', 'exact'],
    formerly: { double: 'exact' },
    default: 'single',
    flag: 'precision',
    help: 'exact: double-precision coordinates, and a solution refined to that precision',
  },
  /** Hermite: a shape that takes the neighbour key's place in the difference at that end. */
  startTangent: {
    kind: 'shape',
    default: null,
    flag: 'start-tangent',
    value: 'FILE',
    help: 'hermite: pose toward which the motion leaves the first key; default: the second key',
    page: 'startTangentPose',
    undo: 'start tangent pose',
  },
  endTangent: {
    kind: 'shape',
    default: null,
    flag: 'end-tangent',
    value: 'FILE',
    help: 'hermite: pose from which the motion arrives at the last key; default: the key before the last',
    page: 'endTangentPose',
    undo: 'end tangent pose',
  },
} as const satisfies OptionTable;

/** Default number of evenly spaced keys from an animation. */
export const SAMPLED_KEYS = 8;
/** Most keys from an animation in the page: more cannot be distinguished on a timeline. */
export const MOST_SAMPLED = 64;

/** Options of an import. */
export const IMPORT = {
  /** Key times; default: the animation's own, else a second from one key to the next. */
  keyTimes: {
    kind: 'numbers',
    most: MOST_KEYS,
    flag: 'key-times',
    value: 'T,T,...',
    help: "times of the keys in seconds; default: the animation's own, or one second apart",
  },
  /** Name or index of the animation to sample keys from; default: the first. */
  animation: {
    kind: 'animation',
    flag: 'animation',
    value: 'NAME|INDEX',
    help: 'take the keys from this animation of the file; default: the first animation that moves',
  },
  /** Times on the animation's own timeline, in seconds, or how many evenly spaced ones; default 8. */
  sample: {
    kind: 'sample',
    most: MOST_KEYS,
    flag: 'sample',
    value: 'T,T,...|N',
    help:
      `take the keys at these times in seconds, or at N evenly spaced times (default: ${SAMPLED_KEYS}); also for a PC2 or ` +
      'MDD file with its OBJ, and for numbered .obj or .ply files (24 per second; up to 32 frames are all keys)',
  },
  /** Every frame of the animation becomes a key. */
  everyFrame: { kind: 'flag', flag: 'every-frame', help: 'take every frame of the animation as a key' },
  /** Axis that points up in OBJ, PLY and OFF files; glTF is always y. Default 'y'. */
  up: {
    kind: 'choice',
    choices: ['y', 'z'],
    default: 'y',
    flag: 'up',
    help: 'up axis of .obj, .ply and .off files',
  },
  /** Metres per unit of OBJ, PLY and OFF files. Default 1. */
  unit: {
    kind: 'number',
    least: 1e-9,
    most: 1e9,
    default: 1,
    flag: 'unit',
    value: 'METRES',
    help: 'metres per unit of .obj, .ply and .off files',
  },
  /** Names of objects in the files; default: all of them. */
  objects: {
    kind: 'names',
    some: true,
    flag: 'object',
    value: 'NAME',
    help: 'use only this object of the files; repeatable; default: all objects',
  },
  /** 3 x faces of the mesh that the files must match: their polygons are cut into its triangles. */
  like: {
    kind: 'faces',
    help: 'faces of the mesh that the files must match; their polygons are cut into its triangles',
  },
  /** 3 x vertices of that mesh in some pose: the keys come in its vertices, however the files split them. */
  likePose: {
    kind: 'shape',
    help: 'positions of that mesh; the keys then use its vertices, even if the files split them differently',
  },
  /** `info.offset` of the keys that these poses belong to; default: zero, or the middle of a far shape. */
  offset: {
    kind: 'point',
    help: 'offset to subtract from positions before rounding to single precision; for added poses, the offset of the keys; default: zero, or the middle of a shape far from the origin',
  },
  /** `scene.objects` of that mesh: objects of the files are matched with these. */
  likeObjects: {
    kind: 'objects',
    help: "`scene.objects` of that mesh, for matching the files' objects",
  },
} as const satisfies OptionTable;

/** Frames of an export with neither a number of frames nor a tolerance. */
export const USUAL_FRAMES = 60;

export const EXPORT = {
  format: {
    kind: 'choice',
    choices: ['glb', 'obj', 'ply', 'pc2', 'mdd'],
    default: 'glb',
    help: 'one file with an animation, one file per shape, or a point cache with one OBJ',
  },
  /** These times instead of frames and range, in any order; a GLB gets the keys between them too. */
  times: {
    kind: 'numbers',
    some: true,
    most: MOST_FRAMES,
    default: null,
    flag: 'at',
    value: 'T,T,...',
    help: 'times to export, which can be beyond the keys: --at=-0.3,1.3',
  },
  /** Evenly spaced frames over the range; a GLB also includes the keys in it, so it passes through them. */
  frames: {
    kind: 'number',
    whole: true,
    least: 2,
    most: MOST_FRAMES,
    default: null,
    flag: 'frames',
    value: 'K',
    help: `number of evenly spaced times; default: GLB: as few as --tolerance allows; otherwise ${USUAL_FRAMES}`,
  },
  /**
   * Whole frames of the motion's time, or of the exported time if a duration is given; a GLB omits frames that the
   * tolerance allows to omit.
   */
  fps: {
    kind: 'number',
    least: 0.01,
    most: 1000,
    default: null,
    flag: 'fps',
    value: 'F',
    help: 'frames per second; all times are whole frames, as in animation programs',
  },
  /**
   * How far a vertex may be off when a GLB is played, in percent of the bounding box's diagonal: without it every frame
   * is written.
   */
  tolerance: {
    kind: 'number',
    least: 0.0001,
    most: 100,
    zero: 'off',
    default: 0.1,
    flag: 'tolerance',
    value: 'PERCENT|off',
    help: "GLB: largest error of linear playback, in % of the model's size; off: every frame; default: 0.1",
  },
  /** 'principal': the keys and a few corrections that the animation mixes, instead of a target per time. */
  targets: {
    kind: 'choice',
    choices: ['frames', 'principal'],
    default: 'frames',
    flag: 'targets',
    help: 'GLB: frames: one morph target per exported time; principal: one per key plus a few in-betweens, which the animation blends',
  },
  compression: {
    kind: 'choice',
    choices: ['none', 'quantized', 'meshopt'],
    default: 'none',
    flag: 'compression',
    help: 'GLB: quantized: 16 bits per coordinate (KHR_mesh_quantization); meshopt: also EXT_meshopt_compression',
  },
  /** First and last time; default: first and last key. */
  range: {
    kind: 'range',
    default: null,
    flag: 'range',
    value: 'A:B',
    help: 'time range to export; may extend beyond the keys; default: first to last key: --range=-0.3:1.3',
  },
  /** Seconds that the exported animation plays; default: the length of the range. GLB and MDD. */
  duration: {
    kind: 'number',
    above: 0,
    most: MOST_TIME,
    default: null,
    flag: 'duration',
    value: 'SECONDS',
    help: 'length of the exported animation; its times start at 0 and include the keys in the range',
  },
  /** GLB: then backwards, which doubles the duration. */
  bounce: {
    kind: 'flag',
    default: false,
    flag: 'bounce',
    help: 'GLB: play forwards, then backwards (twice as long), for a seamless loop',
  },
  /** One pose only: the shape that the keys blend to, which need not lie on the curve. */
  blend: {
    kind: 'weights',
    default: null,
    flag: 'blend',
    value: 'W,W,...',
    help: 'export one mixture of the keys in shape space instead of the motion: one weight per key, sum 1',
  },
  /** One pose only, at this time: frames, range and duration are ignored. */
  pose: { kind: 'number', least: -MOST_TIME, most: MOST_TIME, default: null, help: 'a single pose at this time' },
  inPlace: { kind: 'flag', default: MOTION.inPlace.default, help: MOTION.inPlace.help },
  /** Name of the files, of the mesh in a GLB and its node; null: 'shapespline'. */
  name: {
    kind: 'text',
    default: null,
    flag: 'name',
    value: 'NAME',
    help: "name of the mesh in a GLB, and of files that belong together; default: the output's name",
  },
} as const satisfies OptionTable;

/** The entries of a table, with the type that every option has. */
export function optionsIn(table: OptionTable): [name: string, option: Option][] {
  return Object.entries(table);
}

/** Default radius of a pin. */
export const PIN_RADIUS = 0.06;

export function defaultsOf<T extends OptionTable>(table: T): ValuesOf<T> {
  const known = optionsIn(table).filter(([, option]) => option.default !== undefined);
  return Object.fromEntries(known.map(([name, option]) => [name, option.default])) as ValuesOf<T>;
}

/** Options whose value is a shape: read from a file, and stored in a special form. */
export type ShapeName = {
  [N in keyof typeof ENCODING]: (typeof ENCODING)[N] extends { kind: 'shape' } ? N : never;
}[keyof typeof ENCODING];
export const SHAPES = optionsIn(ENCODING)
  .filter(([, { kind }]) => kind === 'shape')
  .map(([name]) => name as ShapeName);
