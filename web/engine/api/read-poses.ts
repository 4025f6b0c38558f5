/** Poses of the keys' mesh from separate files: end tangents, added keys. */
import type { Engine, Keys } from './api.ts';
import { EngineError, vertexCountMismatch } from './errors.ts';
import { COMPANIONS, extensionOf, fileName, isModel } from './paths.ts';
import type { ImportOptions, InputFile, KeysInfo } from './types.ts';

export interface Pose {
  name: string;
  /** Positions, 3 x vertices. */
  positions: Float32Array;
}

/**
 * All poses in the files; `options`: the keys' import options. Errors: those of an import, and a different number of
 * vertices or different faces.
 */
export async function readPoses(
  engine: Engine,
  files: InputFile[],
  keys: Keys,
  { up, unit, objects }: ImportOptions = {},
): Promise<Pose[]> {
  const file = fileName(files[0]?.name ?? 'The file');
  const like = likeOf(keys);
  const { poses, count } = await importAny(engine, files, { up, unit, objects, ...like }).catch((error: unknown) => {
    throw isMismatch(error) ? new EngineError(error.code, error.message, { ...error.place, file }) : error;
  });
  try {
    checkSameMesh(file, poses.info, keys.info);
    return poses.info.names.slice(0, count).map((name, key) => ({ name, positions: poses.positions(key) }));
  } finally {
    poses.dispose();
  }
}

/** Import options for additional poses that match the mesh and vertices of these keys. */
export function likeOf(keys: Keys): Required<Pick<ImportOptions, 'like' | 'likePose' | 'likeObjects' | 'offset'>> {
  const { faces, scene, offset } = keys.info;
  return { like: faces, likePose: keys.positions(0), likeObjects: scene.objects ?? [], offset };
}

/** The first pose in the files, 3 x vertices. */
export async function readPose(
  engine: Engine,
  files: InputFile[],
  keys: Keys,
  options?: ImportOptions,
): Promise<Float32Array> {
  const [pose] = await readPoses(engine, files, keys, options);
  return pose!.positions;
}

/** An import needs at least two keys, so a file with one pose is used for both. */
async function importAny(
  engine: Engine,
  files: InputFile[],
  options: ImportOptions,
): Promise<{ poses: Keys; count: number }> {
  try {
    const poses = await engine.importKeyframes(files, options);
    return { poses, count: poses.info.times.length };
  } catch (error) {
    // A model's name may have no extension, or a different one.
    const models = files.filter(({ name }) => isModel(name));
    const unnamed = files.filter(({ name }) => !COMPANIONS.includes(extensionOf(name)));
    const [single, ...others] = models.length > 0 ? models : unnamed;
    const tooFew = error instanceof EngineError && error.code === 'too-few-keys';
    if (!tooFew || !single || others.length > 0) throw error;
    return { poses: await engine.importKeyframes([...files, { ...single }], options), count: 1 };
  }
}

const MISMATCHES = ['vertex-count-mismatch', 'face-count-mismatch', 'face-mismatch'];

/** Whether the files have another mesh than the keys. */
export function isMismatch(error: unknown): error is EngineError {
  return error instanceof EngineError && MISMATCHES.includes(error.code);
}

/** The difference with counts: the message's first sentence, without the advice. */
export const differenceOf = ({ message }: EngineError): string =>
  /^.*? has .*?\.(?= |$)/s.exec(message)?.[0] ?? message;

function checkSameMesh(file: string, { report, faces }: KeysInfo, keys: KeysInfo): void {
  const wanted = keys.report;
  if (report.vertices !== wanted.vertices) throw vertexCountMismatch(file, report.vertices, wanted.vertices, { file });
  const refused = (code: string, what: string, face?: number): EngineError =>
    new EngineError(
      code,
      `${file} has ${what}. Use a pose of the same mesh.`,
      face === undefined ? { file } : { file, face },
    );
  if (faces.length !== keys.faces.length)
    throw refused('face-count-mismatch', `${faces.length / 3} faces, but the keys have ${keys.faces.length / 3}`);
  const face = firstOtherFace(faces, keys.faces);
  if (face >= 0) throw refused('face-mismatch', `different faces than the keys, starting at face ${face + 1}`, face);
}

/** Index of the first different triangle, or -1. Triangles may start at any corner. */
function firstOtherFace(a: Uint32Array, b: Uint32Array): number {
  const same = (at: number, turn: number): boolean =>
    [0, 1, 2].every((corner) => a[at + corner] === b[at + ((corner + turn) % 3)]);
  const place = a.findIndex((_, at) => at % 3 === 0 && !same(at, 0) && !same(at, 1) && !same(at, 2));
  return place < 0 ? place : place / 3;
}
