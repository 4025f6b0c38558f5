/** Generated motions to export: one closed body, whole or in bands with one material each. */
import type { Engine, Keys } from '../../web/engine/api/api.ts';
import type { InputFile } from '../../web/engine/api/types.ts';

export interface ExportShape {
  name: string;
  faces: number;
  parts: number;
}

/** Faces sorted by height in the first key, so parts of equal size form bands. */
function byHeight(keys: Keys): Uint32Array {
  const first = keys.positions(0);
  const { faces } = keys.info;
  const height = (face: number): number => [0, 1, 2].reduce((sum, c) => sum + first[3 * faces[3 * face + c]! + 2]!, 0);
  const order = Array.from({ length: faces.length / 3 }, (_, face) => ({ face, height: height(face) }));
  order.sort((a, b) => a.height - b.height);
  return Uint32Array.from(order.flatMap(({ face }) => [...faces.subarray(3 * face, 3 * face + 3)]));
}

const rows = (word: string, values: ArrayLike<number>, add = 0): string[] =>
  Array.from(
    { length: values.length / 3 },
    (_, i) => `${word} ${values[3 * i]! + add} ${values[3 * i + 1]! + add} ${values[3 * i + 2]! + add}`,
  );

/** The keys as OBJ files; `parts`: number of bands with one material each. */
function objFiles(keys: Keys, parts: number): InputFile[] {
  const encode = (lines: string[]): Uint8Array => new TextEncoder().encode(lines.join('\n'));
  const faces = rows('f', byHeight(keys), 1);
  const starts = Array.from({ length: parts }, (_, part) => Math.round((part * faces.length) / parts));
  const banded = starts.flatMap((start, part) => [`usemtl band${part}`, ...faces.slice(start, starts[part + 1])]);
  const colours = starts.flatMap((_, part) => [`newmtl band${part}`, `Kd ${part / parts} 0.5 ${1 - part / parts}`]);
  return [
    ...keys.info.names.map((_, key) => ({
      name: `key-${key + 1}.obj`,
      bytes: encode(['mtllib bands.mtl', ...rows('v', keys.positions(key)), ...(parts > 1 ? banded : faces)]),
    })),
    { name: 'bands.mtl', bytes: encode(colours) },
  ];
}

/** Keys with faces sorted by band; with the materials of their parts, or as a single part. */
export async function keysOf(engine: Engine, mesh: Uint8Array, parts: number): Promise<{ asParts: Keys; asOne: Keys }> {
  const whole = await engine.importKeyframes([{ name: 'bench.glb', bytes: mesh }]);
  if (parts === 1) return { asParts: whole, asOne: whole };
  return {
    asParts: await engine.importKeyframes(objFiles(whole, parts)),
    asOne: await engine.importKeyframes(objFiles(whole, 1)),
  };
}
