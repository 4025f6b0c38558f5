/** What `measure` does: numbers of a motion by several methods, and their errors against an animation, as a table. */
import { version } from '../../package.json';
import type { Engine, Keys, Sequence } from '../engine/api/api.ts';
import type { Method } from '../engine/api/types.ts';
import { EngineError } from '../engine/api/errors.ts';
import { isMismatch, likeOf } from '../engine/api/read-poses.ts';
import { withEngine } from '../engine/node.ts';
import { MEASURE_UNITS, columnsOf, measureMotion, tableOf } from '../study/motion-measures.ts';
import type { Column } from '../study/motion-measures.ts';
import { MotionError } from '../study/motion-error.ts';
import { BETWEEN_VALUES, UsageError, type Arguments } from './arguments.ts';
import { readInputs } from './input.ts';
import { writeOutputs } from './output.ts';
import { importOptions, measuredMethods, measuredTimes, sequenceOptions } from './settings.ts';

/** Frames that are held at once. */
const AT_ONCE = 16;

const ERROR_UNITS = '# distance: of the vertices from the animation, % of the diagonal of the keys';

/** The table, or where it was written. */
export async function measure(args: Arguments): Promise<string> {
  if (args.files.length === 0) throw new UsageError('name at least one file (see --help)');
  const methods = measuredMethods(args);
  const against = args.values.get('against')?.split(BETWEEN_VALUES) ?? [];
  const [imported, options, wanted] = [importOptions(args), sequenceOptions(args), measuredTimes(args)];
  return withEngine(async (engine) => {
    const keys = await engine.importKeyframes(await readInputs(args.files), imported);
    const sequence = await engine.createSequence(keys, { ...keys.info.project, ...options, method: methods[0]! });
    const { times } = await sequence.planExport({ format: 'obj', ...wanted });
    const truth = against.length > 0 ? await readTruth(engine, keys, against, times, args) : null;
    const columns: Column[] = [];
    const comments: string[] = [];
    for (const method of methods) {
      await sequence.update({ method });
      columns.push(...columnsOf(await measureMotion(sequence, { method }, times)));
      if (!truth) continue;
      const error = await compare(sequence, times, truth, keys.info.report.diagonal);
      columns.push(
        { name: `${method} distance largest`, values: error.over.largest },
        { name: `${method} distance mean`, values: error.over.mean },
      );
      comments.push(errorLine(method, error));
    }
    const lines = [
      `# shapespline ${version}`,
      `# files ${JSON.stringify(args.files)}`,
      `# options ${JSON.stringify({ import: imported, sequence: options, keyTimes: sequence.keyTimes })}`,
      ...(truth ? [`# against ${JSON.stringify(against)}`, ...comments, ERROR_UNITS] : []),
      MEASURE_UNITS,
      ...tableOf(times, 1, columns),
    ];
    return handOut(args, `${lines.join('\n')}\n`, times.length);
  });
}

async function handOut(args: Arguments, table: string, rows: number): Promise<string> {
  const output = args.values.get('output');
  if (!output) return table;
  await writeOutputs([{ path: output, files: [{ name: 'measures', bytes: table }] }]);
  return `${output}: ${rows} rows\n`;
}

/** The animation at those of the times that it has. */
interface Truth {
  keys: Keys;
  /** Index of its pose by time; null beyond its ends. */
  poses: (number | null)[];
}

async function readTruth(
  engine: Engine,
  keys: Keys,
  files: string[],
  times: readonly number[],
  args: Arguments,
): Promise<Truth> {
  const { up, unit, objects, animation } = importOptions(args);
  const input = await readInputs(files);
  const like = likeOf(keys);
  const { info } = await engine
    .importKeyframes(input, { up, unit, objects, animation, ...like })
    .catch((error: unknown) => {
      if (!isMismatch(error)) throw error;
      throw new EngineError(error.code, `--against: ${files[0]} is of another mesh than the keys.`, error.place);
    });
  const span = info.animations[Math.max(info.animation, 0)];
  if (!span?.moves) throw new UsageError(`--against: ${files[0]} holds no animation`);
  const inside = times.filter((t) => t >= span.start && t <= span.end);
  if (inside.length < 2)
    throw new UsageError(
      `--against: give at least two times from ${span.start} to ${span.end} s, where the animation is`,
    );
  const truth = await engine.importKeyframes(input, { up, unit, objects, animation, ...like, sample: inside });
  return { keys: truth, poses: times.map((t) => (inside.includes(t) ? inside.indexOf(t) : null)) };
}

async function compare(
  sequence: Sequence,
  times: readonly number[],
  { keys, poses }: Truth,
  diagonal: number,
): Promise<MotionError> {
  const error = new MotionError(diagonal);
  for (let from = 0; from < times.length; from += AT_ONCE) {
    const frames = await sequence.evaluateMany(times.slice(from, from + AT_ONCE));
    frames.forEach((frame, index) => {
      const pose = poses[from + index] ?? null;
      error.add(pose === null ? null : keys.positions(pose), frame.positions);
      frame.release();
    });
  }
  return error;
}

function errorLine(method: Method, error: MotionError): string {
  const text = (value: number): string => `${Number(value.toPrecision(4))} %`;
  return `# ${method}: KG error ${text(error.percent)}, largest distance ${text(error.largest)}, mean ${text(error.mean)}`;
}
