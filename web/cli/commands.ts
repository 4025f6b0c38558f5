/** The inspect and complete commands (measure is in measure.ts). */
import { version } from '../../package.json';
import type { Engine, Keys, Sequence } from '../engine/api/api.ts';
import { errorText } from '../engine/api/error-text.ts';
import { OWN_METHOD } from '../engine/api/methods.ts';
import { ENCODING, SHAPES } from '../engine/api/option-table.ts';
import { kgBetween } from '../study/ghost-study.ts';
import { withEngine } from '../engine/node.ts';
import { readPose } from '../engine/api/read-poses.ts';
import { NO_PLACE } from '../engine/api/types.ts';
import { checkSequenceOptions, encodingOf } from '../engine/api/options.ts';
import type { ExportOptions, ImportOptions, KeysInfo, SequenceOptions, Warning } from '../engine/api/types.ts';
import { BETWEEN_VALUES, UsageError, type Arguments } from './arguments.ts';
import { addInputs, readInputs } from './input.ts';
import { KnownFiles } from './known-files.ts';
import { checkOutputs, writeOutputs, type Output } from './output.ts';
import { checkFit, exportOptions, importOptions, sequenceOptions, withProject } from './settings.ts';
import { fittedRegions, fittedTiming, type FittedTiming, type Source } from './timing.ts';

/** Milliseconds of each stage, in order. */
class Timings {
  readonly ms: Record<string, number> = {};

  async time<T>(stage: string, work: Promise<T>): Promise<T> {
    const start = performance.now();
    const result = await work;
    this.ms[stage] = rounded(performance.now() - start);
    return result;
  }
}

const rounded = (ms: number): number => Math.round(ms * 100) / 100;

function checkFiles(args: Arguments): void {
  if (args.files.length === 0) throw new UsageError('give at least one file (see --help)');
}

function describe(info: KeysInfo): object {
  const { names, times, report, animations, animation, objects, matches, offset, project } = info;
  const { vertices, weldedVertices, ...rest } = report;
  return {
    keys: names.map((name, key) => ({ name, time: times[key] })),
    vertices: { raw: vertices, welded: weldedVertices },
    ...rest,
    animations,
    animation: animations[animation]?.name ?? null,
    together: (animations[animation]?.together ?? []).map((part) => animations[part]!.name),
    objects,
    offset,
    matches,
    isProject: project !== null,
  };
}

/** A report on the files as JSON. */
export async function inspect(args: Arguments): Promise<string> {
  checkFiles(args);
  const options = importOptions(args);
  return withEngine(async (engine) => {
    const { info } = await engine.importKeyframes(await readInputs(args.files), options);
    return `${JSON.stringify({ version, files: args.files, ...describe(info), warnings: info.warnings }, null, 2)}\n`;
  });
}

export interface Completed {
  /** One line that reports the output. */
  text: string;
  /** Adds the location to a sentence, counted from 1. */
  warnings: string[];
}

/** Larger exports announce their size before the work. */
const LARGE = 100e6;

/** Writes the completed motion and, if requested, the report. `say` receives a message before a large export. */
export async function complete(args: Arguments, say: (text: string) => void): Promise<Completed> {
  const started = performance.now();
  checkFiles(args);
  const output = args.values.get('output');
  if (!output) throw new UsageError('complete needs --output (see --help)');
  const options = { import: importOptions(args), sequence: sequenceOptions(args), export: exportOptions(args, output) };
  const report = args.values.get('report');
  const regions = fittedRegions(args);
  const known = await checkedFiles(args, options.export);
  return withEngine(async (engine) => {
    const timings = new Timings();
    const inputs = await timings.time('read', readInputs(args.files));
    const keys = await timings.time('import', engine.importKeyframes(inputs, options.import));
    const left: Warning[] = [];
    const given = withProject(keys.info.project, options.sequence, (message) =>
      left.push({ ...NO_PLACE, code: 'option-left-out', message, count: 0 }),
    );
    checkFit(args, given, [given.method ?? OWN_METHOD]);
    const tangents = await readTangents(engine, args, keys, options.import);
    const all = checkSequenceOptions({ ...given, ...tangents });
    const source = { engine, keys, inputs, imported: options.import };
    const timing = regions > 0 ? await timings.time('timing', timingOf(source, all, regions)) : null;
    const sequence = await timings.time('build', engine.createSequence(keys, { ...all, ...timing?.options }));
    const plan = await timings.time('plan', sequence.planExport(options.export));
    if (plan.bytes > LARGE) say(`writing ${output}, about ${Math.round(plan.bytes / 1e6)} MB`);
    const warnings = [...keys.info.warnings, ...left, ...sequence.warnings, ...plan.warnings];
    let [files, bytes] = [0, 0];
    const beside: string[] = [];
    const exported = async function* () {
      const start = performance.now();
      for await (const file of sequence.exportFiles(options.export)) {
        files += 1;
        bytes += file.bytes.length;
        if (files > 1 && !output.endsWith('/')) beside.push(file.name);
        yield file;
      }
      timings.ms.export = rounded(performance.now() - start);
    };
    const outputs: Output[] = [{ flag: '--output', path: output, files: exported() }];
    /** Adds the report after the export. */
    const reported = async function* () {
      const measures = await timings.time('measure', sequence.measures(plan.times));
      const ghost = await describeGhost(engine, keys, sequence, plan.times, timings);
      const { options: all, counts, stages } = await settled(sequence, options.export);
      timings.ms.total = rounded(performance.now() - started);
      const json = {
        version,
        files: args.files,
        output: { path: output, files, bytes },
        options: { import: options.import, ...all },
        ...describe(keys.info),
        range: sequence.range,
        frames: plan.times,
        targets: plan.targets,
        playbackError: plan.error,
        timings: { ...timings.ms, ...stages },
        counts,
        warnings,
        measures,
        ghost,
      };
      yield { name: 'report', bytes: `${JSON.stringify(json, null, 2)}\n` };
    };
    if (report) outputs.push({ flag: '--report', path: report, files: reported() });
    await writeOutputs(outputs, known);
    const count = options.export.blend ? 1 : plan.times.length;
    const off = plan.error === null ? '' : `, largest error between frames ${errorText(plan.error)}`;
    const others = beside.length === 0 ? '' : `; also written: ${beside.join(', ')}`;
    const fitted = timing ? `; ${timing.text}` : '';
    return {
      text: `${output}: ${count} ${count === 1 ? 'shape' : 'shapes'}${off}, ${bytes} bytes${others}${fitted}\n`,
      warnings: warnings.map(({ message }) => message),
    };
  });
}

async function timingOf(source: Source, options: SequenceOptions, regions: number): Promise<FittedTiming> {
  const shape = await source.engine.encode(source.keys, encodingOf(options));
  return fittedTiming(source, shape, options, regions).finally(() => shape.dispose());
}

/**
 * The files that the command may not replace. Refuses its outputs, before large files are read, if they are among them.
 */
export async function checkedFiles(
  args: Arguments,
  { format, name }: Partial<ExportOptions> = {},
): Promise<KnownFiles> {
  const known = new KnownFiles(args.flags.has('overwrite'));
  const poses = SHAPES.flatMap((shape) => args.values.get(ENCODING[shape].flag) ?? []);
  const against = args.values.get('against')?.split(BETWEEN_VALUES) ?? [];
  await addInputs(known, [...args.files, ...poses, ...against]);
  const outputs = ['output', 'report'].flatMap((flag) => {
    const given = args.values.get(flag);
    const beside = flag === 'output' && (format === 'pc2' || format === 'mdd') ? [`${name ?? 'shapespline'}.obj`] : [];
    return given === undefined ? [] : [{ flag: `--${flag}`, path: given, beside }];
  });
  await checkOutputs(outputs, known);
  return known;
}

async function readTangents(
  engine: Engine,
  args: Arguments,
  keys: Keys,
  options: ImportOptions,
): Promise<Partial<SequenceOptions>> {
  const tangents: Partial<SequenceOptions> = {};
  for (const name of SHAPES) {
    const file = args.values.get(ENCODING[name].flag);
    if (file) tangents[name] = await readPose(engine, await readInputs([file]), keys, options);
  }
  return tangents;
}

/**
 * The ghost mesh, and its KG error in percent against the motion without a ghost over these times; null without a
 * ghost.
 */
async function describeGhost(
  engine: Engine,
  keys: Keys,
  sequence: Sequence,
  times: number[],
  timings: Timings,
): Promise<object | null> {
  const { ghostFaces: faces, ghostVertices: vertices, joinedComponents } = await sequence.stats();
  if (faces === 0) return null;
  const { transfer, placement } = sequence.options;
  const full = await engine.createSequence(keys, { ...sequence.options, ghostFaces: 0 });
  const kg = await timings.time('compare', kgBetween(full, sequence, times));
  full.dispose();
  return { faces, vertices, joinedComponents, transfer, placement, kg };
}

/** All options in effect, and the counts of the sequence. Shapes are given by name. */
async function settled(
  sequence: Sequence,
  exported: Partial<ExportOptions>,
): Promise<Record<'options' | 'counts' | 'stages', object>> {
  const { weldMs, joinMs, simplifyMs, encodeMs, transferMs, orderMs, factorMs, arrangeMs, finishMs, ...counts } =
    await sequence.stats();
  const shapes = Object.fromEntries(SHAPES.map((name) => [name, sequence.options[name] !== null]));
  const options = {
    sequence: { ...sequence.options, ...shapes, keyTimes: sequence.keyTimes },
    export: exported,
  };
  const ms = {
    weld: weldMs,
    join: joinMs,
    simplify: simplifyMs,
    encode: encodeMs,
    transfer: transferMs,
    order: orderMs,
    factor: factorMs,
    arrange: arrangeMs,
    finish: finishMs,
  };
  const stages = Object.fromEntries(Object.entries(ms).map(([stage, value]) => [stage, rounded(value)]));
  return { options, counts, stages };
}
