/** The core as TypeScript sees it: typed calls into the bindings, arrays copied in and out. Runs inside a worker. */
import { IMPORT } from '../api/option-table.ts';
import { EngineError, outOfMemory } from '../api/errors.ts';
import { noteOf } from '../api/export-note.ts';
import type { SecondThreadStart } from './second-thread.ts';
import { HeapScope, readFloats, readJson, readText, sharedFloats, writeFloats, type Range } from './heap.ts';
import { QUESTIONS, type AnswerOf, type AskedOf, type QuestionName } from '../wire/calls.ts';
import type {
  FrameBuffers,
  FrameData,
  KeyData,
  MotionSpec,
  MotionState,
  RequestOf,
  ResultOf,
} from '../wire/protocol.ts';
import { awaitedOrder, type SharedOrder } from '../wire/shared-order.ts';
import type { ImportOptions, InputFile, KeysInfo, Scene, TextureImage } from '../api/types.ts';
import type { Address, CreateWasmModule, QuestionFunctions, WasmModule } from './wasm-module.ts';

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

interface FrameResult {
  positions: Range;
  normals: Range;
  indefiniteFaces: number;
  indefiniteFace?: number;
}

export type OnProgress = (stage: string, fraction: number) => void;

/** For a motion that may be the first of its space. */
export interface NewSpace {
  order?: SharedOrder | null;
  report?: OnProgress;
}

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

  /** From the shape's next frame on; the frames are the same. */
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

  /** Returns the handle of a shape. */
  encode(request: RequestOf<'encode'>, onProgress: OnProgress = () => undefined): number {
    this.hear(onProgress);
    return this.send<{ handle: number }>(keysOf(request), (address) => this.module._shapespline_encode(address)).handle;
  }

  /** In which the unknowns of this shape are eliminated. */
  eliminationOrder(request: RequestOf<'order'>): Int32Array {
    return this.send<{ order: Int32Array }>(keysOf(request), (address) => this.module._shapespline_order(address))
      .order;
  }

  /** `before`: another motion of the shape, which what is costly is taken from; or null. */
  motion(
    shape: number,
    { options, keyTimes }: MotionSpec,
    before: number | null,
    { order, report }: NewSpace = {},
  ): MotionState & { handle: number } {
    this.hear(report ?? (() => undefined));
    this.module.takeOrder = (address, unknowns) => {
      const made = order && awaitedOrder(order);
      if (made?.length !== unknowns) return false;
      new Int32Array(this.module.HEAPU8.buffer, address >>> 0, unknowns).set(made);
      return true;
    };
    const request = { motion: options, keyTimes, before };
    return this.send(request, (address) => this.module._shapespline_motion(shape, address));
  }

  /** The answer to a question about the shape or the motion with this handle. */
  ask<N extends QuestionName>(name: N, handle: number, request: AskedOf<N>): AnswerOf<N> {
    const functions = this.module as unknown as QuestionFunctions;
    return this.send(request, (address) => functions[QUESTIONS[name].symbol]!(handle, address));
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
    return this.send(request, (address) => this.module._shapespline_animation_size(address));
  }

  principalOffsets(request: RequestOf<'principalOffsets'>): ResultOf<'principalOffsets'> {
    const { handle, ...result } = this.send<ResultOf<'principalOffsets'> & { handle: number }>(request, (address) =>
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
    const { handle, bytes } = this.send<{ handle: number; bytes: Uint8Array }>(request, call);
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

  private send<T>(request: object, call: (address: Address) => Address): T {
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

function keysOf({ names, times, faces, positions, normals, encoding }: RequestOf<'encode'>): object {
  const keys = positions.map((of, key) => ({ name: names[key], time: times[key], positions: of }));
  return { faces, normals, keys, encoding };
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
