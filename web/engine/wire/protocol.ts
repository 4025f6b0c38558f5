/**
 * Messages between the engine and its workers: plain data, one union in each direction. A worker answers every request
 * exactly once, in order, and reports progress in between.
 */
import type { QueryResult, QueryInput, QUERIES, QueryName } from './calls.ts';
import type { SharedOrder } from './shared-order.ts';
import type { ErrorData } from '../api/errors.ts';
import type {
  EncodingOptions,
  ExportOptions,
  ImportOptions,
  InputFile,
  KeysInfo,
  MeshReport,
  MotionOptions,
  Point,
  Scene,
  SequenceStats,
  Warning,
} from '../api/types.ts';

/** An import: its public description and its poses, which all sequences share. Immutable. */
export interface KeyData {
  info: KeysInfo;
  /** Positions of each key, 3 x vertices. */
  positions: readonly Float32Array[];
  /** Normals of the first key as in the file, 3 x vertices; or null. */
  normals: Float32Array | null;
  /** For a derived shape: the user's key at or after each key. */
  userKeys?: readonly number[];
}

/** The motion of a request. A worker without a motion of this number makes it. */
export interface MotionSpec {
  readonly number: number;
  readonly options: MotionOptions;
  readonly keyTimes: readonly number[];
}

/** The core's description of a motion. */
export interface MotionState {
  range: [number, number];
  warnings: Warning[];
}

/** Two arrays of 3 x vertices, reused or new. */
export interface FrameBuffers {
  positions: Float32Array;
  normals: Float32Array;
}

export interface FrameData extends FrameBuffers {
  ms: number;
  threads: 1 | 2;
  indefiniteFaces: number;
  indefiniteFace?: number;
}

export type Compression = ExportOptions['compression'];

/** Request and result of queries about the shape or one of its motions. */
type Queries = {
  [N in QueryName]: {
    request: QueryInput<N> & ((typeof QUERIES)[N]['of'] extends 'motion' ? { motion: MotionSpec } : object);
    result: QueryResult<N>;
  };
};

/** Calls of a worker with the core. */
export interface CoreCalls extends Omit<Queries, 'stats'> {
  /** Checks keys that were not read from files. */
  report: {
    request: Pick<KeysInfo, 'names' | 'faces' | 'times'> & Omit<KeyData, 'info'>;
    result: { report: MeshReport };
  };
  /** Makes the worker's shape. */
  encode: { request: CoreCalls['report']['request'] & { encoding: EncodingOptions }; result: null };
  /** Finds the elimination order of LRI space in another worker. */
  order: { request: CoreCalls['encode']['request'] & { order: SharedOrder }; result: null };
  /** `order`: where another worker stores the elimination order (shared-order) if LRI space is made; or null. */
  motion: { request: { motion: MotionSpec; order: SharedOrder | null }; result: MotionState };
  /** Releases the motion. */
  drop: { request: { motion: MotionSpec }; result: null };
  evaluate: { request: { motion: MotionSpec; t: number; buffers: FrameBuffers | null }; result: FrameData };
  /** The shape at an affine combination of the keys. */
  blend: { request: { motion: MotionSpec; weights: number[]; buffers: FrameBuffers | null }; result: FrameData };
  stats: { request: object; result: SequenceStats };
}

/** Calls of a worker with the module for files. */
export interface FileCalls {
  import: { request: { files: InputFile[]; options: ImportOptions }; result: KeyData };
  /** Estimated bytes of an animated GLB, to a few percent, without the images; and the vertices of its primitives. */
  glbSize: {
    request: { faces: Uint32Array; vertices: number; frames: number; scene: Scene };
    result: { bytes: number; vertices: number };
  };
  /** Leading components of offsets (3 x vertices each): the fewest whose weighted sums are within the tolerance. */
  principalOffsets: {
    request: { frames: Float32Array[]; tolerance: number; max: number };
    result: { count: number; offsets: Float32Array; weights: Float32Array; largest: number };
  };
  /** Adds a frame of the animation to write: first the shown frames, then the stills. */
  addFrame: { request: FrameBuffers; result: null };
  writeAnimation: {
    request: {
      faces: Uint32Array;
      scene: Scene;
      seconds: number[];
      stills: number;
      /** One row per time with a weight per target; null: each target is shown alone at its time. */
      weights: Float32Array | null;
      project: string;
      /** Offset of all positions, stored as the node's translation. */
      offset: Point;
      name: string;
      /** Name of the animation. */
      clip: string;
      targetNames: string[];
      compression: Compression;
    };
    result: Uint8Array;
  };
  writePose: {
    request: {
      format: 'glb' | 'obj' | 'ply';
      faces: Uint32Array;
      scene: Scene;
      pose: FrameBuffers;
      /** The material file of an OBJ, '' for none, and the names of its materials. */
      library: { file: string; names: string[] };
      /** Offset of all positions; `local`: an OBJ states it in a comment instead of adding it. */
      offset: Point;
      local: boolean;
    };
    result: Uint8Array;
  };
}

/** Calls of a worker with the module for fitted motions. */
export interface ShellCalls {
  fitShells: {
    request: {
      method: 'lengths' | 'shell';
      faces: Uint32Array;
      keys: Float32Array[];
      /** In increasing time. `key`: the key at this time, or -1; `weights` of the keys and `start`: null at a key. */
      samples: { time: number; weights: Float64Array | null; start: Float32Array | null; key: number }[];
    };
    /**
     * `failed`: intervals without a fit, by their last key. `stiff`: those where the bending energy could not be
     * lowered. `finished`: false if the search for the least bending energy ended early.
     */
    result: { shapes: Float32Array[]; failed: number[]; stiff: number[]; finished: boolean };
  };
  /** Prepares the transfer from a coarse mesh to a full shape. */
  deformationTransfer: {
    request: {
      faces: Uint32Array;
      keys: Float32Array[];
      leader: { faces: Uint32Array; vertexOf: Int32Array; faceOf: Int32Array };
    };
    result: null;
  };
  /** Deforms a full shape as its coarse mesh deforms between `from` and `to`. */
  follow: {
    request: { shape: Float32Array; from: Float32Array; to: Float32Array };
    result: { positions: Float32Array };
  };
  /** Bending energies in the metric of lengths and angles; null where an edge has no length. */
  shellBending: {
    request: {
      faces: Uint32Array;
      keys: readonly Float32Array[];
      shapes: Float32Array[];
      /** For each energy: indices of the shapes one step before, at, and one step after its time. */
      steps: [number, number, number][];
      /** Time between these shapes. */
      step: number;
    };
    result: { energy: (number | null)[] };
  };
}

export interface Calls extends CoreCalls, FileCalls, ShellCalls {}
export type CoreCallName = keyof CoreCalls;
export type FileCallName = keyof FileCalls;
export type ShellCallName = keyof ShellCalls;
export type CallName = keyof Calls;
export type RequestOf<K extends CallName> = Calls[K]['request'];
export type ResultOf<K extends CallName> = Calls[K]['result'];

export type Request = { [K in CallName]: { type: K; id: number } & RequestOf<K> }[CallName];

/** The first message to a worker: the compiled wasm, compiled once per page. */
export interface Start extends Program {
  type: 'start';
}

/** URLs that a worker fetches when a file first needs them. If missing, the worker uses its own. */
export interface WorkerFiles {
  /** The Draco decoder's wasm file. */
  draco?: string | undefined;
  /** The npm package's libraries for compressed files. */
  codecs?: string | undefined;
}

export interface Program {
  /** Which calls the worker answers. */
  kind: 'core' | 'files' | 'shells';
  module: WebAssembly.Module;
  /** The core with shared memory for a second thread; if unavailable, `module` is used. */
  threaded: WebAssembly.Module | null;
  files: WorkerFiles;
}

export type ToWorker = Start | Request;

export type FromWorker =
  | { type: 'result'; id: number; value: ResultOf<CallName> }
  /** `fatal`: the worker's memory is unreliable and the worker must be ended. */
  | { type: 'error'; id: number; error: ErrorData; fatal: boolean }
  | { type: 'progress'; id: number; stage: string; fraction: number };

/** The worker now holds the lock with its name. The lock becomes free when the worker ends for any reason. */
export interface Locked {
  type: 'locked';
}

/** The worker's script runs. Needed in browsers, where another method may have to start it. */
export interface Ready {
  type: 'ready';
}
