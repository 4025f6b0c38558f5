/** The module for files with typed calls. */
import { IMPORT } from '../api/option-table.ts';
import { noteOf } from '../api/export-note.ts';
import { readFloats, writeFloats, type Range } from './heap.ts';
import type { FrameBuffers, KeyData, RequestOf, ResultOf } from '../wire/protocol.ts';
import { sharedFloats } from '../wire/shared-floats.ts';
import type { ImportOptions, InputFile, KeysInfo, Scene, TextureImage } from '../api/types.ts';
import { WasmCalls, type OnProgress } from './wasm-calls.ts';
import type { Address, FilesModule } from './wasm-module.ts';

/** The JSON of an import: KeysInfo with the project as text, and images without sizes. */
export type ImportedInfo = Omit<KeysInfo, 'project' | 'scene' | 'played'> & {
  project: string;
  scene: Omit<Scene, 'images'> & { images: Omit<TextureImage, 'scale'>[] };
};

export class WasmFiles extends WasmCalls<FilesModule> {
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

  /** A GLB that plays `frames` at their times in seconds. The last `stills` of them are stored but never shown. */
  writeAnimation(frames: FrameBuffers[], { compression: _, ...request }: RequestOf<'writeAnimation'>): Uint8Array {
    this.module.takeFrame = (index, positions, normals) => {
      const frame = frames[index];
      if (!frame) return false;
      writeFloats(this.module, positions, frame.positions);
      writeFloats(this.module, normals, frame.normals);
      delete frames[index]; // each frame is read only once, and the file grows by its size
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
}
