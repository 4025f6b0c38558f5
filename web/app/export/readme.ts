/** Instructions for a zip's files in the most common programs. */
import type { ExportedFile } from '../../engine/api/types.ts';

type Format = 'obj' | 'pc2' | 'mdd' | 'video' | 'glb';

const SEQUENCE = [
  'Blender',
  '  1. Enable the add-on "Stop motion OBJ" (or a similar add-on for mesh sequences), or use the PC2 export instead.',
  '  2. File > Import > Mesh Motion, choose this folder and the file name 0000.',
  '  3. Set the frame rate of the scene to RATE.',
  'Houdini',
  '  1. Create a File node inside a Geometry object.',
  '  2. Set its file to $HIP/`padzero(4, $F-1)`.obj. Frame 1 is then 0000.obj.',
  '  3. Set the frame rate of the scene to RATE.',
  'Unreal',
  '  1. Unreal does not read OBJ sequences. Open them in Blender or Houdini and export Alembic (.abc).',
  '  2. Import the .abc as a Geometry Cache.',
  '  3. Or use the GLB export. Unreal imports its morph targets.',
];

const CACHE = [
  'Blender',
  '  1. File > Import > Wavefront (.obj), with the default axes.',
  '  2. Add a Mesh Cache modifier of format FORMAT to the mesh, and choose the FORMAT file. Keep the default axes.',
  '  3. Set the frame rate of the scene to RATE. Sample 0 is shown at the start frame of the modifier.',
  'Houdini',
  '  1. Read the OBJ with a File node, without merging or reordering points.',
  '  2. Apply the FORMAT file to its points with the node for point caches (MDD: the SideFX Labs MDD tools).',
  '  3. Set the frame rate of the scene to RATE.',
  'Unreal',
  '  1. Unreal does not read point caches. Set up the cache in Blender as above and export Alembic (.abc).',
  '  2. Import the .abc as a Geometry Cache.',
  '  3. Or use the GLB export. Unreal imports its morph targets.',
];

function text(format: Format, fps: number | null): string {
  const lines = format === 'obj' ? SEQUENCE : CACHE;
  const rate = fps === null ? 'the intended playback rate' : `${fps}`;
  return `${lines.join('\n').replaceAll('FORMAT', format.toUpperCase()).replaceAll('RATE', rate)}\n`;
}

/** The files, followed by README.txt. */
export async function* withReadme(
  format: Format,
  files: AsyncIterable<ExportedFile>,
  fps: number | null,
): AsyncGenerator<ExportedFile, void, undefined> {
  yield* files;
  yield { name: 'README.txt', bytes: new TextEncoder().encode(text(format, fps)) };
}
