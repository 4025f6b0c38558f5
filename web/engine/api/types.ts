/**
 * The engine's public types: plain data only. No DOM, no three.js; the same in the browser and in Node.
 *
 * Times are in seconds or any unit the user likes. Positions are in the unit of the input file. Indices are 0-based.
 */
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, defaultsOf } from './option-table.ts';
import type { AddedTurns, SceneObject, ValuesOf } from './option-table.ts';

/** One dropped or named file. `name` may hold a path relative to the dropped folder; `bytes` are copied, never kept. */
export interface InputFile {
  name: string;
  bytes: Uint8Array;
}

export type { AddedTurns, PathKey, Pin, SceneObject } from './option-table.ts';

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

/** Choices that change the encoding: a new sequence is built for them. */
export type EncodingOptions = ValuesOf<typeof ENCODING>;
export const ENCODING_DEFAULTS: Readonly<EncodingOptions> = defaultsOf(ENCODING);

export type SequenceOptions = EncodingOptions & MotionOptions;
export const SEQUENCE_DEFAULTS: Readonly<SequenceOptions> = { ...ENCODING_DEFAULTS, ...MOTION_DEFAULTS };

export type Method = MotionOptions['method'];
export type Boundary = MotionOptions['boundary'];
export type Hold = MotionOptions['hold'];
export type Stretch = EncodingOptions['stretch'];
/** How the shape follows a ghost mesh (paper section 4.3): through every key, or from the reference's details alone. */
export type Transfer = EncodingOptions['transfer'];
/** Positions of the ghost's vertices: at vertices of the shape, or in each key where the error is least. */
export type Placement = EncodingOptions['placement'];
/** 'exact': coordinates in double precision; the solution is refined on a factor in single precision. */
export type Precision = EncodingOptions['precision'];

/** A warning for the user. `code` is stable. */
export interface Warning {
  code: string;
  message: string;
  /** Number of places; 0 if not applicable. */
  count: number;
  /** The key concerned, or the key that ends the interval concerned; -1 for none. */
  key: number;
  /** A face at the (worst) place; -1 for none. */
  face: number;
  /** The patches that hold the places, numbered as `Sequence.patches` has them. */
  patches: number[];
}

/** For a warning without a place. */
export const NO_PLACE: Readonly<Pick<Warning, 'key' | 'face' | 'patches'>> = { key: -1, face: -1, patches: [] };

/** Place and kind of a failure, for programs; the error's message is for users. */
export interface ErrorPlace {
  file?: string;
  key?: number;
  vertex?: number;
  face?: number;
}

export interface Progress {
  /** The present stage, such as 'reading the file', as text for users. */
  stage: string;
  /** Fraction of the whole work, in [0, 1], never falling. */
  fraction: number;
}

/** Part of the mesh that is drawn with one material. */
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
  /** Drawn without light. */
  unlit: boolean;
  /** Linear RGB. */
  emissive: [number, number, number];
  normalScale: number;
  occlusionStrength: number;
  /** Indices into `images`, or -1; all of them are looked up with `uvs`. */
  baseColorImage: number;
  metallicRoughnessImage: number;
  normalImage: number;
  occlusionImage: number;
  emissiveImage: number;
  wrapS: 'repeat' | 'clamp' | 'mirror';
  wrapT: 'repeat' | 'clamp' | 'mirror';
  /** Sampler parameters, numbered as in glTF (GL_NEAREST is 9728); 0 = the renderer decides. */
  magFilter: number;
  minFilter: number;
}

/** Copies of vertices, for drawing only, where texture coordinates jump between faces that share a vertex. */
export interface Seams {
  /** Drawn vertices 0 to n - 1 are the mesh's own n; n + i is a copy of vertex copyOf[i]. */
  copyOf: Int32Array;
  /** 3 x faces, of drawn vertices. */
  indices: Uint32Array;
}

export interface TextureImage {
  mimeType: string;
  /** The encoded image as in the file. */
  bytes: Uint8Array;
  /** Scale at which it is drawn: below 1 if very large, 0 if not drawn. */
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
  /** Seconds. */
  start: number;
  end: number;
  /** Number of distinct key times. */
  keys: number;
  /** False for a single pose, however many keys it has: keys cannot be sampled from it. */
  moves: boolean;
}

/** How an object of the first key was found in another file. */
export interface MatchedObject {
  /** 0-based: the first key of that file. */
  key: number;
  /** Its name in the first key, and there. */
  object: string;
  found: string;
  by: 'name' | 'shape' | 'order';
}

/** The look of a mesh: everything but its shape. */
export interface Scene {
  /** 2 x drawn vertices, origin at the upper left, or null. */
  uvs: Float32Array | null;
  /** null where the drawn vertices are the mesh's own. */
  seams: Seams | null;
  /** 4 x vertices, linear RGBA, or null. */
  colors: Float32Array | null;
  /** Number of triangles of each polygon of the file, in their order; null if all polygons were triangles. */
  polygons: Int32Array | null;
  groups: MaterialGroup[];
  materials: Material[];
  images: TextureImage[];
  /** In the order of the faces, all of them; empty or absent where the files know no objects. */
  objects?: SceneObject[];
}

/** Poses of one mesh near the origin, y up. Faces and positions are copied. */
export interface KeyMesh {
  /** 3 x faces, of vertices. */
  faces: Uint32Array;
  poses: readonly {
    name: string;
    /** Increasing. */
    time: number;
    /** 3 x vertices. */
    positions: Float32Array;
  }[];
  /** How it looks; default: plain. */
  scene?: Scene | undefined;
}

export type Point = readonly [x: number, y: number, z: number];

/** Report of an import, with everything needed to list and draw its keys. */
export interface KeysInfo {
  names: string[];
  times: number[];
  report: MeshReport;
  warnings: Warning[];
  /** Animations that the input offers, to sample keys from. */
  animations: AnimationInfo[];
  /** Index of the animation that the keys were taken from, or -1. */
  animation: number;
  /** Names of the objects that the first file holds, each once: those that `objects` may name. */
  objects: string[];
  /** Matched objects of different files and the rule of each match; at most a thousand. */
  matches: MatchedObject[];
  /** 3 x faces, of vertices. */
  faces: Uint32Array;
  /**
   * Offset that positions are relative to, in metres with Y up. Zero near the origin; far away, single precision could
   * not distinguish positions. Exports add it.
   */
  offset: Point;
  scene: Scene;
  /** Options that a project file brought along; null for other files. */
  project: Partial<SequenceOptions> | null;
  /** Playback speed of a project file relative to its times; null if not stated. */
  speed: number | null;
  /** Range of key times that a project file plays; null if not stated. */
  played: [number, number] | null;
}

/** The coarse mesh that leads the motion (Fig. 6), and how the shape belongs to it. */
export interface Ghost {
  /** 3 x ghost faces, of ghost vertices. */
  faces: Uint32Array;
  /** For each ghost vertex: the corresponding vertex of the shape. */
  vertexOf: Int32Array;
  /** For each vertex: the ghost vertex that it collapsed to, or -1. */
  ghostVertexOf: Int32Array;
  /** For each face: the ghost face that it follows; -1 without area. */
  ghostFaceOf: Int32Array;
}

export interface SequenceStats {
  encodings: number;
  factorisations: number;
  solves: number;
  patches: number;
  weldedVertices: number;
  components: number;
  /** 0 without a ghost mesh. */
  ghostFaces: number;
  ghostVertices: number;
  /** Number of components too small for a ghost of their own. */
  joinedComponents: number;
  weldMs: number;
  /** Finding faces with area, their neighbours, and components. */
  joinMs: number;
  /** With a ghost mesh: its collapses; the correspondence and its residuals. */
  simplifyMs: number;
  transferMs: number;
  encodeMs: number;
  orderMs: number;
  factorMs: number;
  /** Laying the faces' numbers out in the order of elimination. */
  arrangeMs: number;
  /** Normals, maps to the input's faces, warnings. */
  finishMs: number;
  /** Size of the stored factor, entries and row lists: a solve reads them twice. */
  factorBytes: number;
  /** Of the last exact frame: local frames; splined faces and right-hand side; solve; placing the vertices; normals. */
  localFramesMs: number;
  facesMs: number;
  solveMs: number;
  positionsMs: number;
  normalsMs: number;
  /** For the ghost's own last shape, from the spline to its vertices. */
  ghostMs: number;
  /** Bytes of the wasm heap, which never shrinks, and how many of them are in use. */
  heapBytes: number;
  usedBytes: number;
  /** Threads per exact frame: 2 if that proved faster. */
  threads: 1 | 2;
}

/** One shape of the motion. The arrays belong to the receiver until release() gives them back to the pool. */
export interface Frame {
  t: number;
  /** 3 x vertices, xyz interleaved. */
  positions: Float32Array;
  /** 3 x vertices, unit. */
  normals: Float32Array;
  /** Milliseconds that the worker needed. */
  ms: number;
  /** As in SequenceStats, at the time of the frame. */
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

/** The same from the core; sliding: as a fraction. */
export interface MeasuresAt {
  volume: number[];
  area: number[];
  sliding: (number | null)[];
}

/** How far the keys lie apart in shape space, and the tensions that bound the slope at them. */
export interface KeySpacing {
  /** Between each key and the next, without unit. */
  distance: number[];
  /** Per key, in [0, 1]: the least tension that keeps the slope within three times that of either adjacent chord. */
  tension: number[];
}

/** How the motion goes through shape space: a number for each of the asked times. */
export interface MotionSpeed {
  /** In the unit of KeySpacing.distance, per unit of time. */
  speed: number[];
  /**
   * Overshoot beyond either adjacent key along the line between them, relative to the mean distance of neighbouring
   * keys; 0 between them, and beyond the first and last key.
   */
  overshoot: number[];
}

/** The plane of the two leading principal components (Fig. 2b): 2 numbers per point. */
export interface ShapePlane {
  keys: number[];
  /** 2 numbers per tangent shape there is, that of the start first. */
  tangents: number[];
  curve: number[];
  /** Distance of each point of the curve from the plane, relative to the mean distance between keys. */
  distance: number[];
  /** For each point of the curve: a weight per key, then per tangent shape; they sum to 1. */
  weights: number[];
  /** Share of the keys' variance that the plane holds, in [0, 1]. */
  explained: number;
}

/** Samples that minimise the bending energy with the keys held (Fig. 2), evenly spaced in time. */
export interface DiscretePath {
  times: number[];
  /** For each sample: as in ShapePlane.weights. */
  weights: number[];
  /** 2 numbers per sample, in the shape plane. */
  plane: number[];
  /** Energy of the samples, and of the motion's shapes at the same times. */
  energy: number;
  curveEnergy: number;
}

/**
 * Coordinates of one face over time, 6 numbers per time: the rotation vector relative to its patch, in radians (3), and
 * the stretch, or its logarithm, as xx, xy, yy in the face's plane.
 */
export interface FaceCurve {
  /** That the face belongs to; -1 without area, and the lists are empty then. */
  patch: number;
  numbers: number[];
  /** As `numbers`, of the natural spline through the same keys. */
  natural: number[];
}

/**
 * One patch over time. A row per time: the area mean of tr(S_f) / 2, or of tr(log S_f) / 2 for logarithmic stretch;
 * then for each neighbour j the rotation G^T G_j as a unit quaternion w, x, y, z. In the reference pose every rotation
 * is the identity.
 */
export interface PatchCurve {
  /** Adjacent patches, and those that components are attached to. */
  neighbours: number[];
  numbers: number[];
  /** As `numbers`, of the natural spline through the same keys. */
  natural: number[];
}

export type ExportOptions = ValuesOf<typeof EXPORT>;
export const EXPORT_DEFAULTS: Readonly<ExportOptions> = defaultsOf(EXPORT);

/** Description of an export before it is made. */
export interface ExportPlan {
  /** Times of its frames, in the sequence's unit, increasing for a GLB; empty for a blend. */
  times: number[];
  /** Morph targets of a GLB; 0 elsewhere. */
  targets: number;
  /** Largest distance between playback and motion, relative to the diagonal; null without an animation. */
  error: number | null;
  /** Bytes of all files together, to a few percent. */
  bytes: number;
  warnings: Warning[];
}

export interface ExportedFile {
  name: string;
  bytes: Uint8Array;
}
