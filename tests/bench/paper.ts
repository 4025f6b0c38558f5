/** The paper's Tables 1 and 2 in the same layout, with our own numbers. */
import { CLOCK_MS, msText, short, table } from './format.ts';
import type { GhostFrames } from './ghost-frames.ts';
import type { Run } from './measure.ts';
import type { Motion, MotionRun } from './whole-sequences.ts';

/** The machine of the paper's measurements (section 5). */
export const PAPER_MACHINE = 'Intel Core i7-3770 at 3.40 GHz, C/C++';

interface Times {
  /** Interpolation and reconstruction on the ghost mesh; deformation transfer; total without a ghost. */
  ir: number;
  ts: number;
  o: number;
}

/** Times in seconds, as printed. */
const TABLE_1: readonly ({ model: string; faces: number } & Times)[] = [
  { model: 'Cactus (10K)', faces: 10_000, ir: 0.013, ts: 0.014, o: 0.25 },
  { model: 'Handstand (20K)', faces: 20_000, ir: 0.016, ts: 0.022, o: 0.6 },
  { model: 'Human (25K)', faces: 25_000, ir: 0.021, ts: 0.029, o: 0.65 },
  { model: 'Centaur (32K)', faces: 32_000, ir: 0.025, ts: 0.038, o: 0.75 },
  { model: 'Elephant (80K)', faces: 80_000, ir: 0.024, ts: 0.053, o: 1.29 },
  { model: 'Armadillo (332K)', faces: 332_000, ir: 0.027, ts: 0.46, o: 6.5 },
  { model: 'Armadillo (1.3M)', faces: 1_300_000, ir: 0.039, ts: 2.862, o: 37.2 },
];

export interface Table2Row extends Motion {
  model: string;
  /** Seconds, as printed, for the paper's reference method and its own; NaN if the method failed. */
  other: Times;
  paper: Times;
}

/**
 * The paper does not give the horse's number of faces; one of its shapes takes slightly longer than one of the cactus.
 */
export const TABLE_2: readonly Table2Row[] = [
  {
    model: 'Cactus',
    faces: 10_000,
    shapes: 20,
    fraction: 0.05,
    other: { ir: 1.7, ts: 1.7, o: 83 },
    paper: { ir: 0.16, ts: 1, o: 4.35 },
  },
  {
    model: 'Cactus',
    faces: 10_000,
    shapes: 170,
    fraction: 0.05,
    other: { ir: 22, ts: 14, o: 762 },
    paper: { ir: 0.31, ts: 3.2, o: 23.9 },
  },
  {
    model: 'Horse',
    faces: 12_000,
    shapes: 40,
    fraction: 0.1,
    other: { ir: 22, ts: 5, o: 238 },
    paper: { ir: 0.35, ts: 2.2, o: 11.4 },
  },
  {
    model: 'Armadillo',
    faces: 332_000,
    shapes: 50,
    fraction: 0.006,
    other: { ir: 80, ts: 200, o: NaN },
    paper: { ir: 1.34, ts: 47.2, o: 258.6 },
  },
];

/** The times per shape, in milliseconds. */
function partsOf({ irMs, tsMs }: GhostFrames, shapes: number): Pick<Times, 'ir' | 'ts'> {
  return { ir: irMs / shapes, ts: tsMs / shapes };
}

const inMs = ({ ir, ts, o }: Times): Times => ({ ir: 1000 * ir, ts: 1000 * ts, o: 1000 * o });

/** Ratio of the paper's time to ours; a lower bound if ours is below the clock's resolution. */
export function timesFaster(paperMs: number, ourMs: number): string {
  return ourMs < CLOCK_MS ? `> ${short(paperMs / CLOCK_MS)}` : short(paperMs / ourMs);
}

/** The paper's Table 1 with our times per shape in milliseconds; null if no measured size is in the table. */
export function table1(runs: Run[]): string | null {
  const columns = TABLE_1.flatMap((row) => {
    const run = runs.find(({ faces }) => Math.abs(faces - row.faces) < 0.03 * row.faces);
    return run ? [{ model: row.model, paper: inMs(row), run }] : [];
  });
  if (columns.length === 0) return null;
  const ours = columns.map(
    ({ run: { withGhost, exact } }): Times => ({
      ...(withGhost ? partsOf(withGhost, withGhost.shapes) : { ir: NaN, ts: NaN }),
      o: exact.stages.median,
    }),
  );
  const rows = (name: string, of: (times: Times) => number): string[][] => [
    [`${name}, paper`, ...columns.map(({ paper }) => msText(of(paper)))],
    [`${name}, here`, ...ours.map((times) => msText(of(times)))],
  ];
  const faster = (of: (times: Times) => number): string[] => [
    'paper / here',
    ...columns.map(({ paper }, i) => timesFaster(of(paper), of(ours[i]!))),
  ];
  const withGhost = ({ ir, ts }: Times): number => ir + ts;
  return table(
    ['', ...columns.map(({ model }) => model)],
    [
      ...rows('t_ir', ({ ir }) => ir),
      ...rows('t_ts', ({ ts }) => ts),
      ...rows('t_ir + t_ts', withGhost),
      faster(withGhost),
      ...rows('t_o', ({ o }) => o),
      faster(({ o }) => o),
    ],
  );
}

/** Whole motions, in milliseconds. */
export function table2(results: { row: Table2Row; run: MotionRun }[]): string {
  const three = ({ ir, ts, o }: Times): string[] => [ir, ts, o].map(msText);
  return table(
    [
      'Model (K, γ)',
      'in [2]: t_ir',
      't_ts',
      't_o',
      'paper: t_ir',
      't_ts',
      't_o',
      'here: t_ir',
      't_ts',
      't_o',
      'built once, with ghost',
      'without',
    ],
    results.map(({ row, run: { withGhost, buildMs, wholeMs } }) => [
      `${row.model} (${row.shapes}, ${row.fraction})`,
      ...three(inMs(row.other)),
      ...three(inMs(row.paper)),
      ...three({ ...partsOf(withGhost, 1), o: wholeMs }),
      msText(withGhost.buildMs),
      msText(buildMs),
    ]),
  );
}
