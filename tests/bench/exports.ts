/**
 * npm run bench -- exports [FACES,... --save]: file size of an exported animation, and its cost in three.js and
 * Babylon.js. Compares the old layout (every frame a target, one vertex buffer for all primitives), the default, and
 * compression.
 */
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import { messageOf } from '../../web/engine/api/errors.ts';
import type { ExportOptions } from '../../web/engine/api/types.ts';
import { withEngine } from '../../web/engine/node.ts';
import { keysOf, type ExportShape } from './export-shapes.ts';
import { short, table } from './format.ts';
import type { Loaded } from './load-babylon.ts';
import { sharingVertices } from './old-layout.ts';
import { inBabylon, inThree, type InThree, type Played } from './players.ts';

const DEFAULT_FACES = [23_000, 84_000];
const PARTS = 12;
const FRAMES = [60, 240, 1000];

interface Row {
  shape: ExportShape;
  frames: number;
  how: string;
  /** A message if there is no file. */
  written: { targets: number; bytes: number } | string;
  three: Played<InThree>;
  babylon: Played<Loaded>;
}

/** Whole frames from the first key, at 0, to the last, at 1. */
const few = (frames: number): Partial<ExportOptions> => ({ fps: frames - 1 });

interface Way {
  how: string;
  /** Whether each material has a primitive with separate vertices. */
  compact: boolean;
  options(frames: number): Partial<ExportOptions>;
}

const WAYS: Way[] = [
  { how: 'before', compact: false, options: (frames) => ({ frames, tolerance: 0 }) },
  { how: 'now', compact: true, options: few },
  { how: 'meshopt', compact: true, options: (frames) => ({ ...few(frames), compression: 'meshopt' }) },
];

/** Folders of the repository and the files, and the mesh generator. */
export interface Place {
  repository: string;
  folder: string;
  meshOf(faces: number): Uint8Array;
  say(what: string): void;
}

async function write(sequence: Sequence, shape: ExportShape, way: Way, frames: number): Promise<Uint8Array> {
  const [file] = await sequence.export(way.options(frames));
  const { bytes } = file!;
  return way.compact || shape.parts === 1 ? bytes : sharingVertices(bytes, shape.parts);
}

const targetsOf = (bytes: Uint8Array): number => {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as {
    meshes: { primitives: { targets: object[] }[] }[];
  };
  return json.meshes[0]!.primitives[0]!.targets.length;
};

async function rowOf(place: Place, sequence: Sequence, shape: ExportShape, way: Way, frames: number): Promise<Row> {
  const file = path.join(place.folder, 'export.glb');
  const row = { shape, frames, how: way.how };
  try {
    const bytes = await write(sequence, shape, way, frames);
    writeFileSync(file, bytes);
    const written = { targets: targetsOf(bytes), bytes: bytes.length };
    const babylon = await inBabylon(file);
    return { ...row, written, babylon, three: await inThree(place.repository, file) };
  } catch (error) {
    return { ...row, written: messageOf(error), three: '', babylon: '' };
  } finally {
    rmSync(file, { force: true });
  }
}

async function rowsOf(engine: Engine, place: Place, shape: ExportShape): Promise<Row[]> {
  const { asParts, asOne } = await keysOf(engine, place.meshOf(shape.faces), shape.parts);
  const compact = await engine.createSequence(asParts);
  const shared = asOne === asParts ? compact : await engine.createSequence(asOne);
  const rows: Row[] = [];
  for (const frames of FRAMES)
    for (const way of WAYS) {
      place.say(`${shape.name}, ${frames} frames, ${way.how}`);
      const row = await rowOf(place, way.compact ? compact : shared, shape, way, frames);
      place.say(`  ${cellsOf(row).slice(3).join(' | ')}`);
      rows.push(row);
    }
  for (const one of new Set([compact, shared])) one.dispose();
  return rows;
}

const megabytes = (value: number): string => (value < 10 ? value.toFixed(1) : value.toFixed(0));

function cellsOf({ shape, frames, how, written, three, babylon }: Row): string[] {
  const start = [shape.name, String(frames), how];
  if (typeof written === 'string') return [...start, written, '', '', '', '', '', '', ''];
  const inThree =
    typeof three === 'string'
      ? [three, '', '', '']
      : [
          short(three.seconds),
          typeof three.firstFrame === 'string' ? three.firstFrame : short(three.firstFrame),
          megabytes(three.textureMB),
          megabytes(three.memoryMB),
        ];
  const inBabylon = typeof babylon === 'string' ? [babylon, ''] : [short(babylon.seconds), megabytes(babylon.memoryMB)];
  return [...start, String(written.targets), megabytes(written.bytes / 1e6), ...inThree, ...inBabylon];
}

const TITLES = [
  'shape',
  'frames',
  'file',
  'targets',
  'file MB',
  'three.js: load s',
  'first picture s',
  'morph textures MB',
  'memory MB',
  'Babylon.js: load s',
  'memory MB',
];

/** Resolves to the table, as Markdown. */
export function exportTable(place: Place, faces: readonly number[] | null): Promise<string> {
  const sizes = faces ?? DEFAULT_FACES;
  const shapes = [
    ...sizes.map((count) => ({ name: `${short(count / 1000)}K faces`, faces: count, parts: 1 })),
    { name: `${short(sizes[0]! / 1000)}K faces, ${PARTS} primitives`, faces: sizes[0]!, parts: PARTS },
  ];
  mkdirSync(place.folder, { recursive: true });
  return withEngine(async (engine) => {
    const rows: Row[] = [];
    for (const shape of shapes) rows.push(...(await rowsOf(engine, place, shape)));
    return table(TITLES, rows.map(cellsOf));
  });
}
