/** Reads files into keys, inside a worker. Compressed meshes are decoded first; a project also provides options. */
import { goneSentence } from '../api/gone-options.ts';
import type { OnProgress } from './wasm-calls.ts';
import type { ImportedInfo, WasmFiles } from './wasm-files.ts';
import { jsonOf } from './gltf-text.ts';
import { drawnImages } from './image-size.ts';
import { goneOptions, readMesh, readOptions, readPlayed, readSpeed } from '../wire/project.ts';
import { SHAPES } from '../api/option-table.ts';
import type { KeyData } from '../wire/protocol.ts';
import { NO_PLACE } from '../api/types.ts';
import type { ImportOptions, InputFile, MeshReport, Warning } from '../api/types.ts';

/** Decompresses files one after the other; returns uncompressed files unchanged. `report` receives the progress. */
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

/** Shares of the progress: decoding, if any, and reading. The rest is copying out of the core. */
const DECODING = 0.3;
const READING = 0.95;

export async function importFiles(
  wasm: WasmFiles,
  decode: Decode,
  { files, options, report }: ImportJob,
): Promise<KeyData> {
  let start = 0;
  report('reading the file', start);
  const decoded = await decode(files, (fraction) => {
    start = DECODING * fraction;
    report('decoding compressed meshes', start);
  });
  const { info, ...poses } = wasm.importKeys(decoded, options, (stage, fraction) =>
    report(stage, start + (READING - start) * fraction),
  );
  report('reading the poses', READING);
  const { scene } = info;
  const { images, warnings } = drawnImages(scene.images, scene.materials);
  const project = info.project === '' ? null : readOptions(info.project);
  const unreadable = info.project !== '' && !project ? [UNREADABLE] : [];
  const gone = goneSentence(goneOptions(info.project));
  const changed = info.project === '' ? null : changedMesh(info.project, info.report);
  // Shapes computed on the original mesh do not fit another mesh.
  if (project && changed) for (const name of SHAPES) project[name] = null;
  return {
    ...poses,
    info: {
      ...info,
      scene: { ...scene, images },
      warnings: [
        ...info.warnings,
        ...warnings,
        ...unreadable,
        ...(gone ? [{ ...NO_PLACE, code: 'gone-option', message: gone, count: 1 }] : []),
        ...(changed ? [changed] : []),
        ...lostProject(files, info),
      ],
      project,
      speed: info.project === '' ? null : readSpeed(info.project),
      played: info.project === '' ? null : readPlayed(info.project),
    },
  };
}

/** Changes to a project's mesh that another program made after saving; null if unchanged. */
function changedMesh(project: string, { vertices, faces }: MeshReport): Warning | null {
  const mesh = readMesh(project);
  if (!mesh || (mesh.vertices === vertices && mesh.faces === faces)) return null;
  const grouped = (count: number): string => count.toLocaleString('en');
  const message =
    `Another program changed the mesh of this project. It now has ${grouped(vertices)} vertices and ${grouped(faces)} ` +
    `faces instead of ${grouped(mesh.vertices)} and ${grouped(mesh.faces)}. The changed keys are used. ` +
    'To work on the whole mesh, open the original export.';
  return { ...NO_PLACE, code: 'project-mesh-changed', message, count: Math.abs(mesh.vertices - vertices) };
}

/** Morph target names of our exports, with a time at the end. */
const OUR_TARGET = /"([^"]* )?t=-?\d[\d.e+-]*"/;

function hasOurTargets(text: string): boolean {
  const start = text.indexOf('"targetNames"');
  return start >= 0 && OUR_TARGET.test(text.slice(start, start + 4000));
}

/** Whether another program has saved our animation without its project. */
function lostProject(files: readonly InputFile[], { project, animation }: Pick<ImportedInfo, 'project' | 'animation'>) {
  const text = files.length === 1 && project === '' && animation >= 0 ? jsonOf(files[0]!.bytes) : null;
  if (text === null || text.includes('"shapespline":') || !hasOurTargets(text)) return [];
  const message =
    'shapespline exported this animation, but another program saved it again without the project. The keys ' +
    'are taken from the animation. To work on the project, open the original export.';
  return [{ ...NO_PLACE, code: 'project-lost', message, count: 0 }];
}
