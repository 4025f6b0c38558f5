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
  KeyPace,
  MotionPace,
  PatchCurve,
  ShapePlane,
  Warning,
} from './types.ts';

export interface CallOptions {
  /** Cancels: the promise rejects with code 'cancelled' and everything built so far stays as it was. */
  signal?: AbortSignal;
  onProgress?: (progress: Progress) => void;
}

/** How frames are fetched ahead. */
export interface AheadOptions {
  /** Takes the request back: what has not begun rejects with code 'cancelled'. */
  signal?: AbortSignal;
}

export interface Engine {
  /** Reads files into keys. Nothing of an earlier import or sequence changes, whatever happens. */
  importKeyframes(files: InputFile[], options?: ImportOptions, call?: CallOptions): Promise<Keys>;
  /** Loads the module for files ahead of the first file. */
  warmFiles(): void;
  /** Keys of poses that are arrays already. Does not load the module for files. */
  createKeys(mesh: KeyMesh, call?: CallOptions): Promise<Keys>;
  /** Takes the keys into a worker of its own, which ends where the call is cancelled. */
  encode(keys: Keys, options?: Partial<EncodingOptions>, call?: CallOptions): Promise<Shape>;
  /** A shape and its one motion. */
  createSequence(keys: Keys, options?: Partial<SequenceOptions>, call?: CallOptions): Promise<Sequence>;
  /** Ends every worker. Idempotent. */
  dispose(): void;
}

/** An import: its poses as arrays that belong to no worker, so that any number of sequences can be made from them. */
export interface Keys {
  readonly info: KeysInfo;
  /** 3 x vertices of one key. */
  positions(key: number): Float32Array;
  /** 3 x vertices of the first key that was imported, as the file has them; null where it has none. */
  normals(): Float32Array | null;
  /** The same keys with some left out, put in another order or at other times, without reading a file again. */
  arrange(order: number[], times: number[], names?: string[]): Keys;
  /** Adds one pose (3 x vertices) as a key, kept in order of time. */
  withPose(name: string, time: number, positions: Float32Array): Keys;
  dispose(): void;
}

/** What a motion is made with: options, and the times of the keys, which are the file's where none are given. */
export type MotionChange = Partial<MotionOptions> & { keyTimes?: number[] };

/** Keys, and the spaces that its motions are made in: what is costly to make and knows no time. They share it. */
export interface Shape {
  readonly options: Readonly<EncodingOptions>;
  /**
   * As many as are wanted. The first of a method in LRI space encodes and factorises, which takes a while and can be
   * cancelled; of the others nothing is encoded, and nothing factorised but what `hold` and pins need.
   */
  motion(options?: MotionChange, call?: CallOptions): Promise<Motion>;
  stats(): Promise<SequenceStats>;
  /** Patch index of each face, -1 for faces without area. */
  patches(): Promise<Int32Array>;
  /** Component of each face, numbered by their first faces; -1 for faces without area. */
  components(): Promise<Int32Array>;
  /** The ghost mesh, or null without one. */
  ghost(): Promise<Ghost | null>;
  /** Ends its motions, too. Idempotent. */
  dispose(): void;
}

/** A motion through a shape's keys. Another one is made for other options or times. */
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
  /** The minimisation that the spline solves in closed form, done by so many samples (at most 1,000). */
  discretePath(samples: number): Promise<DiscretePath>;
  /** A face's coordinates at these times. */
  faceCurve(face: number, times: number[]): Promise<FaceCurve>;
  /** A patch's coordinates at these times; `patch` as in `patches`. */
  patchCurve(patch: number, times: number[]): Promise<PatchCurve>;
  /** For spacing keys by how different they are, and for tensions that limit overshoot. */
  keyPace(): Promise<KeyPace>;
  /** Speed and overshoot over time; yields to frames that are shown or fetched ahead. */
  motionPace(times: number[]): Promise<MotionPace>;
  bendingEnergy(times: number[]): Promise<number[]>;
  /** 3 x ghost vertices at t; code 'invalid-option' without a ghost mesh. */
  ghostPositions(t: number): Promise<Float32Array>;
  /**
   * Times, size, error and warnings of an export, without making it. A GLB's frames are evaluated for it, those between
   * them, too; an export of the same options that follows need not do that again.
   */
  planExport(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportPlan>;
  export(options?: Partial<ExportOptions>, call?: CallOptions): Promise<ExportedFile[]>;
  /** The same files one by one, each made when it is asked for. */
  exportFiles(options?: Partial<ExportOptions>, call?: CallOptions): AsyncIterable<ExportedFile>;
  /** Takes no further calls; what was asked before, such as an export, goes on. Idempotent. */
  dispose(): void;
}

/** A shape with one motion, which can be changed. */
export interface Sequence extends Motion, Omit<Shape, 'options' | 'motion'> {
  /** Another motion of the same shape. */
  update(change: MotionChange): Promise<void>;
  /** With its shape. Idempotent. */
  dispose(): void;
}
