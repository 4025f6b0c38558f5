/** The engine as its users see it. Made by browser.ts (workers) and node.ts (worker threads). */
import type {
  DiscretePath,
  EncodingOptions,
  ExportedFile,
  ExportOptions,
  ExportPlan,
  FaceCurve,
  Frame,
  Ghost,
  ImportOptions,
  InputFile,
  KeyMesh,
  KeysInfo,
  Measures,
  MotionOptions,
  Progress,
  SequenceOptions,
  SequenceStats,
  KeySpacing,
  MotionSpeed,
  PatchCurve,
  ShapePlane,
  Warning,
} from './types.ts';

export interface CallOptions {
  /** Cancels: the promise rejects with code 'cancelled' and everything built so far is unchanged. */
  signal?: AbortSignal;
  onProgress?: (progress: Progress) => void;
}

/** How frames are fetched ahead. */
export interface AheadOptions {
  /** Cancels the request: calls that have not finished reject with code 'cancelled'. */
  signal?: AbortSignal;
}

export interface Engine {
  /** Reads files into keys. Nothing of an earlier import or sequence changes, whatever happens. */
  importKeyframes(files: InputFile[], options?: ImportOptions, call?: CallOptions): Promise<Keys>;
  /** Loads the module for files ahead of the first file. */
  warmFiles(): void;
  /** Keys of poses that are arrays already. Does not load the module for files. */
  createKeys(mesh: KeyMesh, call?: CallOptions): Promise<Keys>;
  /** Takes the keys into a worker of their own, which ends if the call is cancelled. */
  encode(keys: Keys, options?: Partial<EncodingOptions>, call?: CallOptions): Promise<Shape>;
  /** A shape and its one motion. */
  createSequence(keys: Keys, options?: Partial<SequenceOptions>, call?: CallOptions): Promise<Sequence>;
  /** Ends every worker. Idempotent. */
  dispose(): void;
}

/** An import: its poses as arrays independent of any worker, so any number of sequences can use them. */
export interface Keys {
  readonly info: KeysInfo;
  /** 3 x vertices of one key. */
  positions(key: number): Float32Array;
  /** 3 x vertices of the first imported key, from the file; null without normals. */
  normals(): Float32Array | null;
  /** The same keys with some left out, reordered or at other times, without reading a file again. */
  arrange(order: number[], times: number[], names?: string[]): Keys;
  /** Adds one pose (3 x vertices) as a key, kept in order of time. */
  withPose(name: string, time: number, positions: Float32Array): Keys;
  dispose(): void;
}

/** Options and key times of a motion; default: the file's times. */
export type MotionChange = Partial<MotionOptions> & { keyTimes?: number[] };

/** Keys and the spaces of its motions: the costly parts, which do not depend on time and are shared by all motions. */
export interface Shape {
  readonly options: Readonly<EncodingOptions>;
  /**
   * Makes any number of motions. The first in LRI space encodes and factors, which takes a while and can be cancelled.
   * Other methods encode nothing, and factor only what `hold` and pins need.
   */
  motion(options?: MotionChange, call?: CallOptions): Promise<Motion>;
  stats(): Promise<SequenceStats>;
  /** Patch index of each face, -1 for faces without area. */
  patches(): Promise<Int32Array>;
  /** Component of each face, numbered by their first faces; -1 for faces without area. */
  components(): Promise<Int32Array>;
  /** The ghost mesh, or null without one. */
  ghost(): Promise<Ghost | null>;
  /** Ends its motions as well. Idempotent. */
  dispose(): void;
}

/** A motion through a shape's keys. Other options or times need a new motion. */
export interface Motion {
  readonly shape: Shape;
  readonly options: Readonly<SequenceOptions>;
  readonly keyTimes: readonly number[];
  /** First and last time at which the curve is defined by keys; for periodic one whole period. */
  readonly range: readonly [number, number];
  readonly warnings: readonly Warning[];
  /** Latest wins: a request that a newer one overtakes resolves to null. */
  evaluate(t: number): Promise<Frame | null>;
  /**
   * The shape at an affine combination of the keys, which need not lie on the curve: one weight per key, sum 1 within
   * 1e-6. Its `t` is NaN. Takes its place among evaluate's requests: latest wins.
   */
  evaluateBlend(weights: readonly number[]): Promise<Frame | null>;
  /** A frame for later: it yields to evaluate and is never overtaken. FramePlayer uses it. */
  evaluateAhead(t: number, options?: AheadOptions): Promise<Frame>;
  /** Every one of them, in order; used by exports and measures. */
  evaluateMany(times: number[], call?: CallOptions): Promise<Frame[]>;
  measures(times: number[], call?: CallOptions): Promise<Measures>;
  shapePlane(times: number[]): Promise<ShapePlane>;
  /** The minimisation that the spline solves in closed form, over this number of samples (at most 1,000). */
  discretePath(samples: number): Promise<DiscretePath>;
  /** A face's coordinates at these times. */
  faceCurve(face: number, times: number[]): Promise<FaceCurve>;
  /** A patch's coordinates at these times; `patch` as in `patches`. */
  patchCurve(patch: number, times: number[]): Promise<PatchCurve>;
  /** For spacing keys by how different they are, and for tensions that limit overshoot. */
  keySpacing(): Promise<KeySpacing>;
  /** Speed and overshoot over time; yields to frames that are shown or fetched ahead. */
  motionSpeed(times: number[]): Promise<MotionSpeed>;
  bendingEnergy(times: number[]): Promise<number[]>;
  /** 3 x ghost vertices at t; code 'invalid-option' without a ghost mesh. */
  ghostPositions(t: number): Promise<Float32Array>;
  /**
   * Times, size, error and warnings of an export, without making it. A GLB's frames, and times between them, are
   * evaluated for the error; an export with the same options reuses the result.
   */
  planExport(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportPlan>;
  export(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportedFile[]>;
  /** The same files one by one, each made on request. */
  exportFiles(options?: Partial<ExportOptions>, call?: CallOptions): AsyncIterable<ExportedFile>;
  /** Takes no further calls; running ones, such as an export, continue. Idempotent. */
  dispose(): void;
}

/** A shape with one motion, which can be changed. */
export interface Sequence extends Motion, Omit<Shape, 'options' | 'motion'> {
  /** Another motion of the same shape. */
  update(change: MotionChange): Promise<void>;
  /** With its shape. Idempotent. */
  dispose(): void;
}
