/** The core as TypeScript sees it: typed calls into the bindings, arrays copied in and out. Runs inside a worker. */
import { EngineError, outOfMemory } from '../api/errors.ts';
import type { SecondThreadStart } from './second-thread.ts';
import { HeapScope, readBytes, readFloats, readInts, readText, writeFloats, type Range } from './heap.ts';
import type {
  FrameBuffers,
  FrameData,
  ImportedData,
  KeyData,
  MotionSpec,
  RequestOf,
  SceneData,
} from '../wire/protocol.ts';
import type {
  AnimationInfo,
  EncodingOptions,
  Ghost,
  ImportOptions,
  InputFile,
  Material,
  MaterialGroup,
  MeshReport,
  PreviewError,
  SequenceStats,
  ShapePlane,
  TextureImage,
  Warning,
} from '../api/types.ts';
import type { Address, CreateWasmModule, WasmModule } from './wasm-module.ts';

type Answer<T> = ({ ok: true } & T) | Failure;

interface Failure {
  ok: false;
  code: string;
  message: string;
  key: number;
  vertex: number;
  face: number;
}

interface SceneAnswer {
  uvs: Range | null;
  colors: Range | null;
  seams: { copyOf: Range; indices: Range } | null;
  groups: MaterialGroup[];
  materials: Material[];
  images: { mimeType: string; bytes: Range }[];
}

interface ImportAnswer {
  handle: number;
  names: string[];
  times: number[];
  faces: Range;
  normals: Range | null;
  scene: SceneAnswer;
  report: MeshReport;
  warnings: Warning[];
  animations: AnimationInfo[];
  animation: number;
  project: string;
}

/** An import with the project's JSON text still unread, and its images not looked into. */
export type RawImport = Omit<ImportedData, 'project' | 'scene'> & {
  project: string;
  scene: Omit<SceneData, 'images'> & { images: Omit<TextureImage, 'scale'>[] };
};

export interface SequenceState {
  range: [number, number];
  warnings: Warning[];
}

export type OnProgress = (stage: string, fraction: number) => void;

function placeOf({ key, vertex, face }: Failure): EngineError['place'] {
  const entries = Object.entries({ key, vertex, face }).filter(([, index]) => index >= 0);
  return Object.fromEntries(entries);
}

/** Bytes: many times what a frame's kernels need. */
const HELPER_STACK = 1 << 18;

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
  helperStart(compiled: WebAssembly.Module): SecondThreadStart | null {
    const { wasmMemory: memory } = this.module;
    if (!memory) return null;
    const stack = this.module._malloc(HELPER_STACK) >>> 0;
    if (stack === 0) throw outOfMemory();
    return { module: compiled, memory, stack: stack + HELPER_STACK };
  }

  /** From the next frame on; the frames are the same. */
  setThreads(handle: number, threads: 1 | 2): void {
    this.module._shapespline_set_threads(handle, threads);
  }

  /** The second thread broke down in the middle of a frame: what it was to write cannot be relied on. */
  get helpLost(): boolean {
    return this.module._shapespline_is_help_lost() !== 0;
  }

  get heapBytes(): number {
    return this.module.HEAPU8.length;
  }

  /** Objects of the bindings that are alive. */
  get objects(): number {
    return this.answer<{ count: number }>(this.module._shapespline_objects()).count;
  }

  importKeys(files: InputFile[], options: ImportOptions, onProgress: OnProgress = () => undefined): RawImport {
    this.module.onProgress = (stage, fraction) => onProgress(readText(this.module, stage), fraction);
    return this.lend((scope) => {
      const { animation, sample, keyTimes, up, unit, like } = options;
      const request = {
        files: files.map(({ name, bytes }) => ({ name, bytes: scope.put(bytes) })),
        options: {
          animation: animation ?? null,
          sampleTimes: Array.isArray(sample) ? sample : [],
          sampleCount: typeof sample === 'number' ? sample : null,
          keyTimes: keyTimes ?? [],
          zUp: up === 'z',
          unit: unit ?? 1,
          like: like ? scope.put(like) : null,
        },
      };
      const answer = this.answer<ImportAnswer>(this.module._shapespline_import(scope.putText(JSON.stringify(request))));
      try {
        return this.readImport(answer);
      } finally {
        this.release(answer.handle);
      }
    });
  }

  /** Builds a sequence and returns its handle. */
  createSequence(
    keys: KeyData,
    encoding: EncodingOptions,
    motion: MotionSpec,
    onProgress: OnProgress,
  ): SequenceState & { handle: number } {
    this.module.onProgress = (stage, fraction) => onProgress(readText(this.module, stage), fraction);
    return this.lend((scope) => {
      const request = {
        faces: scope.put(keys.faces),
        normals: scope.putOrNull(keys.normals),
        keys: keys.positions.map((positions, key) => ({
          name: keys.names[key],
          time: motion.keyTimes[key],
          positions: scope.put(positions),
        })),
        encoding: {
          ...encoding,
          startTangent: scope.putOrNull(encoding.startTangent),
          endTangent: scope.putOrNull(encoding.endTangent),
        },
        motion: motion.options,
      };
      return this.answer(this.module._shapespline_sequence(scope.putText(JSON.stringify(request))));
    });
  }

  update(handle: number, motion: MotionSpec): SequenceState {
    const request = { motion: motion.options, keyTimes: motion.keyTimes };
    return this.ask(request, (address) => this.module._shapespline_update(handle, address));
  }

  /** Fills `buffers` where they are given and fit. */
  evaluate(
    handle: number,
    t: number,
    buffers: FrameBuffers | null,
    preview = false,
  ): Omit<FrameData, 'ms' | 'threads'> {
    interface FrameAnswer {
      positions: Range;
      normals: Range;
      indefiniteFaces: number;
      indefiniteFace?: number;
    }
    const frame = this.answer<FrameAnswer>(this.module._shapespline_evaluate(handle, t, preview ? 1 : 0));
    return {
      positions: readFloats(this.module, frame.positions, buffers?.positions),
      normals: readFloats(this.module, frame.normals, buffers?.normals),
      indefiniteFaces: frame.indefiniteFaces,
      indefiniteFace: frame.indefiniteFace,
    };
  }

  previewError(handle: number, t: number): PreviewError {
    return this.answer(this.module._shapespline_preview_error(handle, t));
  }

  measure(handle: number, t: number): { volume: number; area: number } {
    return this.answer(this.module._shapespline_measure(handle, t));
  }

  plane(handle: number, times: number[]): ShapePlane {
    return this.ask({ times }, (address) => this.module._shapespline_plane(handle, address));
  }

  bending(handle: number, times: number[]): number[] {
    return this.ask<{ energy: number[] }>({ times }, (address) => this.module._shapespline_bending(handle, address))
      .energy;
  }

  patches(handle: number): Int32Array {
    const { patches } = this.answer<{ patches: Range }>(this.module._shapespline_patches(handle));
    return readInts(this.module, patches);
  }

  components(handle: number): Int32Array {
    const { components } = this.answer<{ components: Range }>(this.module._shapespline_components(handle));
    return readInts(this.module, components);
  }

  ghost(handle: number): Ghost | null {
    const ranges = this.answer<Record<keyof Ghost, Range>>(this.module._shapespline_ghost(handle));
    if (ranges.faces.length === 0) return null;
    const read = (range: Range): Int32Array => readInts(this.module, range);
    return {
      faces: new Uint32Array(read(ranges.faces).buffer),
      vertexOf: read(ranges.vertexOf),
      ghostVertexOf: read(ranges.ghostVertexOf),
      ghostFaceOf: read(ranges.ghostFaceOf),
    };
  }

  ghostPositions(handle: number, t: number): Float32Array {
    return readFloats(
      this.module,
      this.answer<{ positions: Range }>(this.module._shapespline_ghost_positions(handle, t)).positions,
    );
  }

  stats(handle: number): Omit<SequenceStats, 'threads'> {
    return {
      ...this.answer<Omit<SequenceStats, 'threads' | 'heapBytes'>>(this.module._shapespline_stats(handle)),
      heapBytes: this.heapBytes,
    };
  }

  /** One GLB that plays `frames` at their seconds; the last `stills` of them are in the file but never shown. */
  writeAnimation(
    frames: FrameBuffers[],
    { faces, scene, seconds, stills, project }: RequestOf<'writeAnimation'>,
  ): Uint8Array {
    this.module.takeFrame = (index, positions, normals) => {
      const frame = frames[index];
      if (!frame) return false;
      writeFloats(this.module, positions, frame.positions);
      writeFloats(this.module, normals, frame.normals);
      delete frames[index]; // asked for once; the file grows by as much
      return true;
    };
    return this.lend((scope) => {
      const vertices = (frames[0]?.positions.length ?? 0) / 3;
      const request = { faces: scope.put(faces), scene: lendScene(scope, scene), vertices, seconds, stills, project };
      return this.takeBytes(this.module._shapespline_write_animation(scope.putText(JSON.stringify(request))));
    });
  }

  animationSize({ vertices, faces, frames, scene }: RequestOf<'glbSize'>): number {
    return this.lend((scope) => {
      const request = { vertices, faces, frames, scene: lendScene(scope, scene) };
      return this.answer<{ bytes: number }>(
        this.module._shapespline_animation_size(scope.putText(JSON.stringify(request))),
      ).bytes;
    });
  }

  writePose({ format, faces, scene, pose }: RequestOf<'writePose'>): Uint8Array {
    return this.lend((scope) => {
      const request = {
        format,
        faces: scope.put(faces),
        positions: scope.put(pose.positions),
        normals: scope.put(pose.normals),
        scene: lendScene(scope, scene),
      };
      return this.takeBytes(this.module._shapespline_write_pose(scope.putText(JSON.stringify(request))));
    });
  }

  release(handle: number): void {
    this.module._shapespline_release(handle);
  }

  private readImport(answer: ImportAnswer): RawImport {
    const { module } = this;
    const positions = answer.names.map((_, key) => {
      const range = this.answer<{ positions: Range }>(
        module._shapespline_import_positions(answer.handle, key),
      ).positions;
      return readFloats(module, range);
    });
    const { uvs, colors, seams, groups, materials, images } = answer.scene;
    return {
      keys: {
        names: answer.names,
        times: answer.times,
        faces: new Uint32Array(readInts(module, answer.faces).buffer),
        positions,
        normals: answer.normals && readFloats(module, answer.normals),
      },
      scene: {
        uvs: uvs && readFloats(module, uvs),
        colors: colors && readFloats(module, colors),
        seams: seams && {
          copyOf: readInts(module, seams.copyOf),
          indices: new Uint32Array(readInts(module, seams.indices).buffer),
        },
        groups,
        materials,
        images: images.map(({ mimeType, bytes }) => ({ mimeType, bytes: readBytes(module, bytes) })),
      },
      report: answer.report,
      warnings: answer.warnings,
      animations: answer.animations,
      animation: answer.animation,
      project: answer.project,
    };
  }

  private takeBytes(address: Address): Uint8Array {
    const { handle, bytes } = this.answer<{ handle: number; bytes: Range }>(address);
    try {
      return readBytes(this.module, bytes);
    } finally {
      this.release(handle);
    }
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
    return this.lend((scope) => this.answer<T>(call(scope.putText(JSON.stringify(request)))));
  }

  private answer<T>(address: Address): T {
    const answer = JSON.parse(readText(this.module, address)) as Answer<T>;
    if (!answer.ok) throw new EngineError(answer.code, answer.message, placeOf(answer));
    const { ok, ...value } = answer;
    return value as T;
  }
}

function lendScene(scope: HeapScope, scene: SceneData): object {
  return {
    ...scene,
    uvs: scope.putOrNull(scene.uvs),
    colors: scope.putOrNull(scene.colors),
    seams: scene.seams && { copyOf: scope.put(scene.seams.copyOf), indices: scope.put(scene.seams.indices) },
    images: scene.images.map(({ mimeType, bytes }) => ({ mimeType, bytes: scope.put(bytes) })),
  };
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
