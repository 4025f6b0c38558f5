/** Files -> keys, inside a worker: compressed meshes are decoded first, and a project finds its own keys again. */
import type { Core, RawImport } from './core.ts';
import { EngineError } from './errors.ts';
import { readProject, type Project } from './project.ts';
import type { ImportedData } from './protocol.ts';
import type { ImportOptions, InputFile, Warning } from './types.ts';

/** Undoes compression; files that have none are returned as they are. */
export type Decode = (files: InputFile[]) => Promise<InputFile[]>;

export async function importFiles(core: Core, decode: Decode, files: InputFile[], options: ImportOptions): Promise<ImportedData> {
  const plain = await decode(files);
  const raw = core.importKeys(plain, options);
  const project = readProject(raw.project);
  if (project === 'unreadable') return { ...raw, project: null, warnings: [...raw.warnings, unreadable] };
  // Whoever names times of the animation wants those and not the project's keys.
  const asked = options.animation !== undefined || options.sample !== undefined || options.keyTimes !== undefined;
  if (!project || asked) return { ...raw, project: null };
  return restore(core, plain, options, raw, project);
}

const unreadable: Warning = {
  code: 'project-unreadable',
  message: 'The file holds settings of this program that cannot be read; only its shapes are used.',
  count: 0,
};

/** Takes the project's keys out of the animation that it was saved as. */
function restore(core: Core, files: InputFile[], options: ImportOptions, raw: RawImport, project: Project): ImportedData {
  const { times, names, seconds } = project.keys;
  try {
    const restored = core.importKeys(files, { ...options, sample: seconds, keyTimes: times });
    return { ...restored, keys: { ...restored.keys, names }, project: project.options };
  } catch (error) {
    if (!(error instanceof EngineError)) throw error;
    return { ...raw, project: null, warnings: [...raw.warnings, unreadable] };
  }
}
