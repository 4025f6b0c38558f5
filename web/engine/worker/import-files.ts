/** Files -> keys, inside a worker: compressed meshes are decoded first, a project brings its options along. */
import type { WasmCore, OnProgress } from './wasm-core.ts';
import { drawnImages } from './image-size.ts';
import { readOptions } from '../wire/project.ts';
import type { KeyData } from '../wire/protocol.ts';
import { NO_PLACE } from '../api/types.ts';
import type { ImportOptions, InputFile, Warning } from '../api/types.ts';

/**
 * Undoes compression, one file after the other; those that have none are returned as they are. `report` hears how far
 * it is.
 */
export type Decode = (files: InputFile[], report: (fraction: number) => void) => Promise<InputFile[]>;

interface ImportJob {
  files: InputFile[];
  options: ImportOptions;
  report: OnProgress;
}

const UNREADABLE: Warning = {
  code: 'project-options-ignored',
  message: 'The options saved in this file cannot be read; its keys are used with the default options.',
  count: 0,
  ...NO_PLACE,
};

/**
 * Shares of the progress: decoding, where there is anything to decode, and reading. The rest is the way out of the
 * core.
 */
const DECODING = 0.3;
const READING = 0.95;

export async function importFiles(
  core: WasmCore,
  decode: Decode,
  { files, options, report }: ImportJob,
): Promise<KeyData> {
  let start = 0;
  report('reading the file', start);
  const decoded = await decode(files, (fraction) => {
    start = DECODING * fraction;
    report('decoding compressed meshes', start);
  });
  const { info, ...poses } = core.importKeys(decoded, options, (stage, fraction) =>
    report(stage, start + (READING - start) * fraction),
  );
  report('reading the poses', READING);
  const { scene } = info;
  const { images, warnings } = drawnImages(scene.images, scene.materials);
  const project = info.project === '' ? null : readOptions(info.project);
  const unreadable = info.project !== '' && !project ? [UNREADABLE] : [];
  return {
    ...poses,
    info: {
      ...info,
      scene: { ...scene, images },
      warnings: [...info.warnings, ...warnings, ...unreadable],
      project,
    },
  };
}
