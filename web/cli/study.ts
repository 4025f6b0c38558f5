/** The study commands: tables that compare sizes of a ghost mesh, methods, and the paper's costs. */
import { cpus } from 'node:os';
import { version } from '../../package.json';
import type { Engine, Keys } from '../engine/api/api.ts';
import { validationError } from '../engine/api/options.ts';
import { ENCODING } from '../engine/api/option-table.ts';
import { METHODS, OWN_METHOD } from '../engine/api/methods.ts';
import { encodingOf } from '../engine/api/options.ts';
import { SEQUENCE_DEFAULTS, type Method, type SequenceOptions } from '../engine/api/types.ts';
import { withEngine } from '../engine/node.ts';
import { GHOST_SIZES, studyGhosts, studyTimes } from '../study/ghost-study.ts';
import { tableJson } from '../study/motion-measures.ts';
import { measureTables, modelOf } from '../study/paper-tables.ts';
import type { Costs, Tables } from '../study/paper-tables.ts';
import { studySpaces } from '../study/space-study.ts';
import type { OtherFrames, ReferenceShapes } from '../study/space-study.ts';
import { BETWEEN_VALUES, UsageError, type Arguments } from './arguments.ts';
import { readInputs } from './input.ts';
import { checkedFiles } from './commands.ts';
import { comparedTimes, comparisonWarnings, handOut } from './measure.ts';
import type { Measured } from './measure.ts';
import { againstOptions, importOptions, measuredMethods, sequenceOptions, withProject } from './settings.ts';
import { readReference } from './reference-animation.ts';
import { fittedRegions, fittedTiming, type FittedTiming, type Source } from './timing.ts';
import * as read from './values.ts';

type Cell = string | number;

/** A table with a sentence about each column. */
interface StudyTable {
  columns: Readonly<Record<string, string>>;
  rows: Cell[][];
  warnings?: string[];
  /** Further lines of the header. */
  notes?: string[];
}

type Study = (source: Source) => Promise<StudyTable>;

export function studyGhost(args: Arguments): Promise<Measured> {
  const sizes = ghostSizes(args);
  return run(args, async ({ engine, keys }) => {
    const { faces } = keys.info.report;
    const [first, last] = [keys.info.times[0]!, keys.info.times.at(-1)!];
    const left: string[] = [];
    const options = withProject(keys.info.project, sequenceOptions(args), (warning) => left.push(warning));
    const found = await studyGhosts(engine, keys, options, { times: studyTimes(first, last), sizes });
    const refused = sizes.filter((size) => size >= faces);
    return {
      columns: GHOST_COLUMNS,
      rows: [
        [faces, faces, 'none', found.ms > 0 ? 0 : NaN, found.ms, found.buildMs, found.fits.note],
        ...found.rows.map((row): Cell[] => [
          ...[row.wanted, row.faces, row.transfer, row.kg, row.ms, row.buildMs, row.fits.note],
        ]),
        ...refused.map((size): Cell[] => [size, NaN, '', NaN, NaN, NaN, `the shape has only ${faces} faces`]),
      ],
      warnings: [
        ...left,
        ...found.fits.warnings,
        ...found.rows.flatMap(({ wanted, fits }) => fits.warnings.map((one) => `${wanted} faces: ${one}`)),
      ],
    };
  });
}

const GHOST_COLUMNS = {
  'wanted faces': 'requested number of faces of the ghost mesh; the first row is the motion without one',
  'ghost faces': 'number of faces of the ghost mesh',
  transfer: 'how the shape follows the ghost mesh: exact or paper',
  'KG error': 'Karni-Gotsman error against the motion without a ghost mesh, %',
  'frame time': 'median time of a frame, ms',
  'build time': 'time from the keys until the first frame can be computed, ms',
  note:
    'why there are no numbers, or between which keys the method fitted no shapes; the row is measured in the other ' +
    'intervals only',
};

function ghostSizes(args: Arguments): number[] {
  const text = args.values.get('sizes');
  if (text === undefined) return [...GHOST_SIZES];
  return text.split(',').map((word) => {
    const size = read.wholeFrom(ENCODING.ghostFaces.min)(word, '--sizes');
    const wrong = validationError(ENCODING.ghostFaces, size);
    if (wrong) throw new UsageError(`--sizes: ${wrong}`);
    return size;
  });
}

export function studyMethods(args: Arguments): Promise<Measured> {
  const methods: readonly Method[] = args.values.has('methods') ? measuredMethods(args) : METHODS;
  const against = args.values.get('against')?.split(BETWEEN_VALUES) ?? [];
  const own = againstOptions(args);
  if (against.length === 0 && Object.keys(own).length > 0)
    throw new UsageError('--against-up and --against-unit require --against');
  const regions = fittedRegions(args);
  if (regions > 0 && !methods.includes(OWN_METHOD))
    throw new UsageError(`--fit-timing requires ${OWN_METHOD} among --methods`);
  const folders = frameFolders(args, against);
  return run(args, async (source) => {
    const { engine, keys } = source;
    const { reference, warnings } = await referenceOf(args, engine, keys, against);
    const options = { ...SEQUENCE_DEFAULTS, ...sequenceOptions(args), method: OWN_METHOD };
    const timing = regions > 0 ? await timingOf(source, options, regions) : null;
    const others: OtherFrames[] = [];
    for (const [name, folder] of folders)
      others.push({ name, shapes: await framesOf(args, source, folder, reference!.times.length) });
    const rows = await studySpaces(engine, keys, sequenceOptions(args), {
      ...{ methods, reference, others },
      // Without regions, no timing lowered the error, as a note says.
      timing: timing && timing.options.regions.length > 0 ? timing.options : null,
    });
    return {
      columns: SPACE_COLUMNS,
      rows: rows.map((row): Cell[] => [
        ...[
          row.method,
          row.isTimed ? args.values.get('fit-timing')! : 'off',
          row.fitted ?? NaN,
          row.volume,
          row.area,
          row.lengths,
          row.conformal,
          row.bending,
          row.peak,
          row.kg,
          row.largest,
          row.ms,
          row.buildMs,
        ],
        row.note,
      ]),
      warnings: [...warnings, ...rows.flatMap(({ method, warnings: own }) => own.map((one) => `${method}: ${one}`))],
      notes: timing ? [timing.text] : [],
    };
  });
}

const SPACE_COLUMNS = {
  method:
    'the method; all columns from volume to largest bending are measured at 48 times between the first and the last key',
  timing: 'what --fit-timing fitted to the animation from which the keys are taken',
  'intervals fitted':
    'number of intervals between keys with shapes that the method fitted; the row is measured in these only, and is empty ' +
    'without any; no number for methods that fit no shapes',
  volume: "largest difference from the natural spline of the keys' volumes, %; empty for open surfaces",
  area: "largest difference from the natural spline of the keys' areas, %",
  'edge lengths':
    'how far edge lengths deviate from the natural spline of their lengths in the keys, in % of the length in that spline ' +
    '(root mean square over edges and times)',
  'conformal distortion':
    "tr A'A / det A - 2, with the 2 x 2 gradient A of a face from the first key; mean over faces by their areas in that " +
    'key, and over time; 0 if every face keeps its angles',
  bending:
    'mean over time of the bending energy computed from edge lengths and angles (measure --shell-bending), 1/s^4',
  'largest bending': 'largest value of this bending energy, 1/s^4',
  'KG error': 'Karni-Gotsman error against the animation of --against, at its frames, %',
  'largest distance': "largest distance of a vertex from that animation, % of the diagonal of the keys' bounding box",
  'frame time': 'median time of a frame, ms',
  'build time': 'time from the keys until the first frame can be computed, ms',
  note: 'why the method cannot move this shape, or between which keys it fitted no shapes',
};

async function referenceOf(
  args: Arguments,
  engine: Engine,
  keys: Keys,
  against: string[],
): Promise<{ reference: ReferenceShapes | null; warnings: string[] }> {
  if (against.length === 0) return { reference: null, warnings: [] };
  const reference = await readReference(
    engine,
    keys,
    await readInputs(against),
    importOptions(args),
    againstOptions(args),
  );
  const sequence = await engine.createSequence(keys);
  const compared = await comparedTimes(sequence, reference, {}, against[0]!);
  const warnings = await comparisonWarnings(sequence, compared, reference);
  sequence.dispose();
  return { reference: { times: compared.times, shapes: compared.frames.map((frame) => frame!) }, warnings };
}

async function timingOf(source: Source, options: SequenceOptions, regions: number): Promise<FittedTiming> {
  const shape = await source.engine.encode(source.keys, encodingOf(options));
  return fittedTiming(source, shape, options, regions).finally(() => shape.dispose());
}

/** The folders of --frames-of, by their names. */
function frameFolders(args: Arguments, against: readonly string[]): [name: string, folder: string][] {
  const given = args.values.get('frames-of')?.split(BETWEEN_VALUES) ?? [];
  if (given.length > 0 && against.length === 0) throw new UsageError('--frames-of requires --against');
  return given.map((text) => {
    const [, name, folder] = /^([^=]+)=(.+)$/.exec(text) ?? [];
    if (name === undefined || folder === undefined)
      throw new UsageError(`--frames-of requires a name and a folder, such as mine=frames/, not '${text}'`);
    return [name, folder];
  });
}

async function framesOf(
  args: Arguments,
  { engine, keys }: Source,
  folder: string,
  wanted: number,
): Promise<Float32Array[]> {
  const motion = await readReference(engine, keys, await readInputs([folder]), importOptions(args), {});
  const count = motion.times.length;
  if (count !== wanted)
    throw new UsageError(
      `--frames-of: ${folder} has ${count} frames, but --against has ${wanted} from the first key to the last. ` +
        'Give one file for each of these frames',
    );
  const shapes = motion.times.map((_, frame) => motion.frame(frame));
  motion.dispose();
  return shapes;
}

export function studyTables(args: Arguments): Promise<Measured> {
  return run(args, async ({ engine, keys }) => ({
    columns: TABLE_COLUMNS,
    rows: rowsOf(await measureTables(engine, keys, modelOf(args.files))),
  }));
}

const TABLE_COLUMNS = {
  table: '1: seconds for one shape; 2: seconds for all shapes of a motion',
  source: 'paper: as published, on an Intel i7-3770; here: measured on this computer',
  model: "name of the paper's model if a file name contains it, otherwise 'shape'",
  faces: 'number of faces of the shape; empty where the paper does not state it',
  shapes: 'number of shapes of the motion, K in the paper',
  share:
    'number of vertices of the ghost mesh, divided by that of the shape; gamma in the paper; empty in table 1, where ' +
    'the ghost mesh has about 2000 faces',
  '[2] ghost': 'time of the spline in shell space on the ghost mesh, s; here: time to fit the shapes',
  '[2] transfer': 'time of the deformation transfer, s; here: time of everything else, from the keys to the last shape',
  '[2] full': 'time of the spline in shell space without a ghost mesh, s',
  ghost: 'time of the spline in LRI space on the ghost mesh, s',
  transfer: 'time of the deformation transfer, s; here: total time with the ghost mesh, minus the column ghost',
  full: 'time of the spline in LRI space without a ghost mesh, s',
  note: 'how this row differs from the paper, or why a time is missing',
};

function rowsOf({ table1, table2 }: Tables): Cell[][] {
  const cells = ({ ghost, transfer, full }: Costs): Cell[] => [ghost, transfer, full];
  return [
    ...table1.map((row): Cell[] => [1, row.source, row.model, row.faces, 1, NaN, NaN, NaN, NaN, ...cells(row), '']),
    ...table2.map(({ source, model, faces, shapes, share, shell, lri, note }): Cell[] => [
      ...[2, source, model, faces, shapes, share],
      ...[...cells(shell), ...cells(lri), note],
    ]),
  ];
}

async function run(args: Arguments, study: Study): Promise<Measured> {
  if (args.files.length === 0) throw new UsageError('give at least one file (see --help)');
  const imported = importOptions(args);
  const known = await checkedFiles(args);
  return withEngine(async (engine) => {
    const inputs = await readInputs(args.files);
    const keys = await engine.importKeyframes(inputs, imported);
    const table = await study({ engine, keys, inputs, imported });
    const output = args.values.get('output');
    const isJson = output?.toLowerCase().endsWith('.json') ?? false;
    const given = [...args.values].filter(([name]) => name !== 'output');
    const options = Object.fromEntries(given.map(([name, text]) => [name, text.replaceAll(BETWEEN_VALUES, ' ')]));
    const text = (isJson ? jsonOf : csvOf)({ version, ...machine(), files: args.files, options }, table);
    const { warnings = [] } = table;
    return { text: await handOut(args, known, text, table.rows.length), warnings };
  });
}

/** Significant digits. */
const DIGITS = 5;
const rounded = (cell: Cell): Cell => (typeof cell === 'string' ? cell : Number(cell.toPrecision(DIGITS)));

/** What a table was made with. */
type Made = Record<string, unknown> & { version: string };

const machine = (): { date: string; machine: string } => ({
  date: new Date().toISOString().slice(0, 10),
  machine: `${cpus()[0]?.model ?? 'unknown processor'}, ${cpus().length} threads, Node ${process.version}`,
});

function csvOf({ version: made, ...rest }: Made, { columns, rows, warnings = [], notes = [] }: StudyTable): string {
  const cell = (value: Cell): string =>
    typeof value === 'string' ? quoted(value) : Number.isFinite(value) ? String(rounded(value)) : '';
  return [
    `# shapespline ${made}`,
    ...Object.entries(rest).map(([name, value]) => `# ${name} ${tableJson(value)}`),
    ...notes.map((note) => `# ${note}`),
    ...warnings.map((warning) => `# warning: ${warning}`),
    ...Object.entries(columns).map(([name, about]) => `# ${name}: ${about}`),
    Object.keys(columns).join(','),
    ...rows.map((row) => row.map(cell).join(',')),
    '',
  ].join('\n');
}

/** Quotes text with separators. */
const quoted = (text: string): string => (/[",;\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** Numbers that are not known are null. */
function jsonOf(made: Made, { columns, rows, warnings = [], notes = [] }: StudyTable): string {
  const names = Object.keys(columns);
  const named = rows.map((row) => Object.fromEntries(row.map((cell, i) => [names[i], rounded(cell)])));
  return `${JSON.stringify({ ...made, notes, warnings, columns, rows: named }, null, 2)}\n`;
}
