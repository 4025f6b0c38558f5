/**
 * Every option of the engine, described once: allowed values, default, command-line flag, name in the page. The
 * following are derived from these tables: types and defaults (types.ts), checks (options.ts), project files, the
 * command line with its help, the page's document with links and CSV, bounds of the page's
 * controls (their words: `web/model/option-words`), and OPTIONS.md. Plain data without imports.
 */

/** Largest absolute time. Differences of 1e-6 are still representable at this time. */
export const MAX_TIME = 1e9;
export const MAX_EXPORTED_FRAMES = 100_000;
export const MAX_KEYS = 10_000;
/** Limit for pins, and for keys of a pin's path. */
export const MAX_PINS = 100;
export const MAX_PATH_KEYS = 1000;
/** Number of regions that a fit gives timings of their own. */
export const FITTED_REGIONS = 16;
/** Limits for regions with timings of their own, and for all their numbers. */
export const MAX_REGIONS = 64;
export const MAX_REGION_NUMBERS = 100_000;
/** Upper bound on added turns. */
export const MAX_TURNS = 100;
/** Upper bound on slopes, relative to the default slope at a key. */
const MAX_SLOPE = 1000;

/**
 * Full turns added between a key and the previous one: of the whole shape, or of a component relative to its parent.
 */
export interface AddedTurns {
  /** Index of the key, 0-based and at least 1. */
  key: number;
  /** Negative numbers turn in the opposite direction. */
  turns: number;
  /** 0-based, counted by the components' first faces in the file; absent: the whole shape. */
  component?: number;
}

/** A key of a pin's path. */
export interface PathKey {
  time: number;
  /** Offset from the pin's position without a path, in the unit of the positions. */
  move: [x: number, y: number, z: number];
}

/** Vertices held by the user, around one vertex of the mesh. They follow their own splines unless `stay` is set. */
export interface Pin {
  /** Index of the vertex in the file, 0-based. */
  vertex: number;
  /** Radius of the held ball, relative to the size of the shape; 0: the patch at the vertex. */
  radius: number;
  /** Index of the key whose positions the vertices keep, 0-based. */
  stay?: number;
  /** Offsets over time, in increasing order. */
  path?: PathKey[];
}

/** Faces with a timing of their own. A face in several regions belongs to the first. */
export interface TimingRegion {
  /** Runs of faces of the file: first face and number of faces, in turn. Empty: the mean position of the shape. */
  faces: number[];
  /** As the options `earlier` and `swing`: empty, or one number per key. */
  earlier: number[];
  swing: number[];
  /** Whether the timing blends over two rings of patches around the border of the region. */
  soft: boolean;
}

/** An object's range of faces. */
export interface SceneObject {
  /** Generated if the file has no name. */
  name: string;
  /** First face and number of faces. */
  start: number;
  count: number;
  /** Names from the file, or empty: of the node, its mesh, and the node's ancestors. */
  nodeName: string;
  meshName: string;
  path: string;
  /** OBJ: a group (g), not an object (o). */
  isGroup: boolean;
}

/** Value types, for kinds that determine them. */
interface Values {
  number: number;
  flag: boolean;
  /** An index of a key, which the command line counts from 1. */
  key: number;
  /** The positions of a shape, 3 x vertices: a file on the command line, base64 in a project. */
  shape: Float32Array;
  turns: AddedTurns[];
  pins: Pin[];
  regions: TimingRegion[];
  numbers: number[];
  /** One weight per key, sum 1. */
  weights: number[];
  /** First and last number of a range. */
  range: [number, number];
  /** Name or index of an animation. */
  animation: string | number;
  /** Increasing times, or the number of evenly spaced ones. */
  sample: number[] | number;
  /** Vertex indices of faces, 3 x faces. */
  faces: Uint32Array;
  point: readonly [x: number, y: number, z: number];
  objects: SceneObject[];
  names: string[];
  text: string;
}

interface Described {
  /** Text of the command-line help and OPTIONS.md. */
  help: string;
  /** The flag on the command line without dashes, and the placeholder of its value. */
  flag?: string;
  value?: string;
  /** The name in the page's document and in links. Absent if the page does not offer the option. */
  page?: string;
}

export interface NumberOption extends Described {
  kind: 'number';
  /** The default. null: the value can be null. Absent: the value can be absent. */
  default?: number | null;
  whole?: true;
  /** An option per key that belongs to the interval after the key. */
  ofInterval?: true;
  /** Bounds of every number; `above` is an exclusive lower bound. */
  above?: number;
  min?: number;
  max: number;
  /** The word for 0 on the command line. 0 is allowed even if it is outside the range. */
  zero?: string;
}

export interface ChoiceOption extends Described {
  kind: 'choice';
  choices: readonly string[];
  /** Former names of choices, still accepted in links, projects and commands. */
  formerly?: Readonly<Record<string, string>>;
  default?: string;
}

export interface OtherOption extends Described {
  kind: Exclude<keyof Values, 'number'>;
  default?: null | boolean | number | readonly never[];
  /** For lists: requires at least one entry; and the largest number of entries. */
  some?: true;
  max?: number;
}

export type Option = NumberOption | ChoiceOption | OtherOption;
export type OptionTable = Readonly<Record<string, Option>>;
/** An option per key: a number, or full turns. */
export type KeyOption = (NumberOption & { default: number }) | (OtherOption & { kind: 'turns' });

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
    choices: ['lri', 'geodesic', 'linear', 'cubic-vertex', 'rotation-strain', 'rimd', 'lengths', 'shell'],
    default: 'lri',
    flag: 'method',
    help: "lri (default) is the paper's method; the others are for comparison",
    page: 'method',
  },
  hold: {
    kind: 'choice',
    choices: ['off', 'on'],
    formerly: { contact: 'on', anchored: 'on' },
    default: 'off',
    flag: 'hold',
    help: 'on holds in place the vertices that hardly move between two keys; off (default) holds none, as in the paper',
    page: 'hold',
  },
  /** The user's pins, for the method 'lri'. A vertex in several pins belongs to the first. */
  pins: {
    kind: 'pins',
    max: MAX_PINS,
    default: [],
    flag: 'pin',
    value: 'VERTEX[:RADIUS][:stay=KEY][:path=T/X/Y/Z,...]',
    help:
      'pin the vertices within RADIUS of VERTEX (0-based index in the file). RADIUS is relative to the size of the shape ' +
      '(default: 0.06), or the word patch for the patch of VERTEX. Pinned vertices follow their own splines or stay as in ' +
      'KEY, and are offset by X, Y, Z at time T. Repeatable',
    page: 'pins',
  },
  /** For the method 'lri': parts of the shape with timings of their own, set by hand or by a fit. */
  regions: {
    kind: 'regions',
    max: MAX_REGIONS,
    default: [],
    help: 'method lri: parts of the shape with timings of their own; see --fit-timing',
    page: 'regions',
  },
  boundary: {
    kind: 'choice',
    choices: ['natural', 'hermite', 'periodic'],
    default: 'natural',
    flag: 'boundary',
    help: 'natural (default) has no bending at the ends, hermite has the speeds --start-speed and --end-speed there, periodic is a loop',
    page: 'boundary',
  },
  /** Hermite: factor of the one-sided difference at the first key; 0 = ease. */
  startSpeed: {
    kind: 'number',
    min: -MAX_SLOPE,
    max: MAX_SLOPE,
    default: 1,
    flag: 'start-speed',
    value: 'S',
    help: 'speed at the first key (boundary hermite), relative to the mean speed between the first two keys; 0 eases in; default: 1',
    page: 'startSpeed',
  },
  /** Hermite: factor of the one-sided difference at the last key; 0 = ease. */
  endSpeed: {
    kind: 'number',
    min: -MAX_SLOPE,
    max: MAX_SLOPE,
    default: 1,
    flag: 'end-speed',
    value: 'S',
    help: 'speed at the last key (boundary hermite), relative to the mean speed between the last two keys; 0 eases out; default: 1',
    page: 'endSpeed',
  },
  /** Periodic: length of the period in units of time; null = the default. */
  period: {
    kind: 'number',
    above: 0,
    max: MAX_TIME,
    default: null,
    flag: 'period',
    value: 'P',
    help:
      'length of one period in seconds (boundary periodic); default: from the first to the last key if their poses are ' +
      'equal, otherwise one mean interval longer',
    page: 'period',
  },
  /**
   * Number of shapes between two neighbouring keys that are fitted to splined edge lengths and angles, for the method
   * 'lri'. They depend on the key times, so this is an option of the motion.
   */
  keepLengths: {
    kind: 'number',
    whole: true,
    min: 0,
    max: 3,
    default: 0,
    flag: 'keep-lengths',
    value: 'N',
    help: 'method lri: fit this number of shapes (0 to 3) between neighbouring keys so that edges keep their lengths; default: 0',
    page: 'keepLengths',
  },
  /** Largest number of faces of the mesh whose lengths are fitted. */
  spaceFaces: {
    kind: 'number',
    whole: true,
    min: 4,
    max: 2000,
    default: 1000,
    flag: 'space-faces',
    value: 'N',
    help: 'largest number of faces of the fitted mesh (methods lengths and shell, and --keep-lengths); default: 1,000',
    page: 'spaceFaces',
  },
  /** Number of intervals between the times of the fitted shapes. Each interval between keys has at least two. */
  spaceSamples: {
    kind: 'number',
    whole: true,
    min: 1,
    max: 100,
    default: 24,
    flag: 'space-samples',
    value: 'K',
    help: 'methods lengths and shell: fit shapes at K + 1 times or more, one between two keys; default: 24',
    page: 'spaceSamples',
  },
  /** Removes the translation that accumulates along the sequence. */
  inPlace: { kind: 'flag', default: false, flag: 'in-place', help: 'remove the overall translation' },
} as const satisfies OptionTable;

/**
 * Options per key, which refit the spline only. In the page's document, each key stores its values. The engine takes
 * lists of numbers (empty, or one per key) and of turns.
 */
export const PER_KEY = {
  /** Slope at the key = (1 - tension) times the C2 spline's own. */
  tension: {
    kind: 'number',
    min: -MAX_SLOPE,
    max: MAX_SLOPE,
    default: 0,
    flag: 'tension',
    value: 'X,X,...',
    help: 'one number per key; 0 keeps the smooth slope, 1 stops at the key',
  },
  /** Above 0, the slope follows the interval before the key more; below 0, the interval after it. */
  bias: {
    kind: 'number',
    min: -1,
    max: 1,
    default: 0,
    flag: 'bias',
    value: 'X,X,...',
    help:
      'one number per key, -1 to 1. Above 0, the slope follows the interval before the key more; below 0, the interval ' +
      'after it',
  },
  /** Lets the motion pass the middle of the interval after the key earlier, in intervals at the speed there. */
  earlier: {
    kind: 'number',
    ofInterval: true,
    min: -1,
    max: 1,
    default: 0,
    flag: 'earlier',
    value: 'X,X,...',
    help:
      'method lri: one number per key for the interval after it, -1 to 1. Above 0, the motion is ahead there; below 0, it ' +
      'is behind. The last number counts in a loop only',
  },
  /** How far the motion swings out in the interval after the key, off the mean of both keys. */
  swing: {
    kind: 'number',
    ofInterval: true,
    min: -3,
    max: 3,
    default: 0,
    flag: 'swing',
    value: 'X,X,...',
    help:
      'method lri: one number per key for the interval after it, -3 to 3; -1 is straight in the middle, 0 as the spline, ' +
      '1 swings out twice as far. The last number counts in a loop only',
  },
  /** Full turns added between the previous key and this one. */
  turns: {
    kind: 'turns',
    flag: 'turns',
    value: 'KEY:N[@COMPONENT],...',
    help:
      'add N full turns between the previous key and KEY, to the whole shape or to COMPONENT (1-based; components are ' +
      'counted in the order of their faces in the file)',
  },
} as const satisfies Readonly<Record<string, KeyOption>>;

/** Options that change the encoding and require a new shape or sequence. */
export const ENCODING = {
  /** Index of the key that deformation gradients are measured from, 0-based. */
  reference: {
    kind: 'key',
    default: 0,
    flag: 'reference',
    value: 'KEY',
    help: 'key from which deformations are measured; default: 1',
    page: 'referencePose',
  },
  /** Approximate number of patches; 0 = the default formula. */
  patches: {
    kind: 'number',
    whole: true,
    min: 0,
    max: 100_000,
    default: 0,
    flag: 'patches',
    value: 'N',
    help: 'number of patches; default: about the square root of the number of faces',
    page: 'patches',
  },
  stretch: {
    kind: 'choice',
    choices: ['linear', 'log'],
    default: 'linear',
    flag: 'stretch',
    help: 'interpolation of the stretch: linear (default, as in the paper), or log, with which faces cannot turn inside out',
    page: 'stretch',
  },
  /**
   * Number of faces of a ghost mesh, at least 4, or 0 for none. The motion is computed on the ghost mesh and
   * transferred to the shape.
   */
  ghostFaces: {
    kind: 'number',
    whole: true,
    min: 4,
    max: 16_000_000,
    zero: 'off',
    default: 0,
    flag: 'ghost-faces',
    value: 'N|off',
    help: 'compute the motion on a simplified mesh (ghost mesh) of about N faces and transfer it to the shape; default: off',
    page: 'ghostFaces',
  },
  /** This option requires a ghost mesh. */
  transfer: {
    kind: 'choice',
    choices: ['exact', 'paper'],
    default: 'exact',
    flag: 'transfer',
    help: 'with a ghost mesh: exact (default) passes through every key, paper transfers as in the paper',
    page: 'transfer',
  },
  placement: {
    kind: 'choice',
    choices: ['vertices', 'optimal'],
    default: 'vertices',
    flag: 'placement',
    help: "vertices (default) puts the ghost mesh's vertices on vertices of the shape, optimal where the error is smallest",
    page: 'placement',
  },
  precision: {
    kind: 'choice',
    choices: ['single', 'exact'],
    formerly: { double: 'exact' },
    default: 'single',
    flag: 'precision',
    help: 'exact uses double-precision coordinates and refines the solution to that precision; default: single',
  },
  /** Hermite: a shape that replaces the neighbouring key in the difference at that end. */
  startTangent: {
    kind: 'shape',
    default: null,
    flag: 'start-tangent',
    value: 'FILE',
    help: 'pose toward which the motion leaves the first key (boundary hermite); default: the second key',
    page: 'startTangentPose',
  },
  endTangent: {
    kind: 'shape',
    default: null,
    flag: 'end-tangent',
    value: 'FILE',
    help: 'pose from which the motion arrives at the last key (boundary hermite); default: the key before the last',
    page: 'endTangentPose',
  },
} as const satisfies OptionTable;

/** Default number of evenly spaced keys from an animation. */
export const SAMPLED_KEYS = 8;
/** Limit for keys from an animation in the page, as more are indistinguishable on a timeline. */
export const MAX_SAMPLED = 64;

/** Options of an import. */
export const IMPORT = {
  /** Key times; default: the animation's own, or else one second apart. */
  keyTimes: {
    kind: 'numbers',
    max: MAX_KEYS,
    flag: 'key-times',
    value: 'T,T,...',
    help: "times of the keys in seconds; default: the animation's own, or one second apart",
  },
  /**
   * Name or index of the animation to sample keys from, or 'all' for all of them at once. Default: the first one that
   * moves, with those that belong to it.
   */
  animation: {
    kind: 'animation',
    flag: 'animation',
    value: 'NAME|INDEX|all',
    help:
      'take the keys from this animation of the file, or from all of them at once if no two move the same part; default: ' +
      'the first animation that moves, with those of other objects that have its name, or its start and length',
  },
  /** Times on the animation's own timeline, in seconds, or the number of evenly spaced ones; default 8. */
  sample: {
    kind: 'sample',
    max: MAX_KEYS,
    flag: 'sample',
    value: 'T,T,...|N',
    help:
      `take the keys at these times in seconds, or at N evenly spaced frames (default: ${SAMPLED_KEYS}). PC2 and MDD files ` +
      'and numbered .obj or .ply files work too; numbered files count as 24 frames per second',
  },
  /** Every frame of the animation becomes a key. */
  everyFrame: { kind: 'flag', flag: 'every-frame', help: 'use every frame of the animation as a key' },
  /** Axis that points up in OBJ, PLY and OFF files; glTF is always y. Default 'y'. */
  up: {
    kind: 'choice',
    choices: ['y', 'z'],
    default: 'y',
    flag: 'up',
    help: 'up axis of .obj, .ply and .off files; default: y',
  },
  /** Metres per unit of OBJ, PLY and OFF files. Default 1. */
  unit: {
    kind: 'number',
    min: 1e-9,
    max: 1e9,
    default: 1,
    flag: 'unit',
    value: 'METRES',
    help: 'metres per unit of .obj, .ply and .off files; default: 1',
  },
  /** Names of objects in the files; default: all of them. */
  objects: {
    kind: 'names',
    some: true,
    flag: 'object',
    value: 'NAME',
    help: 'use only this object of the files; repeatable; default: all objects',
  },
  /**
   * Vertex indices of the mesh that the files must match, 3 x faces. The files' polygons are triangulated like this
   * mesh.
   */
  like: {
    kind: 'faces',
    help: 'faces of the mesh that the files must match; polygons in the files are triangulated as in this mesh',
  },
  /** Positions of the mesh given by `like` in any pose, 3 x vertices. The keys then use the vertices of this mesh. */
  likePose: {
    kind: 'shape',
    help: 'positions of the mesh given by `like`; the keys then use its vertices, even if the files split them differently',
  },
  /** `info.offset` of the keys that these poses belong to; default: zero, or the middle of a far shape. */
  offset: {
    kind: 'point',
    help: 'offset to subtract from positions before rounding to single precision. For added poses, give the offset of the keys. Default: zero, or the middle of a shape far from the origin',
  },
  /** `scene.objects` of the mesh given by `like`, for matching the files' objects. */
  likeObjects: {
    kind: 'objects',
    help: "`scene.objects` of the mesh given by `like`, to match the files' objects",
  },
} as const satisfies OptionTable;

/** Default frames of an export without a number of frames or a tolerance. */
export const USUAL_FRAMES = 60;

export const EXPORT = {
  format: {
    kind: 'choice',
    choices: ['glb', 'obj', 'ply', 'pc2', 'mdd'],
    default: 'glb',
    help: 'glb: one file with an animation; obj, ply: one file per shape; pc2, mdd: a point cache with one OBJ',
  },
  /** Times that replace frames and range, in any order. A GLB also includes the keys between them. */
  times: {
    kind: 'numbers',
    some: true,
    max: MAX_EXPORTED_FRAMES,
    default: null,
    flag: 'at',
    value: 'T,T,...',
    help: 'times to export, in seconds. They may be beyond the keys, for example --at=-0.3,1.3',
  },
  /** Evenly spaced frames over the range. A GLB also includes the keys in the range, to pass through them. */
  frames: {
    kind: 'number',
    whole: true,
    min: 2,
    max: MAX_EXPORTED_FRAMES,
    default: null,
    flag: 'frames',
    value: 'K',
    help: `number of evenly spaced times; default: ${USUAL_FRAMES}, or for a GLB, as few as --tolerance allows`,
  },
  /**
   * Whole frames of the motion's time, or of the exported time if a duration is given. A GLB omits frames within the
   * tolerance.
   */
  fps: {
    kind: 'number',
    min: 0.01,
    max: 1000,
    default: null,
    flag: 'fps',
    value: 'F',
    help: 'frames per second; frames are at multiples of 1/F seconds of the motion (or of the exported animation, with --duration); a GLB also has the times of the keys',
  },
  /**
   * Largest error of a vertex in GLB playback, in percent of the bounding box's diagonal. Without it, every frame is
   * written.
   */
  tolerance: {
    kind: 'number',
    min: 0.0001,
    max: 100,
    zero: 'off',
    default: 0.1,
    flag: 'tolerance',
    value: 'PERCENT|off',
    help: "in a GLB, leave out frames that linear playback reproduces within this error, in % of the model's size; off writes every frame; default: 0.1",
  },
  /** 'principal': blends the keys and a few corrections, instead of one target per time. */
  targets: {
    kind: 'choice',
    choices: ['frames', 'principal'],
    default: 'frames',
    flag: 'targets',
    help: 'morph targets of a GLB: with frames (default), one per exported time; with principal, one per key and a few corrections, which the animation blends',
  },
  compression: {
    kind: 'choice',
    choices: ['none', 'quantized', 'meshopt'],
    default: 'none',
    flag: 'compression',
    help: 'coordinates of a GLB: with quantized, 16 bits each (KHR_mesh_quantization); with meshopt, also compressed (EXT_meshopt_compression); default: none',
  },
  /** First and last time; default: first and last key. */
  range: {
    kind: 'range',
    default: null,
    flag: 'range',
    value: 'A:B',
    help: 'time range to export, in seconds; default: first to last key. It may extend beyond the keys, for example --range=-0.3:1.3',
  },
  /** Duration of the exported animation in seconds; default: the length of the range. GLB and MDD. */
  duration: {
    kind: 'number',
    above: 0,
    max: MAX_TIME,
    default: null,
    flag: 'duration',
    value: 'SECONDS',
    help: 'length of the animation in a GLB or MDD, in seconds; it then starts at 0, and a GLB also has a frame at every key in the range',
  },
  /** GLB: appends the motion in reverse, which doubles the duration. */
  bounce: {
    kind: 'flag',
    default: false,
    flag: 'bounce',
    help: 'in a GLB, play forwards, then backwards (twice as long), for a seamless loop',
  },
  /** Exports only one pose: a blend of the keys, which may lie off the curve. */
  blend: {
    kind: 'weights',
    default: null,
    flag: 'blend',
    value: 'W,W,...',
    help: 'export one mixture of the keys in shape space, instead of the motion; one weight per key, sum 1',
  },
  /** Exports only the pose at this time; frames, range and duration are ignored. */
  pose: {
    kind: 'number',
    min: -MAX_TIME,
    max: MAX_TIME,
    default: null,
    help: 'export only the pose at this time in seconds; frames, range and duration are ignored',
  },
  inPlace: { kind: 'flag', default: MOTION.inPlace.default, help: MOTION.inPlace.help },
  /** Name of the files, and of the mesh and node in a GLB; null: 'shapespline'. */
  name: {
    kind: 'text',
    default: null,
    flag: 'name',
    value: 'NAME',
    help: "name of the mesh in a GLB, and of files next to the output; default: the output's name",
  },
  clip: {
    kind: 'text',
    default: null,
    flag: 'clip',
    value: 'NAME',
    help: 'name of the animation in a GLB; default: that of the animation that the keys were taken from, else that of the mesh',
  },
} as const satisfies OptionTable;

/** The entries of a table, with the common option type. */
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
