/** The handlers of a worker with the module for files. */
import type { FileCallName, FrameBuffers } from '../wire/protocol.ts';
import type { Codecs } from './codecs.ts';
import { compress } from './compress.ts';
import { importFiles, type Decode } from './import-files.ts';
import type { Handlers } from './handlers.ts';
import type { WasmFiles } from './wasm-files.ts';

export function fileHandlers(wasm: WasmFiles, decode: Decode, codecs: Codecs): Handlers<FileCallName> {
  const frames: FrameBuffers[] = [];
  return {
    import: ({ files, options }, report) => importFiles(wasm, decode, { files, options, report }),
    glbSize: (request) => wasm.animationSize(request),
    addFrame: ({ positions, normals }) => {
      frames.push({ positions, normals });
      return null;
    },
    principalOffsets: (request) => wasm.principalOffsets(request),
    writeAnimation: async (request) => {
      const bytes = wasm.writeAnimation(frames.splice(0), request);
      const { compression } = request;
      return compression === 'none' ? bytes : compress(codecs, bytes, compression);
    },
    writePose: (request) => wasm.writePose(request),
  };
}
