/**
 * The engine's public types: plain data only, without DOM or three.js, the same in the browser and in Node.
 *
 * Times are in seconds or any other unit. Positions are in the unit of the input file. Indices are 0-based.
 */
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, defaultsOf } from './option-table.ts';
import type { AddedTurns, SceneObject, ValuesOf } from './option-table.ts';

/** A dropped or named file. `name` may be a path relative to the dropped folder; `bytes` are copied, not kept. */
export interface InputFile {
  name: string;
  bytes: Uint8Array;
}

import type { TimingRegion } from './option-table.ts';
export type { AddedTurns, PathKey, Pin, SceneObject, TimingRegion } from './option-table.ts';

/** Options of an import. */
export type ImportOptions = Partial<ValuesOf<typeof IMPORT>>;
export const IMPORT_DEFAULTS: Readonly<ImportOptions> = defaultsOf(IMPORT);

/** Lists of values per key: numbers, empty or one per key, and turns. */
export type PerKey = {
  -readonly [N in keyof typeof PER_KEY]: (typeof PER_KEY)[N] extends { kind: 'number' } ? number[] : AddedTurns[];
};

/** Options that refit the spline only: they never encode again, and factor only for `hold` and `pins`. */
export type MotionOptions = ValuesOf<typeof MOTION> & PerKey;
const NO_LISTS = Object.fromEntries(Object.keys(PER_KEY).map((name) => [name, []])) as unknown as PerKey;
export const MOTION_DEFAULTS: Readonly<MotionOptions> = { ...defaultsOf(MOTION), ...NO_LISTS };

/** Options that change the encoding and require a new shape or sequence. */
export type EncodingOptions = ValuesOf<typeof ENCODING>;
export const ENCODING_DEFAULTS: Readonly<EncodingOptions> = defaultsOf(ENCODING);

export type SequenceOptions = EncodingOptions & MotionOptions;
export const SEQUENCE_DEFAULTS: Readonly<SequenceOptions> = { ...ENCODING_DEFAULTS, ...MOTION_DEFAULTS };

export type Method = MotionOptions['method'];
export type Boundary = MotionOptions['boundary'];
export type Hold = MotionOptions['hold'];
export type Stretch = EncodingOptions['stretch'];
/**
 * How the shape follows a ghost mesh (paper section 4.3): exactly through every key, or with the reference's details.
 */
export type Transfer = EncodingOptions['transfer'];
/** Positions of the ghost's vertices: at vertices of the shape, or at the least error in each key. */
export type Placement = EncodingOptions['placement'];
/** 'exact': coordinates in double precision. The solution is refined using a factor in single precision. */
export type Precision = EncodingOptions['precision'];

/** A warning for the user. `code` is stable. */
export interface Warning {
  code: string;
  message: string;
  /** Number of locations; 0 if not applicable. */
  count: number;
  /** The key concerned, or the key that ends the interval concerned; -1 for none. */
  key: number;
  /** A face at the (worst) location; -1 for none. */
  face: number;
  /** The patches of all locations, numbered as in `Sequence.patches`. */
  patches: number[];
  /** If the message names keys (`sentences`): how, its start with the keys, and its rest. */
  about?: string;
  start?: string;
  text?: string;
}

/** The location of a warning without a location. */
export const NO_PLACE: Readonly<Pick<Warning, 'key' | 'face' | 'patches'>> = { key: -1, face: -1, patches: [] };

/** Location and kind of a failure, for programs; the error's message is for users. */
export interface ErrorPlace {
  file?: string;
  key?: number;
  vertex?: number;
  face?: number;
}

export interface Progress {
  /** The current stage as text for users, such as 'reading the file'. */
  stage: string;
  /** Completed fraction of the whole work, in [0, 1], never decreasing. */
  fraction: number;
}

/** Part of the mesh with one material. */
export interface MaterialGroup {
  /** First face and number of faces. */
  start: number;
  count: number;
  /** Index into `materials`, or -1 for none. */
  material: number;
  /** Name of a material that an OBJ uses without defining it. */
  name?: string;
}

export interface Material {
  name: string;
  /** Linear RGBA in [0, 1]. */
  baseColor: [number, number, number, number];
  metallic: number;
  roughness: number;
  doubleSided: boolean;
  alphaMode: 'OPAQUE' | 'MASK' | 'BLEND';
  alphaCutoff: number;
  /** Whether the material is drawn without lighting. */
  unlit: boolean;
  /** Emissive colour in linear RGB. */
  emissive: [number, number, number];
  normalScale: number;
  occlusionStrength: number;
  /** Indices into `images`, or -1; all of them use `uvs`. */
  baseColorImage: number;
  metallicRoughnessImage: number;
  normalImage: number;
  occlusionImage: number;
  emissiveImage: number;
  wrapS: 'repeat' | 'clamp' | 'mirror';
  wrapT: 'repeat' | 'clamp' | 'mirror';
  /** Sampler parameters, numbered as in glTF (GL_NEAREST is 9728); 0 = the renderer's choice. */
  magFilter: number;
  minFilter: number;
}

/** Copies of vertices, only for drawing, where texture coordinates jump between faces that share a vertex. */
export interface Seams {
  /** Drawn vertices 0 to n - 1 are the mesh's n vertices; n + i is a copy of vertex copyOf[i]. */
  copyOf: Int32Array;
  /** Indices of drawn vertices, 3 x faces. */
  indices: Uint32Array;
}

export interface TextureImage {
  mimeType: string;
  /** The encoded image as in the file. */
  bytes: Uint8Array;
  /** Drawing scale: below 1 for very large images, 0 if not drawn. */
  scale: number;
}

/** Report of an import; counts are of the input, raw and welded. */
export interface MeshReport {
  vertices: number;
  weldedVertices: number;
  faces: number;
  components: number;
  boundaryEdges: number;
  nonManifoldEdges: number;
  degenerateFaces: number;
  duplicateFaces: number;
  unreferencedVertices: number;
  inconsistentEdges: number;
  /** Length of the bounding box's diagonal over all keys. */
  diagonal: number;
}

export interface AnimationInfo {
  name: string;
  /** Start of the animation in seconds. */
  start: number;
  end: number;
  /** Number of distinct key times. */
  keys: number;
  /** False for a single pose, with any number of key times. Keys cannot be sampled from it. */
  moves: boolean;
  /** Indices of the animations that this entry plays together; empty or absent for a single animation. */
  together?: number[];
}

/** How an object of the first key was found in another file. */
export interface MatchedObject {
  /** 0-based: the first key of that file. */
  key: number;
  /** Its name in the first key, and in that file. */
  object: string;
  found: string;
  by: 'name' | 'shape' | 'order';
}

/** Everything about a mesh's look except its shape. */
export interface Scene {
  /** Texture coordinates, 2 x drawn vertices, origin at the upper left; or null. */
  uvs: Float32Array | null;
  /** null if the drawn vertices are the mesh's own. */
  seams: Seams | null;
  /** Vertex colours, 4 x vertices, linear RGBA; or null. */
  colors: Float32Array | null;
  /** Number of triangles in each polygon of the file, in order; null if all polygons were triangles. */
  polygons: Int32Array | null;
  groups: MaterialGroup[];
  materials: Material[];
  images: TextureImage[];
  /** Covers all faces in order; empty or absent if the files have no objects. */
  objects?: SceneObject[];
}

/** Poses of one mesh near the origin, y up. Faces and positions are copied. */
export interface KeyMesh {
  /** Vertex indices, 3 x faces. */
  faces: Uint32Array;
  poses: readonly {
    name: string;
    /** Times must increase. */
    time: number;
    /** Positions, 3 x vertices. */
    positions: Float32Array;
  }[];
  /** Look of the mesh; default: plain. */
  scene?: Scene | undefined;
}

export type Point = readonly [x: number, y: number, z: number];

/** Report of an import, with everything needed to list and draw its keys. */
export interface KeysInfo {
  names: string[];
  times: number[];
  report: MeshReport;
  warnings: Warning[];
  /** The input's animations, from which keys can be sampled. */
  animations: AnimationInfo[];
  /** Index of the animation that the keys were taken from, or -1. */
  animation: number;
  /** Distinct names of the objects in the first file, which `objects` can name. */
  objects: string[];
  /** Matched objects of different files and the rule of each match; at most a thousand. */
  matches: MatchedObject[];
  /** Vertex indices, 3 x faces. */
  faces: Uint32Array;
  /**
   * Offset that positions are relative to, in metres with Y up. Zero near the origin; far away, single precision would
   * not resolve the shape. Exports add it.
   */
  offset: Point;
  scene: Scene;
  /** Options from a project file; null for other files. */
  project: Partial<SequenceOptions> | null;
  /** Playback speed of a project file relative to its times; null if not specified. */
  speed: number | null;
  /** Range of key times that a project file plays; null if not specified. */
  played: [number, number] | null;
}

/** The coarse mesh that drives the motion (Fig. 6), and its correspondence with the shape. */
export interface Ghost {
  /** Ghost vertex indices, 3 x ghost faces. */
  faces: Uint32Array;
  /** The vertex of the shape that corresponds to each ghost vertex. */
  vertexOf: Int32Array;
  /** The ghost vertex to which each vertex of the shape collapsed, or -1. */
  ghostVertexOf: Int32Array;
  /** The ghost face that each face follows; -1 without area. */
  ghostFaceOf: Int32Array;
}

export interface SequenceStats {
  encodings: number;
  factorisations: number;
  solves: number;
  patches: number;
  weldedVertices: number;
  components: number;
  /** Number of ghost faces; 0 without a ghost mesh. */
  ghostFaces: number;
  ghostVertices: number;
  /** Number of components too small for a separate ghost. */
  joinedComponents: number;
  weldMs: number;
  /** Time for finding faces with area, their neighbours, and components. */
  joinMs: number;
  /** With a ghost mesh: time for the collapses, and for the correspondence and its residuals. */
  simplifyMs: number;
  transferMs: number;
  encodeMs: number;
  orderMs: number;
  factorMs: number;
  /** Time for arranging the faces' data in elimination order. */
  arrangeMs: number;
  /** Time for normals, maps to the input's faces, and warnings. */
  finishMs: number;
  /** Size of the stored factor with entries and row lists. A solve reads it twice. */
  factorBytes: number;
  /**
   * Times of the last frame: local frames; splined faces and right-hand side; solve; vertex positions; normals.
   */
  localFramesMs: number;
  facesMs: number;
  solveMs: number;
  positionsMs: number;
  normalsMs: number;
  /** Time of the ghost's last shape, from the spline to its vertices. */
  ghostMs: number;
  /** Bytes of the wasm heap, which never shrinks, and the bytes in use. */
  heapBytes: number;
  usedBytes: number;
  /** Threads per frame: 2 if that proved faster. */
  threads: 1 | 2;
}

/** A shape of the motion. The receiver owns the arrays until release() returns them to the pool. */
export interface Frame {
  t: number;
  /** Positions, 3 x vertices, xyz interleaved. */
  positions: Float32Array;
  /** Unit normals, 3 x vertices. */
  normals: Float32Array;
  /** Computing time in the worker, in milliseconds. */
  ms: number;
  /** Threads of this frame, as in SequenceStats. */
  threads: 1 | 2;
  /** Faces whose interpolated stretch is not positive definite. */
  indefiniteFaces: number;
  /** One of these faces; absent if unknown. */
  indefiniteFace?: number;
  release(): void;
}

/** Volume and area of the shape at each time. */
export interface Measures {
  times: number[];
  volume: number[];
  area: number[];
  /**
   * Root mean square displacement of vertices that rest between two keys, in % of the largest diagonal of a key. NaN if
   * none rest, and beyond the keys.
   */
  sliding: number[];
}

/** Measures from the core, with sliding as a fraction. */
export interface MeasuresAt {
  volume: number[];
  area: number[];
  sliding: (number | null)[];
}

/** Distances between keys in shape space, and tensions that bound the slope. */
export interface KeySpacing {
  /** Distance between each key and the next; dimensionless. */
  distance: number[];
  /** The least tension per key, in [0, 1], that keeps the slope within three times that of either adjacent chord. */
  tension: number[];
}

/** Motion through shape space: one number per requested time. */
export interface MotionSpeed {
  /** Speed in the unit of KeySpacing.distance per unit of time. */
  speed: number[];
  /**
   * Overshoot beyond either adjacent key along the line between them, relative to the mean distance of neighbouring
   * keys; 0 between them, and beyond the first and last key.
   */
  overshoot: number[];
}

/** Timings as options of a motion. */
export interface Timings {
  earlier: number[];
  swing: number[];
  regions: TimingRegion[];
}

export interface TimingFit {
  /** Empty lists if no timing lowers the error. */
  timings: Timings;
  /**
   * KG errors in percent without and with timing, on this number of frames that a fit to the other frames has not seen;
   * null if every interval has at most one frame.
   */
  unseen: { frames: number; before: number; after: number } | null;
}

/** How a shape changes with the timing of the intervals around its time, for fits. */
export interface TimingDerivatives {
  /** The intervals whose timing has an effect, at most three. */
  intervals: number[];
  /**
   * For each of them and each of `earlier` and `swing`: the derivative of the shape (3 x vertices) by the number of
   * each region, and then by that of the position.
   */
  shapes: Float32Array;
}

/** The plane of the two leading principal components (Fig. 2b): 2 numbers per point. */
export interface ShapePlane {
  keys: number[];
  /** Positions of the tangent poses, 2 numbers each, that of the start first. */
  tangents: number[];
  curve: number[];
  /** Distance of each point of the curve from the plane, relative to the mean distance between keys. */
  distance: number[];
  /** For each point of the curve: weights of the keys, then of the tangent poses; sum 1. Empty for fitted motions. */
  weights: number[];
  /** Share of the keys' variance in the plane, in [0, 1]. */
  explained: number;
}

/** Samples that minimise the bending energy with fixed keys (Fig. 2), evenly spaced in time. */
export interface DiscretePath {
  times: number[];
  /** Weights of each sample, as in ShapePlane.weights. */
  weights: number[];
  /** Positions of the samples in the shape plane, 2 numbers each. */
  plane: number[];
  /** Energy of the samples, and of the motion at the same times. */
  energy: number;
  curveEnergy: number;
}

/**
 * Coordinates of one face over time, 6 numbers per time: the rotation vector relative to its patch, in radians (3), and
 * the stretch, or its logarithm, as xx, xy, yy in the face's plane.
 */
export interface FaceCurve {
  /** Patch of the face; -1 without area, with empty lists. */
  patch: number;
  numbers: number[];
  /** Coordinates like `numbers`, for the natural spline through the same keys. */
  natural: number[];
}

/**
 * One patch over time. A row per time: the area mean of tr(S_f) / 2, or of tr(log S_f) / 2 for logarithmic stretch;
 * then for each neighbour j the rotation G^T G_j as a unit quaternion w, x, y, z. In the reference pose every rotation
 * is the identity.
 */
export interface PatchCurve {
  /** Adjacent patches, and patches of attached components. */
  neighbours: number[];
  numbers: number[];
  /** Coordinates like `numbers`, for the natural spline through the same keys. */
  natural: number[];
}

export type ExportOptions = ValuesOf<typeof EXPORT>;
export const EXPORT_DEFAULTS: Readonly<ExportOptions> = defaultsOf(EXPORT);

/** Description of an export before it is written. */
export interface ExportPlan {
  /** Times of its frames, in the sequence's unit, increasing for a GLB; empty for a blend. */
  times: number[];
  /** Number of morph targets in a GLB; 0 for other formats. */
  targets: number;
  /** Largest distance between playback and motion, relative to the diagonal; null without an animation. */
  error: number | null;
  /** Total bytes of all files, to a few percent. */
  bytes: number;
  warnings: Warning[];
}

export interface ExportedFile {
  name: string;
  bytes: Uint8Array;
}
