/**
 * npm run bench -- hold FILE... [--save]: compares captured animations with motions through every n-th frame: as
 * published, with holding, and as a vertex cubic. Then measures frame times of these methods and of pins. For a folder
 * of single poses instead of an animation, only frame times.
 */
import { readFile, readdir, stat } from 'node:fs/promises';
import path from 'node:path';
import type { Engine, Sequence } from '../../web/engine/api/api.ts';
import { createEngine } from '../../web/engine/node.ts';
import type { InputFile, MotionOptions } from '../../web/engine/api/types.ts';
import { KgError } from '../../web/engine/timing/kg-error.ts';
import { readReference } from '../../web/study/reference-motion.ts';
import { poseFiles } from '../engine/support/glb.ts';
import { frameOf } from './frames.ts';
import { short, table } from './format.ts';
import { quantile } from './quantile.ts';
import { aligned, Sliding, walkedOn } from './reference-errors.ts';

/** Frames of the animation between keys. */
const STEPS = [5, 8, 10];
const FEWEST_KEYS = 4;
/** Frames per motion, alternating. */
const ROUNDS = 60;

const MOTIONS = {
  'vertex cubic': { method: 'cubic-vertex', hold: 'off' },
  plain: { method: 'lri', hold: 'off' },
  held: { method: 'lri', hold: 'on' },
} as const satisfies Record<string, Partial<MotionOptions>>;
type Name = keyof typeof MOTIONS;
const NAMES = Object.keys(MOTIONS) as Name[];

/** Errors in percent; `sliding` in percent of the diagonal, NaN if no vertex rests. */
interface Errors {
  raw: number;
  aligned: number;
  sliding: number;
}

interface Run {
  name: string;
  errors: Record<Name, Errors>;
}

/** Frame time in milliseconds, and relative to the plain motion. */
interface Costs {
  name: string;
  plainMs: number;
  ratios: Record<string, number>;
}

/** A densely sampled sequence of shapes. */
interface Captured {
  title: string;
  faces: Uint32Array;
  /** Times in seconds. */
  times: readonly number[];
  /** Shape at each time, 3 x vertices. */
  shapes: Float32Array[];
}

export async function holdTables(files: readonly string[], say: (what: string) => void): Promise<string> {
  const runs: Run[] = [];
  const costs: Costs[] = [];
  for (const file of files) {
    const engine = createEngine();
    try {
      const input = await filesOf(file);
      for (const captured of await readAll(engine, input)) {
        say(captured.title);
        for (const step of STEPS.filter((one) => captured.times.length > (FEWEST_KEYS - 1) * one))
          runs.push(await compare(engine, captured, step));
      }
      say(`${path.basename(file)}, frames`);
      costs.push(await timed(engine, input, path.basename(file)));
    } finally {
      engine.dispose();
    }
  }
  return [errorTable(runs), meansOf(runs), costTable(costs)].join('\n\n');
}

/** A file, or the files of a folder in numerical order. */
async function filesOf(file: string): Promise<InputFile[]> {
  const isFolder = (await stat(file)).isDirectory();
  const paths = isFolder ? (await readdir(file)).map((name) => path.join(file, name)) : [file];
  paths.sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
  return Promise.all(
    paths.map(async (one) => ({ name: path.basename(one), bytes: new Uint8Array(await readFile(one)) })),
  );
}

/** Reads all animations. An animation that walks in place is followed by the same one walking forwards. */
async function readAll(engine: Engine, input: InputFile[]): Promise<Captured[]> {
  const { info } = await engine.importKeyframes(input);
  const { vertices, diagonal } = info.report;
  const all: Captured[] = [];
  for (const [index, animation] of info.animations.entries()) {
    const reference = await readReference(engine, input, index, animation, vertices, {});
    const { times, keys } = reference;
    const shapes = times.map((_, i) => keys.positions(i).slice());
    reference.dispose();
    const captured = { title: `${input[0]!.name}, ${animation.name}`, faces: info.faces, times, shapes };
    const onward = walkedOn(shapes, diagonal);
    all.push(captured, ...(onward ? [{ ...captured, title: `${captured.title}, walking on`, shapes: onward }] : []));
  }
  return all;
}

async function compare(engine: Engine, { title, faces, times, shapes }: Captured, step: number): Promise<Run> {
  const isKey = (_: unknown, i: number): boolean => i % step === 0;
  const poses = shapes.filter(isKey);
  const mesh = { positions: shapes[0]!, indices: faces };
  const keys = await engine.importKeyframes(poseFiles(mesh, poses));
  const sequence = await engine.createSequence(keys, keys.info.project ?? {});
  const keyTimes = times.filter(isKey);
  const { diagonal } = keys.info.report;
  const errors = {} as Record<Name, Errors>;
  for (const name of NAMES) {
    await sequence.update({ ...MOTIONS[name], keyTimes });
    const [raw, turned, sliding] = [new KgError(), new KgError(), new Sliding(diagonal)];
    for (let i = 0; i <= (poses.length - 1) * step; i += 1) {
      const reference = shapes[i]!;
      const frame = await frameOf(sequence.evaluate(times[i]!));
      raw.add(reference, frame.positions);
      turned.add(reference, aligned(frame.positions, reference));
      sliding.add(reference, frame.positions, i % step === 0);
      frame.release();
    }
    errors[name] = { raw: raw.percent, aligned: turned.percent, sliding: sliding.percent };
  }
  sequence.dispose();
  keys.dispose();
  return { name: `${title}, every ${step}th`, errors };
}

const PINNED = [0.1, 0.5, 0.9];

async function timed(engine: Engine, input: InputFile[], name: string): Promise<Costs> {
  const keys = await engine.importKeyframes(input, input.length === 1 ? { sample: 8 } : {});
  const { vertices } = keys.info.report;
  const pins = PINNED.map((share) => ({ vertex: Math.floor(share * vertices), radius: 0.05 }));
  const motions: Record<string, Partial<MotionOptions>> = {
    plain: {},
    held: { hold: 'on' },
    'one pin': { pins: pins.slice(0, 1) },
    'three pins': { pins },
    'three pins, held': { pins, hold: 'on' },
  };
  const sequences: [string, Sequence][] = [];
  for (const [title, options] of Object.entries(motions))
    sequences.push([title, await engine.createSequence(keys, { ...keys.info.project, hold: 'off', ...options })]);
  const ms = new Map<string, number[]>(sequences.map(([title]) => [title, []]));
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const [title, sequence] of sequences) {
      const [first, last] = sequence.range;
      const frame = await frameOf(sequence.evaluate(first + ((round + 0.5) / ROUNDS) * (last - first)));
      ms.get(title)!.push(frame.ms);
      frame.release();
    }
  }
  for (const [, sequence] of sequences) sequence.dispose();
  keys.dispose();
  const plain = ms.get('plain')!;
  const ratios = Object.fromEntries(
    [...ms].map(([title, list]) => [title, quantile(list.map((value, round) => value / plain[round]!))]),
  );
  return { name: `${name}, ${vertices} vertices`, plainMs: quantile(plain), ratios };
}

const cell = ({ raw, aligned: rigid, sliding }: Errors): string => [raw, rigid, sliding].map(short).join(' / ');

function errorTable(runs: readonly Run[]): string {
  const rows = runs.map(({ name, errors }) => [name, ...NAMES.map((one) => cell(errors[one]))]);
  return `KG error in %, KG error with every frame aligned, and sliding in % of the diagonal:\n\n${table(['', ...NAMES], rows)}`;
}

/** Geometric mean, minimum and maximum of the ratios to the plain motion. */
function meansOf(runs: readonly Run[]): string {
  const text = (ratios: number[]): string => {
    const known = ratios.filter((ratio) => Number.isFinite(ratio) && ratio > 0);
    const mean = Math.exp(known.reduce((sum, ratio) => sum + Math.log(ratio), 0) / known.length);
    return `${short(mean)} [${short(Math.min(...known))}, ${short(Math.max(...known))}]`;
  };
  const over = (name: Name, part: keyof Errors): string =>
    text(runs.map(({ errors }) => errors[name][part] / errors.plain[part]));
  const parts = ['raw', 'aligned', 'sliding'] as const;
  const rows = NAMES.filter((name) => name !== 'plain').map((name) => [name, ...parts.map((part) => over(name, part))]);
  const titles = ['over plain', 'KG error', 'aligned', 'sliding'];
  return `Geometric means [least, largest] over ${runs.length} runs:\n\n${table(titles, rows)}`;
}

function costTable(costs: readonly Costs[]): string {
  const titles = Object.keys(costs[0]?.ratios ?? {}).filter((title) => title !== 'plain');
  const rows = costs.map(({ name, plainMs, ratios }) => [
    name,
    short(plainMs),
    ...titles.map((title) => short(ratios[title]!)),
  ]);
  return `Median frame times in wasm, with all motions measured in turn. The plain motion is in milliseconds, the others are relative to it:\n\n${table(['', 'plain', ...titles], rows)}`;
}
