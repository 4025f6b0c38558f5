/** The measure command: a table of a motion's measures for several methods, and their errors against an animation. */
import { version } from '../../package.json';
import type { Motion } from '../engine/api/api.ts';
import { ghostFor, motionFor } from '../engine/api/method-options.ts';
import { checkSequenceOptions, encodingOf, motionOf } from '../engine/api/options.ts';
import type { ExportOptions, Method } from '../engine/api/types.ts';
import { withEngine } from '../engine/node.ts';
import { MEASURE_UNITS, SHELL_UNITS, columnsOf, measureMotion, tableJson, tableOf } from '../study/motion-measures.ts';
import type { Column } from '../study/motion-measures.ts';
import { fitWarnings, isOwnAt } from '../study/fitted-intervals.ts';
import { MotionError } from '../study/motion-error.ts';
import { BETWEEN_VALUES, UsageError, type Arguments } from './arguments.ts';
import { checkedFiles } from './commands.ts';
import { alignmentWarnings, timeWarnings } from './comparison-warnings.ts';
import { readInputs } from './input.ts';
import type { KnownFiles } from './known-files.ts';
import { writeOutputs } from './output.ts';
import {
  againstOptions,
  checkFit,
  importOptions,
  measuredMethods,
  measuredTimes,
  sequenceOptions,
  withProject,
} from './settings.ts';
import { noFrames, readReference } from './reference-animation.ts';
import type { Reference } from './reference-animation.ts';
import { fittedRegions, fittedTiming } from './timing.ts';

/** Number of frames held in memory at a time. */
const AT_ONCE = 16;

const ERROR_UNITS =
  "# distance: distance of the vertices from the animation, % of the diagonal of the keys' bounding box";

export interface Measured {
  /** The table, or a line with the name of its file. */
  text: string;
  warnings: string[];
}

export async function measure(args: Arguments): Promise<Measured> {
  if (args.files.length === 0) throw new UsageError('give at least one file (see --help)');
  const methods = measuredMethods(args);
  const byShell = args.flags.has('shell-bending');
  const against = args.values.get('against')?.split(BETWEEN_VALUES) ?? [];
  const own = againstOptions(args);
  if (against.length === 0 && Object.keys(own).length > 0)
    throw new UsageError('--against-up and --against-unit require --against');
  const [imported, options, wanted] = [importOptions(args), sequenceOptions(args), measuredTimes(args)];
  const regions = fittedRegions(args);
  const known = await checkedFiles(args);
  return withEngine(async (engine) => {
    const inputs = await readInputs(args.files);
    const keys = await engine.importKeyframes(inputs, imported);
    // A project's own method is not measured unless it is requested.
    const left: string[] = [];
    const all = withProject(keys.info.project, { ...options, method: methods[0]! }, (warning) => left.push(warning));
    checkFit(args, all, methods);
    const wholly = checkSequenceOptions(all);
    const shape = await engine.encode(keys, encodingOf(wholly));
    const timing = regions > 0 ? await fittedTiming({ engine, keys, inputs, imported }, shape, wholly, regions) : null;
    const sequence = await shape.motion({ ...motionOf(wholly), ...timing?.options });
    // Options that a compared method lacks are left out for that method only.
    const wished = { ...wholly, ...keys.info.project, ...options, ...timing?.options };
    const motionBy = async (method: Method): Promise<Motion> => {
      const own = motionFor(ghostFor(wished, method), { method });
      const same = own.ghostFaces === wholly.ghostFaces;
      return (same ? shape : await engine.encode(keys, encodingOf(own))).motion(motionOf(own));
    };
    const reference =
      against.length > 0 ? await readReference(engine, keys, await readInputs(against), imported, own) : null;
    const compared = reference && (await comparedTimes(sequence, reference, wanted, against[0]!));
    const times = compared?.times ?? (await sequence.planExport({ format: 'obj', ...wanted })).times;
    const warnings = [...left, ...(compared ? await comparisonWarnings(sequence, compared, reference) : [])];
    const columns: Column[] = [];
    const comments: string[] = reference
      ? [`# frames of the animation: ${reference.times.length}, ${reference.placed}`]
      : [];
    for (const method of methods) {
      const motion = method === methods[0] ? sequence : await motionBy(method);
      warnings.push(...fitWarnings(motion).map((warning) => `${method}: ${warning}`));
      const measures = await measureMotion(motion, { method }, times);
      const own = columnsOf(byShell ? { ...measures, shell: await motion.shellBending(times) } : measures);
      if (compared) {
        const error = await compare(motion, compared, keys.info.report.diagonal);
        own.push(
          { name: `${method} distance largest`, values: error.over.largest },
          { name: `${method} distance mean`, values: error.over.mean },
        );
        comments.push(errorLine(method, error));
      }
      columns.push(...own.map((column) => ownCells(column, motion, times)));
    }
    const lines = [
      `# shapespline ${version}`,
      `# files ${tableJson(args.files)}`,
      `# options ${tableJson({ import: imported, sequence: { ...options, ...timing?.options }, keyTimes: sequence.keyTimes })}`,
      ...warnings.map((warning) => `# warning: ${warning}`),
      ...(timing ? [`# ${timing.text}`] : []),
      ...(reference ? [`# against ${tableJson(against)}`, ...comments, ERROR_UNITS] : []),
      MEASURE_UNITS,
      ...(byShell ? [SHELL_UNITS] : []),
      ...tableOf(times, 1, columns),
    ];
    return { text: await handOut(args, known, `${lines.join('\n')}\n`, times.length), warnings };
  });
}

/** Without cells where a fitted method shows shapes of a different method. */
function ownCells({ name, values }: Column, motion: Motion, times: readonly number[]): Column {
  return { name, values: values.map((value, i) => (isOwnAt(motion, times[i]!) ? value : NaN)) };
}

/** The table, or after writing it to --output a line about it. */
export async function handOut(args: Arguments, known: KnownFiles, table: string, rows: number): Promise<string> {
  const output = args.values.get('output');
  if (!output) return table;
  await writeOutputs([{ flag: '--output', path: output, files: [{ name: 'table', bytes: table }] }], known);
  return `${output}: ${rows} rows\n`;
}

/** Times of the table, each with the animation's frame; null where the animation has no frame. */
interface Compared {
  times: number[];
  frames: (Float32Array | null)[];
}

/** Relative tolerance at the ends of the range, where frame times may be rounded. */
const AT_END = 1e-6;

/** The animation's frames within the range of the keys, or the requested times. */
export async function comparedTimes(
  sequence: Motion,
  reference: Reference,
  wanted: Partial<ExportOptions>,
  file: string,
): Promise<Compared> {
  const [start, end] = sequence.range;
  const span = [reference.times[0]!, reference.times.at(-1)!] as const;
  const near = AT_END * (end - start);
  if (Object.keys(wanted).length === 0) {
    const inside = reference.times.flatMap((t, frame) => (t >= start - near && t <= end + near ? [{ t, frame }] : []));
    if (inside.length < 2) throw noFrames(file, span);
    return {
      times: inside.map(({ t }) => Math.min(Math.max(t, start), end)),
      frames: inside.map(({ frame }) => reference.frame(frame)),
    };
  }
  const { times } = await sequence.planExport({ format: 'obj', ...wanted });
  const inside = times.filter((t) => t >= span[0] - near && t <= span[1] + near);
  if (inside.length === 0) throw noFrames(file, span);
  const sampled = await reference.at(inside);
  return { times, frames: times.map((t) => (inside.includes(t) ? sampled.frame(inside.indexOf(t)) : null)) };
}

/** Number of frames to check for a different size or axis. */
const LOOKED_AT = 5;

export async function comparisonWarnings(
  sequence: Motion,
  { times, frames }: Compared,
  reference: Reference,
): Promise<string[]> {
  const found = frames.flatMap((animation, index) => (animation ? [{ animation, t: times[index]! }] : []));
  const step = Math.max(1, Math.floor(found.length / LOOKED_AT));
  const looked = found.filter((_, index) => index % step === 0);
  const motions = await sequence.evaluateMany(looked.map(({ t }) => t));
  const pairs = looked.map(({ animation }, index) => ({ animation, motion: motions[index]!.positions }));
  const [first, last] = [sequence.keyTimes[0]!, sequence.keyTimes.at(-1)!];
  const warnings = [
    ...timeWarnings({
      keys: [first, last],
      animation: [reference.times[0]!, reference.times.at(-1)!],
      frames: reference.times.length,
      compared: found.length,
    }),
    ...alignmentWarnings(pairs, reference.axisAndUnit),
  ];
  for (const motion of motions) motion.release();
  return warnings;
}

async function compare(sequence: Motion, { times, frames }: Compared, diagonal: number): Promise<MotionError> {
  const error = new MotionError(diagonal);
  for (let from = 0; from < times.length; from += AT_ONCE) {
    const shapes = await sequence.evaluateMany(times.slice(from, from + AT_ONCE));
    shapes.forEach((shape, index) => {
      const isOwn = isOwnAt(sequence, times[from + index]!);
      error.add((isOwn && frames[from + index]) || null, shape.positions);
      shape.release();
    });
  }
  return error;
}

function errorLine(method: Method, error: MotionError): string {
  if (error.over.mean.every(Number.isNaN)) return `# ${method}: no shapes of this method to compare`;
  const text = (value: number): string => `${Number(value.toPrecision(4))} %`;
  return `# ${method}: KG error ${text(error.percent)}, largest distance ${text(error.largest)}, mean ${text(error.mean)}`;
}
