/** The core as TypeScript sees it: typed calls into the bindings, arrays copied in and out. Runs inside a worker. */
import { IMPORT } from '../api/option-table.ts';
import { EngineError, outOfMemory } from '../api/errors.ts';
import { noteOf } from '../api/export-note.ts';
import type { SecondThreadStart } from './second-thread.ts';
import { HeapScope, readFloats, readJson, readText, sharedFloats, writeFloats, type Range } from './heap.ts';
import type { FrameBuffers, FrameData, KeyData, MotionSpec, RequestOf, ResultOf } from '../wire/protocol.ts';
import { awaitedOrder } from '../wire/shared-order.ts';
import type {
  DiscretePath,
  FaceCurve,
  Ghost,
  ImportOptions,
  InputFile,
  KeysInfo,
  Scene,
  SequenceStats,
  KeyPace,
  MotionPace,
  PatchCurve,
  ShapePlane,
  TextureImage,
  Warning,
  MeasuresAt,
} from '../api/types.ts';
import type { Address, CreateWasmModule, WasmModule } from './wasm-module.ts';

type CallResult<T> = ({ ok: true } & T) | Failure;

interface Failure {
  ok: false;
  code: string;
  message: string;
  key: number;
  vertex: number;
  face: number;
}

/** The core's JSON of an import: of KeysInfo the project is still a text, and nobody has looked into the images. */
export type ImportedInfo = Omit<KeysInfo, 'project' | 'scene' | 'played'> & {
  project: string;
  scene: Omit<Scene, 'images'> & { images: Omit<TextureImage, 'scale'>[] };
};

export interface SequenceState {
  range: [number, number];
  warnings: Warning[];
}

interface FrameResult {
  positions: Range;
  normals: Range;
  indefiniteFaces: number;
  indefiniteFace?: number;
}

export type OnProgress = (stage: string, fraction: number) => void;

function placeOf({ key, vertex, face }: Failure): EngineError['place'] {
  const entries = Object.entries({ key, vertex, face }).filter(([, index]) => index >= 0);
  return Object.fromEntries(entries);
}

/** Bytes: many times what a frame's kernels need. */
const SECOND_STACK = 1 << 18;
/** Between reports of one stage. */
const REPORT_MS = 15;

export class WasmCore {
  private readonly module: WasmModule;

  private constructor(module: WasmModule) {
    this.module = module;
  }

  /** Instantiates the compiled module with its Emscripten glue. */
  static async start(create: CreateWasmModule, compiled: WebAssembly.Module): Promise<WasmCore> {
    return new WasmCore(await instantiate(create, compiled));
  }

  /** What a second thread needs to work in this core's memory; null where that is not shared. */
  secondThreadStart(compiled: WebAssembly.Module): SecondThreadStart | null {
    const { wasmMemory: memory } = this.module;
    if (!memory) return null;
    const stack = this.module._malloc(SECOND_STACK) >>> 0;
    if (stack === 0) throw outOfMemory();
    return { module: compiled, memory, stack: stack + SECOND_STACK };
  }

  /** From the next frame on; the frames are the same. */
  setThreads(handle: number, threads: 1 | 2): void {
    this.module._shapespline_set_threads(handle, threads);
  }

  /** The second thread broke down in the middle of a frame: what it was to write cannot be relied on. */
  get secondThreadLost(): boolean {
    return this.module._shapespline_is_help_lost() !== 0;
  }

  get heapBytes(): number {
    return this.module.HEAPU8.length;
  }

  /** Objects of the bindings that are alive. */
  get objects(): number {
    return this.result<{ count: number }>(this.module._shapespline_objects()).count;
  }

  importKeys(
    files: InputFile[],
    options: ImportOptions,
    onProgress: OnProgress = () => undefined,
  ): Omit<KeyData, 'info'> & { info: ImportedInfo } {
    this.hear(onProgress);
    const { animation, sample, everyFrame, keyTimes, up, unit, objects, like, likePose, likeObjects, offset } = options;
    const request = {
      files,
      options: {
        animation: animation ?? null,
        sampleTimes: Array.isArray(sample) ? sample : [],
        everyFrame: everyFrame === true,
        sampleCount: typeof sample === 'number' ? sample : null,
        frameTimes: noteOf(files)?.times ?? [],
        keyTimes: keyTimes ?? [],
        zUp: (up ?? IMPORT.up.default) === 'z',
        unit: unit ?? IMPORT.unit.default,
        objects: objects ?? [],
        like: like ?? null,
        likePose: likePose ?? null,
        offset: offset ?? null,
        likeObjects: likeObjects ?? [],
      },
    };
    return this.lend((scope) => {
      const { handle, normals, ...info } = this.result<ImportedInfo & { handle: number; normals: Float32Array | null }>(
        this.module._shapespline_import(scope.putJson(request)),
      );
      try {
        return { info, normals, positions: info.names.map((_, key) => this.importedPositions(handle, key)) };
      } finally {
        this.release(handle);
      }
    });
  }

  /** Builds a sequence and returns its handle. */
  createSequence(
    request: RequestOf<'create'>,
    onProgress: OnProgress = () => undefined,
  ): SequenceState & { handle: number } {
    this.hear(onProgress);
    const { order } = request;
    this.module.takeOrder = (address, unknowns) => {
      const made = order && awaitedOrder(order);
      if (made?.length !== unknowns) return false;
      new Int32Array(this.module.HEAPU8.buffer, address >>> 0, unknowns).set(made);
      return true;
    };
    return this.ask(madeOf(request), (address) => this.module._shapespline_sequence(address));
  }

  /** In which the unknowns of this sequence are eliminated. */
  eliminationOrder(request: RequestOf<'order'>): Int32Array {
    return this.ask<{ order: Int32Array }>(madeOf(request), (address) => this.module._shapespline_order(address)).order;
  }

  update(handle: number, motion: MotionSpec): SequenceState {
    const request = { motion: motion.options, keyTimes: motion.keyTimes };
    return this.ask(request, (address) => this.module._shapespline_update(handle, address));
  }

  /** Fills `buffers` where they are given and fit. */
  evaluate(handle: number, t: number, buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    return this.frame(this.module._shapespline_evaluate(handle, t), buffers);
  }

  /** The shape that the keys blend to in these weights; `buffers` as above. */
  blend(handle: number, weights: number[], buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    return this.lend((scope) =>
      this.frame(this.module._shapespline_blend(handle, scope.putJson({ weights })), buffers),
    );
  }

  measure(handle: number, t: number): MeasuresAt {
    return this.result(this.module._shapespline_measure(handle, t));
  }

  plane(handle: number, times: number[]): ShapePlane {
    return this.ask({ times }, (address) => this.module._shapespline_plane(handle, address));
  }

  discretePath(handle: number, samples: number): DiscretePath {
    return this.result(this.module._shapespline_discrete_path(handle, samples));
  }

  faceCurve(handle: number, face: number, times: number[]): FaceCurve {
    return this.ask({ times }, (address) => this.module._shapespline_part_curve(handle, face, false, address));
  }

  patchCurve(handle: number, patch: number, times: number[]): PatchCurve {
    return this.ask({ times }, (address) => this.module._shapespline_part_curve(handle, patch, true, address));
  }

  pace(handle: number): KeyPace {
    return this.result(this.module._shapespline_pace(handle));
  }

  motionPace(handle: number, times: number[]): MotionPace {
    return this.ask({ times }, (address) => this.module._shapespline_motion_pace(handle, address));
  }

  bending(handle: number, times: number[]): number[] {
    return this.ask<{ energy: number[] }>({ times }, (address) => this.module._shapespline_bending(handle, address))
      .energy;
  }

  patches(handle: number): Int32Array {
    return this.parts(handle, true);
  }

  components(handle: number): Int32Array {
    return this.parts(handle, false);
  }

  ghost(handle: number): Ghost | null {
    const ghost = this.result<Ghost>(this.module._shapespline_ghost(handle));
    return ghost.faces.length > 0 ? ghost : null;
  }

  ghostPositions(handle: number, t: number): Float32Array {
    return this.result<{ positions: Float32Array }>(this.module._shapespline_ghost_positions(handle, t)).positions;
  }

  stats(handle: number): Omit<SequenceStats, 'threads'> {
    return {
      ...this.result<Omit<SequenceStats, 'threads' | 'heapBytes'>>(this.module._shapespline_stats(handle)),
      heapBytes: this.heapBytes,
    };
  }

  /** One GLB that plays `frames` at their seconds; the last `stills` of them are in the file but never shown. */
  writeAnimation(frames: FrameBuffers[], { compression: _, ...request }: RequestOf<'writeAnimation'>): Uint8Array {
    this.module.takeFrame = (index, positions, normals) => {
      const frame = frames[index];
      if (!frame) return false;
      writeFloats(this.module, positions, frame.positions);
      writeFloats(this.module, normals, frame.normals);
      delete frames[index]; // asked for once; the file grows by as much
      return true;
    };
    const vertices = (frames[0]?.positions.length ?? 0) / 3;
    return this.written({ ...request, vertices }, (address) => this.module._shapespline_write_animation(address));
  }

  animationSize(request: RequestOf<'glbSize'>): ResultOf<'glbSize'> {
    return this.ask(request, (address) => this.module._shapespline_animation_size(address));
  }

  principalOffsets(request: RequestOf<'principalOffsets'>): ResultOf<'principalOffsets'> {
    const { handle, ...result } = this.ask<ResultOf<'principalOffsets'> & { handle: number }>(request, (address) =>
      this.module._shapespline_principal_offsets(address),
    );
    this.release(handle);
    return result;
  }

  writePose({ pose, ...request }: RequestOf<'writePose'>): Uint8Array {
    return this.written({ ...request, ...pose }, (address) => this.module._shapespline_write_pose(address));
  }

  release(handle: number): void {
    this.module._shapespline_release(handle);
  }

  private parts(handle: number, arePatches: boolean): Int32Array {
    return this.result<{ parts: Int32Array }>(this.module._shapespline_parts(handle, arePatches)).parts;
  }

  private frame(result: Address, buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    const frame = this.rawResult<FrameResult>(result);
    return {
      positions: readFloats(this.module, frame.positions, buffers?.positions),
      normals: readFloats(this.module, frame.normals, buffers?.normals),
      indefiniteFaces: frame.indefiniteFaces,
      indefiniteFace: frame.indefiniteFace,
    };
  }

  /** The core reports more often than anybody looks, and each message takes its time. */
  private hear(onProgress: OnProgress): void {
    let last: Address = -1;
    let heard = -Infinity;
    this.module.onProgress = (stage, fraction) => {
      const now = performance.now();
      if (stage === last && fraction < 1 && now < heard + REPORT_MS) return;
      last = stage;
      heard = now;
      onProgress(readText(this.module, stage), fraction);
    };
  }

  private importedPositions(handle: number, key: number): Float32Array {
    const { positions } = this.rawResult<{ positions: Range }>(this.module._shapespline_import_positions(handle, key));
    return readFloats(this.module, positions, sharedFloats(positions.length));
  }

  /** The bytes of a file that the core keeps until they are copied. */
  private written(request: object, call: (address: Address) => Address): Uint8Array {
    const { handle, bytes } = this.ask<{ handle: number; bytes: Uint8Array }>(request, call);
    this.release(handle);
    return bytes;
  }

  private lend<T>(work: (scope: HeapScope) => T): T {
    const scope = new HeapScope(this.module);
    try {
      return work(scope);
    } finally {
      scope.free();
    }
  }

  private ask<T>(request: object, call: (address: Address) => Address): T {
    return this.lend((scope) => this.result<T>(call(scope.putJson(request))));
  }

  private result<T>(address: Address): T {
    return checked(readJson(this.module, readText(this.module, address)) as CallResult<T>);
  }

  /** With ranges where others have copies of the arrays. */
  private rawResult<T>(address: Address): T {
    return checked(JSON.parse(readText(this.module, address)) as CallResult<T>);
  }
}

function madeOf({ names, faces, positions, normals, encoding, motion }: RequestOf<'create'>): object {
  const keys = positions.map((of, key) => ({ name: names[key], time: motion.keyTimes[key], positions: of }));
  return { faces, normals, keys, encoding, motion: motion.options };
}

function checked<T>(result: CallResult<T>): T {
  if (!result.ok) throw new EngineError(result.code, result.message, placeOf(result));
  const { ok, ...value } = result;
  return value as T;
}

function instantiate(create: CreateWasmModule, compiled: WebAssembly.Module): Promise<WasmModule> {
  return new Promise((resolve, reject) => {
    const instantiateWasm: Parameters<CreateWasmModule>[0]['instantiateWasm'] = (imports, receive) => {
      // The glue does not hear of a failure here (too little memory, say): its own promise would stay open.
      WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled), reject);
      return {};
    };
    create({ instantiateWasm }).then(resolve, reject);
  });
}
