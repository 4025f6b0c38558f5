/** The engine's public interface, implemented by browser.ts (workers) and node.ts (worker threads). */
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
  TimingDerivatives,
  TimingFit,
  Warning,
} from './types.ts';

export interface CallOptions {
  /** Cancels the call: the promise rejects with code 'cancelled', and all earlier results stay valid. */
  signal?: AbortSignal;
  onProgress?: (progress: Progress) => void;
}

/** Options of frames fetched ahead. */
export interface AheadOptions {
  /** Cancels the request: unfinished calls reject with code 'cancelled'. */
  signal?: AbortSignal;
}

/** Frames of an animation on the timeline of the keys. */
export interface TimedFrames {
  readonly times: readonly number[];
  /** The positions of a frame, 3 x vertices. */
  at(index: number): Float32Array;
}

export interface Engine {
  /** Reads files into keys. Earlier imports and sequences never change. */
  importKeyframes(files: InputFile[], options?: ImportOptions, call?: CallOptions): Promise<Keys>;
  /** Loads the module for files ahead of the first file. */
  warmFiles(): void;
  /** Makes keys from poses given as arrays. Does not load the module for files. */
  createKeys(mesh: KeyMesh, call?: CallOptions): Promise<Keys>;
  /** Makes a shape: copies the keys to a new worker, which ends if the call is cancelled. */
  encode(keys: Keys, options?: Partial<EncodingOptions>, call?: CallOptions): Promise<Shape>;
  /** A shape with one motion. */
  createSequence(keys: Keys, options?: Partial<SequenceOptions>, call?: CallOptions): Promise<Sequence>;
  /**
   * Fits the timing between the keys to the animation from which they were taken: at most this number of regions (16;
   * with 1, the whole shape has one timing), and the position. The motion's own timing, hold, pins and `inPlace` are
   * left out. null if the animation has no frame between the keys. Code 'invalid-option' with another method than LRI.
   */
  fitTiming(
    motion: Motion,
    animation: TimedFrames,
    options?: { regions?: number },
    call?: CallOptions,
  ): Promise<TimingFit | null>;
  /** Ends every worker. Idempotent. */
  dispose(): void;
}

/** An import: its poses as arrays independent of any worker, so any number of sequences can use them. */
export interface Keys {
  readonly info: KeysInfo;
  /** Positions of one key, 3 x vertices. */
  positions(key: number): Float32Array;
  /** Normals of the first imported key, from the file, 3 x vertices; null without normals. */
  normals(): Float32Array | null;
  /** The same keys, with some omitted, reordered or at other times, without reading a file again. */
  arrange(order: number[], times: number[], names?: string[]): Keys;
  /** Adds a pose (3 x vertices) as a key, keeping time order. */
  withPose(name: string, time: number, positions: Float32Array): Keys;
  dispose(): void;
}

/** Options and key times of a motion; default: the file's times. */
export type MotionChange = Partial<MotionOptions> & { keyTimes?: number[] };

/** Keys and the spaces of its motions. The spaces are costly, independent of time, and shared by all motions. */
export interface Shape {
  readonly options: Readonly<EncodingOptions>;
  /**
   * Makes any number of motions. The first motion in LRI space encodes and factors; this is slow and can be cancelled.
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
  /** Renames the keys, one name per key. Later exports of its motions have these names. */
  rename(names: string[]): void;
  /** Ends its motions as well. Idempotent. */
  dispose(): void;
}

/** A motion through a shape's keys. Other options or times need a new motion. */
export interface Motion {
  readonly shape: Shape;
  readonly options: Readonly<SequenceOptions>;
  readonly keyTimes: readonly number[];
  /** First and last time of the curve that the keys define; one whole period for a periodic motion. */
  readonly range: readonly [number, number];
  readonly warnings: readonly Warning[];
  /**
   * For each interval between keys, whether its shapes were fitted; elsewhere the motion is that of another method, and
   * a warning says so. null if the motion fits no shapes.
   */
  readonly fitted: readonly boolean[] | null;
  /** Latest wins: a newer request resolves a waiting one to null. */
  evaluate(t: number): Promise<Frame | null>;
  /**
   * The shape at an affine combination of the keys, which may lie off the curve: one weight per key, sum 1 within 1e-6.
   * Its `t` is NaN. Queued with evaluate's requests: latest wins.
   */
  evaluateBlend(weights: readonly number[]): Promise<Frame | null>;
  /** A frame for later. It has lower priority than evaluate and is never skipped. FramePlayer uses it. */
  evaluateAhead(t: number, options?: AheadOptions): Promise<Frame>;
  /** All frames in order, for exports and measures. */
  evaluateMany(times: number[], call?: CallOptions): Promise<Frame[]>;
  measures(times: number[], call?: CallOptions): Promise<Measures>;
  shapePlane(times: number[]): Promise<ShapePlane>;
  /**
   * The discrete form of the minimisation that the spline solves in closed form, with this number of samples (at most
   * 1,000).
   */
  discretePath(samples: number): Promise<DiscretePath>;
  /** A face's coordinates at these times. */
  faceCurve(face: number, times: number[]): Promise<FaceCurve>;
  /** A patch's coordinates at these times; `patch` as in `patches`. */
  patchCurve(patch: number, times: number[]): Promise<PatchCurve>;
  /** Distances for spacing keys by pose difference, and tensions that limit overshoot. */
  keySpacing(): Promise<KeySpacing>;
  /** Speed and overshoot over time. Has lower priority than shown frames and frames fetched ahead. */
  motionSpeed(times: number[]): Promise<MotionSpeed>;
  bendingEnergy(times: number[]): Promise<number[]>;
  /**
   * Bending energy by edge lengths and dihedral angles, the same measure for every method: the squared second
   * derivative in the metric of shells, relative to the mean squared change between keys, in the unit of bendingEnergy.
   * Uses second differences over a 24th of the range. Shapes with more than 1,000 faces are measured on a coarse mesh
   * of about 1,000 faces between some of their vertices. NaN where an edge of that mesh has no length. Takes three
   * shapes per time; the first call for a large shape also makes its coarse mesh.
   */
  shellBending(times: number[], call?: CallOptions): Promise<number[]>;
  /**
   * How the shape at t, a time between the keys, changes with the timing of the intervals around it. `regionOf`: the
   * region of each patch, numbered from 0. Without hold, pins and the motion's own regions; code 'invalid-option' with
   * another method than LRI or a ghost mesh.
   */
  timingDerivatives(t: number, regionOf: number[]): Promise<TimingDerivatives>;
  /** Positions of the ghost mesh at t, 3 x ghost vertices; code 'invalid-option' without a ghost mesh. */
  ghostPositions(t: number): Promise<Float32Array>;
  /**
   * Times, size, error and warnings of an export, without writing it. For a GLB, the error is evaluated at its frames
   * and at times between them. An export with the same options reuses the result.
   */
  planExport(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportPlan>;
  export(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportedFile[]>;
  /** The files of the plan, each made on request. */
  exportFiles(options?: Partial<ExportOptions>, call?: CallOptions): AsyncIterable<ExportedFile>;
  /** Refuses further calls; running calls, such as an export, continue. Idempotent. */
  dispose(): void;
}

/** A shape with one changeable motion. */
export interface Sequence extends Motion, Omit<Shape, 'options' | 'motion' | 'rename'> {
  /** Replaces the motion by a new one of the same shape. */
  update(change: MotionChange): Promise<void>;
  /** Also disposes of the shape. Idempotent. */
  dispose(): void;
}
