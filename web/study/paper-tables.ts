/** The paper's tables of costs, measured for a shape and as published. Seconds. */
import type { Engine, Keys, Motion } from '../engine/api/api.ts';
import { fitCount } from '../engine/api/methods.ts';
import { EngineError, isCancelled } from '../engine/api/errors.ts';
import { MOTION } from '../engine/api/option-table.ts';
import { fittedCount, unfittedNote } from './fitted-intervals.ts';
import { studyGhosts, studyTimes } from './ghost-study.ts';
import type { GhostRow } from './ghost-study.ts';

/** Time on the ghost mesh, for the deformation transfer, and without a ghost mesh. */
export interface Costs {
  ghost: number;
  transfer: number;
  full: number;
}

/** Costs of one shape of a motion. */
export interface Table1Row extends Costs {
  source: Source;
  model: string;
  faces: number;
}

/** Costs of a motion of `shapes` shapes. `share`: share of the vertices that are left on the ghost mesh. */
export interface Table2Row {
  source: Source;
  model: string;
  faces: number;
  shapes: number;
  share: number;
  /** Costs of the spline in the space of shells, [2] in the paper. */
  shell: Costs;
  lri: Costs;
  /** Why a time is missing, or what differs; empty if nothing. */
  note: string;
}

export type Source = 'paper' | 'here';

const published = (model: string, faces: number, ghost: number, transfer: number, full: number): Table1Row => ({
  ...{ source: 'paper', model, faces, ghost, transfer, full },
});

export const TABLE_1: readonly Table1Row[] = [
  published('cactus', 10e3, 0.013, 0.014, 0.25),
  published('handstand', 20e3, 0.016, 0.022, 0.6),
  published('human', 25e3, 0.021, 0.029, 0.65),
  published('centaur', 32e3, 0.025, 0.038, 0.75),
  published('elephant', 80e3, 0.024, 0.053, 1.29),
  published('armadillo', 233e3, 0.027, 0.46, 6.5),
  published('armadillo', 1.3e6, 0.039, 2.862, 37.2),
];

type Times = [ghost: number, transfer: number, full: number];
const costs = ([ghost, transfer, full]: Times): Costs => ({ ghost, transfer, full });
const compared = (model: string, shapes: number, share: number, shell: Times, lri: Times): Table2Row => ({
  ...{ source: 'paper', model, faces: NaN, shapes, share, shell: costs(shell), lri: costs(lri), note: '' },
});

export const TABLE_2: readonly Table2Row[] = [
  compared('cactus', 20, 0.05, [1.7, 1.7, 83], [0.16, 1.0, 4.35]),
  compared('cactus', 170, 0.05, [22, 14, 762], [0.31, 3.2, 23.9]),
  compared('horse', 40, 0.1, [22, 5, 238], [0.35, 2.2, 11.4]),
  compared('armadillo', 50, 0.006, [80, 200, NaN], [1.34, 47.2, 258.6]),
];

/** Rows for shapes that the paper does not have. */
const USUAL: readonly Pick<Table2Row, 'shapes' | 'share'>[] = [{ shapes: 20, share: 0.05 }];
/** Faces of the ghost mesh in Table 1. */
const GHOST_FACES = 2000;

/** The model of the paper that a file's name contains, or null. */
export function modelOf(names: readonly string[]): string | null {
  const known = new Set([...TABLE_1, ...TABLE_2].map(({ model }) => model));
  return [...known].find((model) => names.some((name) => name.toLowerCase().includes(model))) ?? null;
}

export interface Tables {
  table1: Table1Row[];
  table2: Table2Row[];
}

/** The paper's rows of a model, each table followed by those measured here. `model`: null for any other shape. */
export async function measureTables(engine: Engine, keys: Keys, model: string | null): Promise<Tables> {
  const { faces } = keys.info.report;
  const known = TABLE_2.filter((row) => row.model === model);
  const wanted = known.length > 0 ? known : USUAL;
  const sizes = [...new Set([GHOST_FACES, ...wanted.map(({ share }) => Math.round(share * faces))])];
  const times = studyTimes(keys.info.times[0]!, keys.info.times.at(-1)!);
  const ghosts = await studyGhosts(engine, keys, {}, { times, sizes, transfers: ['paper'] });
  const costsOf = (size: number): Costs => {
    const row = ghosts.rows.find((one) => one.wanted === size);
    return { ...splitOf(row), full: ghosts.ms / 1000 };
  };
  const here = { source: 'here', model: model ?? 'shape', faces } as const;
  const table2: Table2Row[] = [];
  for (const { shapes, share } of wanted) {
    const lri = scaled(costsOf(Math.round(share * faces)), shapes);
    table2.push({ ...here, shapes, share, lri, ...(await shellCosts(engine, keys, shapes, share)) });
  }
  return {
    table1: [...TABLE_1.filter((row) => row.model === model), { ...here, ...costsOf(GHOST_FACES) }],
    table2: [...known, ...table2],
  };
}

function splitOf(row: GhostRow | undefined): Omit<Costs, 'full'> {
  if (!row) return { ghost: NaN, transfer: NaN };
  // A frame computes the ghost mesh's shape and then follows it.
  return { ghost: row.ghostMs / 1000, transfer: Math.max(row.ms - row.ghostMs, 0) / 1000 };
}

const scaled = ({ ghost, transfer, full }: Costs, by: number): Costs => costs([by * ghost, by * transfer, by * full]);

const FITTING = 'fitting lengths';
const NONE: Costs = { ghost: NaN, transfer: NaN, full: NaN };

/** Costs of [2] measured here: the time of the fits, and of everything else up to the last shape. */
async function shellCosts(
  engine: Engine,
  keys: Keys,
  shapes: number,
  share: number,
): Promise<Pick<Table2Row, 'shell' | 'note'>> {
  const { faces } = keys.info.report;
  const { spaceFaces, spaceSamples } = MOTION;
  const coarse = Math.min(Math.max(Math.round(share * faces), spaceFaces.min), spaceFaces.max);
  const samples = Math.min(shapes, spaceSamples.max);
  const start = performance.now();
  let fitting = { from: NaN, to: NaN };
  const onProgress = ({ stage }: { stage: string }): void => {
    const now = performance.now();
    if (stage === FITTING) fitting = { from: Number.isNaN(fitting.from) ? now : fitting.from, to: now };
  };
  try {
    const options = { method: 'shell', spaceFaces: coarse, spaceSamples: samples } as const;
    const sequence = await engine.createSequence(keys, options, { onProgress });
    const [first, last] = sequence.range;
    for (let i = 0; i < shapes; i += 1) {
      const [frame] = await sequence.evaluateMany([first + ((last - first) * i) / (shapes - 1)]);
      frame!.release();
    }
    sequence.dispose();
    const unfitted = unfittedNote(sequence);
    if (fittedCount(sequence) === 0) return { shell: NONE, note: `[2]: ${unfitted}` };
    const fit = (fitting.to - fitting.from) / 1000;
    const all = (performance.now() - start) / 1000;
    return { shell: { ghost: fit, transfer: all - fit, full: NaN }, note: noteOf(coarse, sequence, shapes, unfitted) };
  } catch (error) {
    if (!(error instanceof EngineError) || isCancelled(error)) throw error;
    return { shell: NONE, note: error.message };
  }
}

function noteOf(coarse: number, { keyTimes, options }: Motion, shapes: number, unfitted: string): string {
  const times = keyTimes.length + fitCount(keyTimes.length, options);
  const fewer = times <= shapes ? ` instead of ${shapes}` : '';
  return `[2] on ${coarse} faces at ${times} times${fewer}${unfitted && `, ${unfitted}`}`;
}
