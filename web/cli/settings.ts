/** The options of the commands, from the engine's table: names, parsing and help. */
import { GONE_FLAGS } from '../engine/api/gone-options.ts';
import { METHOD, METHODS } from '../engine/api/methods.ts';
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, optionsIn } from '../engine/api/option-table.ts';
import { choiceNow, validationError, listValidationError } from '../engine/api/options.ts';
import type { KeyOption, NumberOption, Option, OptionTable } from '../engine/api/option-table.ts';
import { RULES, settled, without, type Conflict, type RuledOption } from '../engine/api/rules.ts';
import { MOTION_DEFAULTS } from '../engine/api/types.ts';
import type { ExportOptions, ImportOptions, Method, SequenceOptions } from '../engine/api/types.ts';
import { BETWEEN_VALUES, UsageError, type Arguments, type Known } from './arguments.ts';
import * as read from './values.ts';

/** Parses an option's text. A shape's text is a file name, which the command reads. */
type Read = (text: string, option: string) => unknown;

interface Flag {
  /** Name of the engine's option. */
  name: string;
  flag: string;
  option: Option;
  /** Parses the option's text; null for an option without a value. */
  read: Read | null;
}

const readKind: Record<Exclude<Option['kind'], 'number' | 'choice'>, Read | null> = {
  flag: null,
  key: read.key,
  shape: (file) => file,
  turns: read.turns,
  pins: (text, option) => text.split(BETWEEN_VALUES).map((one) => read.pin(one, option)),
  regions: null,
  numbers: read.numbers,
  weights: read.numbers,
  range: read.range,
  animation: read.animation,
  sample: (text, option) => (/^\d+$/.test(text) ? read.wholeFrom(2)(text, option) : read.times(text, option)),
  faces: null,
  point: null,
  objects: null,
  names: (text) => text.split(BETWEEN_VALUES),
  text: (text) => text,
};

function readNumber({ whole, above, min = -Infinity, zero }: NumberOption): Read {
  const reader = whole ? read.wholeFrom(min) : above === 0 ? read.positive : read.number;
  return zero === undefined ? reader : (text, option) => (text === zero ? 0 : reader(text, option));
}

function readOption(option: Option): Read | null {
  if (option.kind === 'shape') return readKind.shape; // the text is a file name until the command reads the file
  if (option.kind === 'choice') return (text, flag) => read.oneOf(...option.choices)(choiceNow(option, text), flag);
  const reader = option.kind === 'number' ? readNumber(option) : readKind[option.kind];
  return reader && inBounds(reader, (value) => validationError(option, value));
}

/** Refuses valid text with a value that the engine would refuse, before any file is read. */
function inBounds(reader: Read, valueError: (value: unknown) => string | null): Read {
  return (text, option) => {
    const value = reader(text, option);
    const wrong = valueError(value);
    if (wrong) throw new UsageError(`${option}: ${wrong}`);
    return value;
  };
}

const flagOf = (name: string, option: Option, reader: Read | null): Flag[] =>
  option.flag === undefined ? [] : [{ name, flag: option.flag, option, read: reader }];

function flagsOf(table: OptionTable): Flag[] {
  return optionsIn(table).flatMap(([name, option]) => flagOf(name, option, readOption(option)));
}

const perKey = Object.entries(PER_KEY).flatMap(([name, option]: [string, KeyOption]) =>
  flagOf(
    name,
    option,
    inBounds(option.kind === 'number' ? read.numbers : read.turns, (value) => listValidationError(option, value)),
  ),
);
const importFlags = flagsOf(IMPORT);
const motionFlags = [...flagsOf(MOTION), ...perKey];
const encodingFlags = flagsOf(ENCODING);
const exportFlags = flagsOf(EXPORT);

/** `several`: the command's own repeatable options; `bare`: its own options without a value. */
function known(flags: Flag[], own: string[], several: string[] = [], bare: string[] = []): Known {
  const named = (withValue: boolean): string[] =>
    flags.filter((one) => (one.read !== null) === withValue).map(({ flag }) => flag);
  const repeated = flags
    .filter(({ option }) => option.kind === 'names' || option.kind === 'pins')
    .map(({ flag }) => flag);
  return {
    options: new Set([...named(true), ...own, ...GONE_FLAGS]),
    repeated: new Set([...repeated, ...several]),
    flags: new Set([...named(false), ...bare, 'help']),
  };
}

export const INSPECT = known(importFlags, []);
export const COMPLETE = known(
  [...importFlags, ...motionFlags, ...encodingFlags, ...exportFlags],
  ['output', 'report', 'fit-timing'],
  [],
  ['overwrite'],
);

/** Options of the ghost mesh that its study varies. */
const LEADING: readonly string[] = ['ghostFaces', 'transfer'];

/** Options that select times. */
const MOMENTS: readonly string[] = ['times', 'frames', 'fps', 'range'];
const momentFlags = exportFlags.filter(({ name }) => MOMENTS.includes(name));
const shownFlags = motionFlags.filter(({ name }) => name !== 'method');
export const MEASURE = known(
  [...importFlags, ...shownFlags, ...encodingFlags.filter(({ option }) => option.kind !== 'shape'), ...momentFlags],
  ['output', 'methods', 'against', 'against-up', 'against-unit', 'fit-timing'],
  ['against'],
  ['shell-bending', 'overwrite'],
);

const studied = [...importFlags, ...encodingFlags.filter(({ option }) => option.kind !== 'shape')];
const fittedFlags = motionFlags.filter(({ name }) => name === 'spaceFaces' || name === 'spaceSamples');
export const STUDY_GHOST = known(
  [...studied, ...motionFlags].filter(({ name }) => !LEADING.includes(name)),
  ['output', 'sizes'],
  [],
  ['overwrite'],
);
export const STUDY_SPACES = known(
  [...studied, ...fittedFlags],
  ['output', 'methods', 'against', 'against-up', 'against-unit', 'fit-timing', 'frames-of'],
  ['against', 'frames-of'],
  ['overwrite'],
);
export const STUDY_TABLES = known(importFlags, ['output'], [], ['overwrite']);

const HELP_COLUMN = 41;
const HELP_WIDTH = 112;

/** Left column, with the explanation beside it or below. */
function line(left: string, text: string): string {
  const lines: string[] = [''];
  for (const word of text.split(' ')) {
    const last = lines.at(-1)!;
    if (last !== '' && HELP_COLUMN + last.length + 1 + word.length > HELP_WIDTH) lines.push(word);
    else lines[lines.length - 1] = last === '' ? word : `${last} ${word}`;
  }
  const indent = `\n${' '.repeat(HELP_COLUMN)}`;
  const start = left.length + 2 < HELP_COLUMN ? left.padEnd(HELP_COLUMN) : `${left}${indent}`;
  return `${start}${lines.join(indent)}`;
}

function helpOf({ flag, option, read: reader }: Flag): string {
  const value = option.value ?? (option.kind === 'choice' ? option.choices.join('|') : '');
  return line(`  --${flag}${reader === null ? '' : ` ${value}`}`, option.help);
}

const helpOn = (flags: Flag[]): string => flags.map(helpOf).join('\n');

export const HELP = `shapespline: smooth motion of a shape through key poses

  inspect FILE...                        print the contents of the files as JSON
  complete FILE... --output OUT          compute and write the motion
  measure FILE... [--output T.csv]       table over time: volume, area, bending energy, sliding, and
                                         coordinates in the shape plane
  study ghost FILE... [--output T.csv]   table of error and frame time by size of the ghost mesh
  study spaces FILE... [--output T.csv]  table of volume, area, lengths, bending and cost by method
  study tables FILE... [--output T.csv]  the paper's tables of costs, measured and as published

FILE is a .glb, .gltf, .obj, .ply or .off file. Several FILEs are the keys, in the order given. A single
FILE must contain morph targets or an animation. A .pc2 or .mdd file with its .obj is an animation. So
are numbered .obj or .ply files: up to 32 all become keys; from more, --sample takes 8 by default. A
folder stands for the models in it, in the order of their names. Buffers, materials and textures of a
.gltf or .obj file are read from its folder.

If OUT ends in .glb, it is one file with an animation. An .obj or .ply is one shape (give one --at time). A
.pc2 or .mdd is a point cache with its OBJ next to it. A folder (ending in /) gets 0000.obj, 0001.obj, ...,
one per time; frames of an earlier motion there are replaced, other files are not. Materials and textures of
an OBJ are written next to it. Beside the output, .shapespline.json lists the files that may be replaced.

Keys are counted from 1, animations from 0; reports count everything from 0. Times are in seconds.

${line('  --methods M,M,...', 'measure, study spaces: methods to compare; default: lri for measure, all methods for study spaces. Options that a method after the first lacks are left out for it')}
${line('  --sizes N,N,...', 'study ghost: numbers of faces of the ghost meshes; default: 500,1000,2000,3000,5000,10000')}
${line('  --against FILE', "measure, study spaces: compare each method with this animation of the same mesh, at the animation's own frames (with measure, unless --at, --frames, --fps or --range is given); repeat the option for files that belong to FILE. Frames of files without times are spaced evenly from the first key to the last")}
${line('  --against-up y|z', 'measure, study spaces: up axis of that animation; default: as its file states, otherwise --up')}
${line('  --against-unit METRES', 'measure, study spaces: metres per unit of that animation; default: as its file states, otherwise --unit')}
${line('  --shell-bending', 'measure: add the bending energy computed from edge lengths and angles, in the same way for every method; up to three more shapes are computed for each time')}
${line('  --frames-of NAME=DIR', 'study spaces: a row for the frames of another method, one file per frame of --against; may be repeated')}
${line('  --fit-timing N|off', 'complete, measure, study spaces (as a further row): fit the timing of N regions (1 or whole: one timing for all; 16 are usual) to the animation from which the keys are taken, and print the error on frames that the fit has not seen; default: off')}
${line('  --overwrite', 'let --output and --report replace an input. Never replaced are files that an input refers to, nor files beside the output that shapespline did not write or that have changed since')}
${line('  --report R.json', 'complete: write options, timings, counts, warnings, volume and area to this file')}
${helpOn(importFlags)}

${helpOn(motionFlags)}

${helpOn(encodingFlags)}

${helpOn(exportFlags)}

  --help  --version
Exit codes: 0 success, 1 bad input, 2 wrong usage.
`;

/** The given values; the engine fills in defaults. */
function given(args: Arguments, flags: Flag[]): object {
  return Object.fromEntries(
    flags.flatMap(({ name, flag, read: reader }): [string, unknown][] => {
      if (reader === null) return args.flags.has(flag) ? [[name, true]] : [];
      const text = args.values.get(flag);
      return text === undefined ? [] : [[name, reader(text, `--${flag}`)]];
    }),
  );
}

export function importOptions(args: Arguments): ImportOptions {
  return given(args, importFlags);
}

/** All options except shapes, because a shape's text is a file name. */
export function sequenceOptions(args: Arguments): Partial<SequenceOptions> {
  const flags = [...motionFlags, ...encodingFlags.filter(({ option }) => option.kind !== 'shape')];
  const options: Partial<SequenceOptions> = given(args, flags);
  checkTogether(options, () => true);
  return options;
}

/**
 * The given options, and those of the project for the rest. Refuses given options that cannot be combined; inherited
 * ones are left out, and `say` names them.
 */
export function withProject(
  project: Partial<SequenceOptions> | null,
  options: Partial<SequenceOptions>,
  say: (warning: string) => void = () => undefined,
): Partial<SequenceOptions> {
  const all = { ...project, ...options };
  const isGiven = (option: RuledOption): boolean => options[option] !== undefined;
  const note = project ? ' (the file is a project, which sets the options that are not given)' : '';
  const left = checkTogether(all, isGiven, note);
  for (const conflict of left) say(`${refusal(conflict, all)}, so --${ruledFlag(conflict.dropped)} is left out${note}`);
  return without(
    all,
    left.map(({ dropped }) => dropped),
  );
}

/** Refuses given options that cannot be combined, by the names of their flags. Returns the others that cannot. */
function checkTogether(
  options: Partial<SequenceOptions>,
  isGiven: (option: RuledOption) => boolean,
  note = '',
): (Conflict & { dropped: RuledOption })[] {
  const all = { ...MOTION_DEFAULTS, ...options };
  const { refused, left } = settled(all, isGiven);
  if (refused) throw new UsageError(refusal(refused, options) + note);
  return left;
}

const ruledFlag = (option: RuledOption): string => motionFlags.find(({ name }) => name === option)!.flag;

/** Why an option cannot be combined with another, by flags. */
function refusal({ option, other }: Conflict, options: Partial<SequenceOptions>): string {
  const flag = ruledFlag(option);
  if (other === 'keepLengths')
    return option === 'boundary'
      ? '--keep-lengths requires --boundary natural'
      : `--keep-lengths cannot be combined with --${flag}`;
  const value = option === 'boundary' ? ` ${options.boundary}` : '';
  const fitting = METHODS.filter((method) => RULES[option].fitsMethod({ ...MOTION_DEFAULTS, ...options, method }));
  return `--${flag}${value} requires --method ${listed(fitting)}`;
}

const listed = (words: readonly string[]): string =>
  words.length > 1 ? `${words.slice(0, -1).join(', ')} or ${words.at(-1)}` : words.join();

/** Refuses flags of fitted shapes for methods that fit none, and mixtures of keys for those that do. */
export function checkFit(args: Arguments, options: Partial<SequenceOptions>, methods: readonly Method[]): void {
  const fitting = methods.find((method) => METHOD[method].curve === 'fitted');
  const kept = (options.keepLengths ?? 0) > 0;
  if (args.values.has('space-faces') && !fitting && !kept)
    throw new UsageError('--space-faces requires --method lengths or shell, or --keep-lengths');
  if (args.values.has('space-samples') && !fitting)
    throw new UsageError('--space-samples requires --method lengths or shell');
  if (args.values.has('blend') && (fitting || kept))
    throw new UsageError(
      `--blend mixes keys, which ${kept ? '--keep-lengths' : `--method ${fitting}`} does not support`,
    );
}

export function exportOptions(args: Arguments, output: string): Partial<ExportOptions> {
  const options: Partial<ExportOptions> = {
    format: formatOf(output),
    ...nameOf(output),
    ...given(args, exportFlags),
  };
  const { format, times, frames, fps, range } = options;
  if (options.blend) return oneBlend(args, output, options);
  if (times && (frames || fps || range))
    throw new UsageError('--at cannot be combined with --range, --frames or --fps');
  if (frames && fps) throw new UsageError('give --frames or --fps, not both');
  if (options.tolerance !== undefined && (times || frames) && options.targets !== 'principal')
    throw new UsageError('give --tolerance or the times (--at, --frames), not both');
  const alone = options.format !== 'glb' && GLB_ONLY.find((name) => options[name] !== undefined);
  if (alone) throw new UsageError(`--${alone} requires an output that ends in .glb`);
  if (output.endsWith('/') || times?.length === 1 || HOLD_ALL.includes(format!)) return options;
  throw new UsageError(`${output} can hold only one shape: give one --at time, or a folder (ending in /) for several`);
}

/** Export options for a single blend, which has no time. */
function oneBlend(args: Arguments, output: string, options: Partial<ExportOptions>): Partial<ExportOptions> {
  const other = exportFlags.find(
    ({ name, flag }) => OF_A_MOTION.includes(name) && (args.values.has(flag) || args.flags.has(flag)),
  );
  if (other) throw new UsageError(`--blend gives one shape: leave out --${other.flag}`);
  if (!['glb', 'obj', 'ply'].includes(options.format!))
    throw new UsageError(`--blend gives one shape: ${output} must end in .glb, .obj or .ply, or in / for a folder`);
  return options;
}

/** Export options for times and playback. */
const OF_A_MOTION: readonly string[] = [
  'times',
  'frames',
  'fps',
  'tolerance',
  'targets',
  'range',
  'duration',
  'bounce',
  'clip',
];

/** The methods that `measure` compares. */
export function measuredMethods(args: Arguments): Method[] {
  const text = args.values.get('methods');
  if (text === undefined) return [MOTION.method.default];
  const methods = text.split(',').map((word) => read.oneOf(...MOTION.method.choices)(word, '--methods') as Method);
  return [...new Set(methods)];
}

/** Axis and unit of the animation for `measure`. */
export function againstOptions(args: Arguments): Pick<ImportOptions, 'up' | 'unit'> {
  const [up, unit] = ['against-up', 'against-unit'].map((name) => args.values.get(name));
  return {
    ...(up !== undefined && { up: read.oneOf('y', 'z')(up, '--against-up') }),
    ...(unit !== undefined && { unit: read.positive(unit, '--against-unit') }),
  };
}

/** The times for `measure`. */
export function measuredTimes(args: Arguments): Partial<ExportOptions> {
  return given(args, momentFlags);
}

/** Options that other formats would ignore. */
const GLB_ONLY = ['tolerance', 'compression', 'targets', 'bounce', 'clip'] as const;

/** Formats with all frames in one file. */
const HOLD_ALL: readonly string[] = ['glb', 'pc2', 'mdd'];

/** Files that belong to the output share its name. */
function nameOf(output: string): Partial<ExportOptions> {
  const stem = output.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  return stem === '' || validationError(EXPORT.name, stem) ? {} : { name: stem };
}

function formatOf(output: string): ExportOptions['format'] {
  if (output.endsWith('/') || /\.obj$/i.test(output)) return 'obj';
  if (/\.glb$/i.test(output)) return 'glb';
  if (/\.ply$/i.test(output)) return 'ply';
  if (/\.pc2$/i.test(output)) return 'pc2';
  if (/\.mdd$/i.test(output)) return 'mdd';
  throw new UsageError(`--output: '${output}' must end in .glb, .obj, .ply, .pc2 or .mdd, or in / for a folder`);
}
