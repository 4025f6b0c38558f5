/** Files -> keys, inside a worker: compressed meshes are decoded first, a project brings its options along. */
import type { Core } from './core.ts';
import { readOptions } from './project.ts';
import type { ImportedData } from './protocol.ts';
import type { ImportOptions, InputFile, Warning } from './types.ts';

/** Undoes compression; files that have none are returned as they are. */
export type Decode = (files: InputFile[]) => Promise<InputFile[]>;

const UNREADABLE: Warning = {
  code: 'project-options-ignored',
  message: 'The file holds options of this program that cannot be read; its keys are used with the default options.',
  count: 0,
};

export async function importFiles(core: Core, decode: Decode, files: InputFile[], options: ImportOptions): Promise<ImportedData> {
  const { project: text, ...imported } = core.importKeys(await decode(files), options);
  if (text === '') return { ...imported, project: null };
  const project = readOptions(text);
  return project ? { ...imported, project } : { ...imported, project, warnings: [...imported.warnings, UNREADABLE] };
}
