/** Picked files -> bytes, and poses out of further files of the same mesh. */
import type { Engine, Keys } from '../../engine/api/api.ts';
import { isModel } from '../../engine/api/paths.ts';
import { firstOtherFace } from '../../engine/caller/read-pose.ts';
import type { ImportOptions, InputFile, KeysInfo } from '../../engine/api/types.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';

export interface NewPose {
  name: string;
  /** 3 x vertices. */
  positions: Float32Array;
}

/** One after the other; `report` hears the share of all bytes that is there. */
export async function readFiles(
  files: readonly PickedFile[],
  report?: (fraction: number) => void,
  signal?: AbortSignal,
): Promise<InputFile[]> {
  const all = files.reduce((sum, { file }) => sum + file.size, 0);
  const read: InputFile[] = [];
  let before = 0;
  for (const { name, file } of files) {
    const bytes = await bytesOf(file, (done) => report?.((before + done) / all), signal).catch((error: unknown) => {
      if (signal?.aborted) throw error;
      throw new Error(`${name} could not be read. It may have been moved, or it is a folder. Drop it again.`);
    });
    before += file.size;
    read.push({ name, bytes });
  }
  return read;
}

async function bytesOf(file: File, report: (done: number) => void, signal?: AbortSignal): Promise<Uint8Array> {
  const bytes = new Uint8Array(file.size);
  const reader = file.stream().getReader();
  let done = 0;
  for (;;) {
    const { value } = await reader.read();
    if (!value) break;
    if (signal?.aborted) {
      await reader.cancel();
      signal.throwIfAborted();
    }
    bytes.set(value, done);
    done += value.length;
    report(done);
  }
  return bytes.subarray(0, done);
}

/** Every pose that the files hold; each must be a pose of the mesh that is open, which was read with these options. */
export async function importPoses(
  engine: Engine,
  files: InputFile[],
  open: KeysInfo,
  { up, unit }: ImportOptions,
): Promise<NewPose[]> {
  const { keys, count } = await importAny(engine, files, { up, unit, like: open.faces });
  try {
    checkSameMesh(files[0]?.name ?? 'The file', keys.info, open);
    return Array.from({ length: count }, (_, key) => ({
      name: keys.info.names[key] ?? '',
      positions: keys.positions(key),
    }));
  } finally {
    keys.dispose();
  }
}

/** An import needs two keys; a file with one pose is read as both. */
async function importAny(
  engine: Engine,
  files: InputFile[],
  options: ImportOptions,
): Promise<{ keys: Keys; count: number }> {
  const models = files.filter(({ name }) => isModel(name));
  try {
    const keys = await engine.importKeyframes(files, options);
    return { keys, count: keys.info.times.length };
  } catch (error) {
    const single = models[0];
    const tooFew = error instanceof Error && 'code' in error && error.code === 'too-few-keys';
    if (!tooFew || models.length !== 1 || !single) throw error;
    const twin = { name: `again/${single.name}`, bytes: single.bytes };
    return { keys: await engine.importKeyframes([...files, twin], options), count: 1 };
  }
}

function checkSameMesh(name: string, { report, faces }: KeysInfo, open: KeysInfo): void {
  const mesh = open.report;
  if (report.vertices !== mesh.vertices || report.faces !== mesh.faces) {
    const count = (number: number): string => number.toLocaleString('en');
    throw new Error(
      `${name} has ${count(report.vertices)} vertices and ${count(report.faces)} faces, the open shape ` +
        `${count(mesh.vertices)} and ${count(mesh.faces)}. A key must be a pose of the same mesh.`,
    );
  }
  const other = firstOtherFace(faces, open.faces);
  if (other >= 0) {
    throw new Error(
      `${name} has different faces than the open shape, from face ${other + 1} on. A key must be a pose of the same mesh.`,
    );
  }
}
