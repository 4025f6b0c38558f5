/**
 * Checks options. An unknown name, a wrong type or a value out of range is refused with code 'invalid-option' and the
 * option's name, before anything is sent to a worker.
 */
import { invalidOption, type EngineError } from './errors.ts';
import { RULES, settled, type Conflict, type Ruled } from './rules.ts';
import { METHOD, OWN_METHOD } from './methods.ts';
import {
  ENCODING,
  EXPORT,
  IMPORT,
  MAX_PATH_KEYS,
  MAX_REGION_NUMBERS,
  MAX_TIME,
  MAX_TURNS,
  MOTION,
  PER_KEY,
  optionsIn,
} from './option-table.ts';
import type {
  KeyOption,
  NumberOption,
  Option,
  OptionTable,
  OtherOption,
  SceneObject,
  TimingRegion,
} from './option-table.ts';
import {
  ENCODING_DEFAULTS,
  EXPORT_DEFAULTS,
  IMPORT_DEFAULTS,
  MOTION_DEFAULTS,
  NO_PLACE,
  SEQUENCE_DEFAULTS,
  type EncodingOptions,
  type ExportOptions,
  type ImportOptions,
  type MotionOptions,
  type SequenceOptions,
  type Warning,
} from './types.ts';

/** The problem with a value, such as 'must be a number', or null. */
type Check = (value: unknown) => string | null;
type Checks = Readonly<Record<string, Check>>;

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
const isTime = (value: unknown): value is number => isNumber(value) && Math.abs(value) <= MAX_TIME;
const grouped = (value: number): string => value.toLocaleString('en', { maximumFractionDigits: 9 });
const BETWEEN_TIMES = `from ${grouped(-MAX_TIME)} to ${grouped(MAX_TIME)}`;

/** Limit of 32-bit numbers in the core, whose messages count indices from 1. */
const MAX_COUNT = 2 ** 31 - 2;
const wholeFrom =
  (min: number): Check =>
  (v) => {
    if (!isNumber(v) || !Number.isInteger(v) || v < min) return `must be a whole number of at least ${min}`;
    return v <= MAX_COUNT ? null : `must be at most ${grouped(MAX_COUNT)}`;
  };
const times: Check = (v) => (Array.isArray(v) && v.every(isTime) ? null : `must be an array of times ${BETWEEN_TIMES}`);

const turns: Check = (v) => {
  const good = (entry: unknown): boolean => {
    if (typeof entry !== 'object' || entry === null) return false;
    const { key, turns: count, component = 0, ...rest } = entry as Record<string, unknown>;
    const inRange = Number.isInteger(count) && Math.abs(count as number) <= MAX_TURNS;
    return !wholeFrom(1)(key) && inRange && !wholeFrom(0)(component) && Object.keys(rest).length === 0;
  };
  return Array.isArray(v) && v.every(good)
    ? null
    : 'must be an array of { key, turns, component? } with whole numbers, key at least 1, component at least 0 and ' +
        `turns from -${MAX_TURNS} to ${MAX_TURNS}`;
};

export const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

/** Largest allowed offset. */
const MAX_MOVE = 1e12;

/** Checks a pin's path. */
const path: Check = (v) => {
  if (!Array.isArray(v)) return 'whose path is not an array';
  if (v.length > MAX_PATH_KEYS) return `with more than ${MAX_PATH_KEYS} keys in its path`;
  const goodMove = (move: unknown): boolean =>
    Array.isArray(move) && move.length === 3 && move.every((x) => isNumber(x) && Math.abs(x) <= MAX_MOVE);
  const good = v.every(
    (key, i) =>
      isRecord(key) && isTime(key['time']) && goodMove(key['move']) && (i === 0 || key['time'] > v[i - 1].time),
  );
  return good ? null : 'whose path is not { time, move: [x, y, z] } in increasing times';
};

/** The problem with a pin, after 'has a pin'. */
function pinError(pin: unknown): string | null {
  if (!isRecord(pin)) return 'that is not an object';
  const { vertex, radius, stay = 0, path: keys = [], ...rest } = pin;
  if (wholeFrom(0)(vertex)) return 'whose vertex is not a whole number of at least 0';
  if (!isNumber(radius) || radius < 0 || radius > 1) return 'whose radius is not a number from 0 to 1';
  if (wholeFrom(0)(stay)) return 'whose stay is not a whole number of at least 0';
  const [other] = Object.keys(rest);
  return other === undefined ? path(keys) : `with an unknown field '${other}': a pin has vertex, radius, stay and path`;
}

const pins: Check = (v) => {
  if (!Array.isArray(v)) return 'must be an array of { vertex, radius, stay?, path? }';
  const wrong = v.map(pinError).find((one) => one !== null);
  return wrong ? `has a pin ${wrong}` : null;
};

const PER_INTERVAL = ['earlier', 'swing'] as const;

/** The problem with a region, after 'has a region'. */
function regionError(region: unknown): string | null {
  if (!isRecord(region)) return 'that is not an object';
  const { faces, earlier: _a, swing: _b, soft, ...rest } = region;
  if (!Array.isArray(faces) || faces.length % 2 !== 0 || faces.some((one) => wholeFrom(0)(one) !== null))
    return 'whose faces are not runs of whole numbers: first face and number of faces, in turn';
  for (const name of PER_INTERVAL) {
    const wrong = listValidationError(PER_KEY[name], region[name]);
    if (wrong) return `whose ${name} ${wrong}`;
  }
  if (typeof soft !== 'boolean') return 'whose soft is not true or false';
  const [other] = Object.keys(rest);
  return other === undefined ? null : `with an unknown field '${other}': a region has faces, earlier, swing and soft`;
}

const regions: Check = (v) => {
  if (!Array.isArray(v)) return 'must be an array of { faces, earlier, swing, soft }';
  const wrong = v.map(regionError).find((one) => one !== null);
  if (wrong) return `has a region ${wrong}`;
  const numbers = (v as TimingRegion[]).reduce(
    (sum, { faces, earlier, swing }) => sum + faces.length + earlier.length + swing.length,
    0,
  );
  return numbers <= MAX_REGION_NUMBERS
    ? null
    : `must have at most ${grouped(MAX_REGION_NUMBERS)} numbers, not ${grouped(numbers)}`;
};

const sample: Check = (v) => {
  if (!wholeFrom(2)(v)) return null;
  const increasing = Array.isArray(v) && v.length > 0 && v.every((t, i) => isTime(t) && (i === 0 || t > v[i - 1]));
  return increasing
    ? null
    : `must be increasing times in seconds ${BETWEEN_TIMES}, or the number of times (at least 2)`;
};

export const isObject = (v: unknown): v is SceneObject =>
  isRecord(v) &&
  !wholeFrom(0)(v['start']) &&
  !wholeFrom(0)(v['count']) &&
  typeof v['isGroup'] === 'boolean' &&
  ['name', 'nodeName', 'meshName', 'path'].every((name) => typeof v[name] === 'string');

/** Longest file name, in characters. */
const LONGEST_NAME = 120;
/** Same limit as in wasm/core/spline/discrete_spline. */
const MAX_SAMPLES = 1000;
/** Allowed deviation of the sum of weights from 1. */
const SUM_TOLERANCE = 1e-6;

const ofKind: Record<Exclude<Option['kind'], 'number' | 'choice'>, Check> = {
  flag: (v) => (typeof v === 'boolean' ? null : 'must be true or false'),
  key: wholeFrom(0),
  shape: (v) => (v instanceof Float32Array ? null : 'must be a Float32Array of positions'),
  turns,
  pins,
  regions,
  numbers: times,
  weights: (v) => {
    if (!Array.isArray(v) || v.length === 0 || !v.every(isNumber)) return 'must be numbers, one per key';
    const sum = v.reduce((all: number, one: number) => all + one, 0);
    return Math.abs(sum - 1) <= SUM_TOLERANCE ? null : `must sum to 1, not ${Number(sum.toPrecision(6))}`;
  },
  range: (v) =>
    Array.isArray(v) && v.length === 2 && v.every(isTime) && v[0] < v[1]
      ? null
      : `must be two times, first and last, ${BETWEEN_TIMES}`,
  animation: (v) => (typeof v === 'string' || !wholeFrom(0)(v) ? null : "must be an animation's name or index"),
  sample,
  faces: (v) => (v instanceof Uint32Array ? null : 'must be a Uint32Array of vertex indices'),
  point: (v) => (Array.isArray(v) && v.length === 3 && v.every(isNumber) ? null : 'must be three numbers'),
  names: (v) => (Array.isArray(v) && v.every((one) => typeof one === 'string') ? null : 'must be an array of names'),
  objects: (v) => (Array.isArray(v) && v.every(isObject) ? null : 'must be the scene.objects of an import'),
  text: (v) =>
    typeof v === 'string' && v !== '' && v.length <= LONGEST_NAME && !/[/\\\p{C}]/u.test(v)
      ? null
      : `must be a name of at most ${LONGEST_NAME} characters, none of them / or \\`,
};

/** The allowed values of an option, in words. */
function inWords({ whole, above, min, max }: NumberOption): string {
  const kind = whole ? 'a whole number' : 'a number';
  if (above !== undefined) return `${kind} above ${grouped(above)} and at most ${grouped(max)}`;
  return `${kind} from ${grouped(min ?? -max)} to ${grouped(max)}`;
}

function numberCheck(option: NumberOption): Check {
  const { whole, above = -Infinity, min = -Infinity, max, zero } = option;
  return (v) => {
    if (v === 0 && zero !== undefined) return null;
    const good = isNumber(v) && (!whole || Number.isInteger(v)) && v > above && v >= min && v <= max;
    return good ? null : `must be ${zero === undefined ? '' : `0 (${zero}) or `}${inWords(option)}`;
  };
}

/** Checks the number of entries. */
function countCheck({ kind, some, max = Infinity }: OtherOption): Check {
  const noun = kind === 'pins' || kind === 'regions' ? kind : 'times';
  return (v) => {
    const count = Array.isArray(v) ? v.length : typeof v === 'number' ? v : 1;
    if (some && count === 0) return 'must have at least one entry';
    return count <= max ? null : `must be at most ${grouped(max)} ${noun}, not ${grouped(count)}`;
  };
}

const COUNTED: readonly Option['kind'][] = ['numbers', 'sample', 'names', 'pins', 'regions'];

function checkOf(option: Option): Check {
  const { kind } = option;
  if (kind === 'number') return numberCheck(option);
  if (kind === 'choice') {
    const { choices } = option;
    const names = choices.map((name) => `'${name}'`).join(', ');
    return (v) => (choices.includes(v as string) ? null : `must be one of ${names}`);
  }
  const count = countCheck(option);
  return (v) => ofKind[kind](v) ?? (COUNTED.includes(kind) ? count(v) : null);
}

/** The current name of a choice. */
export function choiceNow<T>(option: Option, value: T): T | string {
  const before = option.kind === 'choice' ? option.formerly : undefined;
  return before && typeof value === 'string' && Object.hasOwn(before, value) ? before[value]! : value;
}

/** The problem with an option's value, or null. */
export function validationError(option: Option, value: unknown): string | null {
  return value === null && option.default === null ? null : checkOf(option)(value);
}

/** Checks the list of an option's values per key. */
function listCheck(option: KeyOption): Check {
  if (option.kind === 'turns') return turns;
  const good = numberCheck(option);
  return (v) =>
    Array.isArray(v) && v.every((one) => good(one) === null)
      ? null
      : `must be an array with ${inWords(option)} per key`;
}

/** The problem with an option's list of values per key, or null. */
export function listValidationError(option: KeyOption, value: unknown): string | null {
  return listCheck(option)(value);
}

const checksOf = (table: OptionTable): Checks =>
  Object.fromEntries(optionsIn(table).map(([name, option]) => [name, (value) => validationError(option, value)]));

const encodingChecks = checksOf(ENCODING);
const listChecks = Object.fromEntries(Object.entries(PER_KEY).map(([name, option]) => [name, listCheck(option)]));
const motionChecks: Checks = { ...checksOf(MOTION), ...listChecks };
const sequenceChecks: Checks = { ...encodingChecks, ...motionChecks };
const importChecks = checksOf(IMPORT);
const exportChecks = checksOf(EXPORT);

/** Copies arrays and plain objects, which the caller may change later. Arrays without entries may be detached. */
export function copied<T>(value: T): T {
  const copy = (): unknown => {
    if (Array.isArray(value)) return value.map(copied);
    if (ArrayBuffer.isView(value)) return value.byteLength > 0 ? (value as unknown as Uint8Array).slice() : value;
    return isRecord(value) ? Object.fromEntries(Object.entries(value).map(([key, one]) => [key, copied(one)])) : value;
  };
  return copy() as T;
}

/** Fills in defaults; undefined means the default. */
function checked<T extends object>(what: string, checks: Checks, defaults: Readonly<T>, given: object | undefined): T {
  const result: Record<string, unknown> = { ...defaults };
  for (const [name, value] of Object.entries(given ?? {})) {
    if (!Object.hasOwn(checks, name)) {
      throw invalidOption(`There is no ${what} option '${name}'; the options are ${Object.keys(checks).join(', ')}.`);
    }
    if (value === undefined) continue;
    const wrong = checks[name]!(value);
    if (wrong) throw invalidOption(`The ${what} option '${name}' ${wrong}.`);
    result[name] = value;
  }
  return result as T;
}

export function checkImportOptions(given?: object): ImportOptions {
  return copied(checked('import', importChecks, IMPORT_DEFAULTS, given));
}

export function checkExportOptions(given?: object): ExportOptions {
  return copied(checked('export', exportChecks, EXPORT_DEFAULTS, given));
}

export function checkSequenceOptions(given?: object): SequenceOptions {
  return copied(checkProject(given));
}

/** Checks the options in a project, without copies, because no caller holds them. */
export function checkProject(given?: object): SequenceOptions {
  return checked('sequence', sequenceChecks, SEQUENCE_DEFAULTS, given);
}

export function checkEncodingOptions(given?: object): EncodingOptions {
  return copied(checked('encoding', encodingChecks, ENCODING_DEFAULTS, given));
}

/** Merges a change into the motion options and separates the key times. */
export function checkUpdate(
  present: MotionOptions,
  change: object,
): { motion: MotionOptions; keyTimes: number[] | null } {
  const { keyTimes, ...rest } = change as { keyTimes?: unknown };
  const name = Object.keys(rest).find((key) => Object.hasOwn(encodingChecks, key));
  if (name) {
    throw invalidOption(`The option '${name}' changes the encoding: make a new sequence with createSequence.`);
  }
  const wrong = keyTimes === undefined ? null : times(keyTimes);
  if (wrong) throw invalidOption(`'keyTimes' ${wrong}.`);
  return {
    motion: copied(checked('motion', motionChecks, present, rest)),
    keyTimes: copied(keyTimes as number[] | undefined) ?? null,
  };
}

/**
 * The motion options after the rules (rules.ts), and a warning for each option that was left out. `given`: the options
 * of this call; others are inherited. Error: a given option that the method, or the option keepLengths, does not
 * support.
 */
export function checkRules(
  options: MotionOptions,
  given: object | undefined,
): { motion: MotionOptions; warnings: Warning[] } {
  const {
    options: motion,
    left,
    refused,
  } = settled(options, (option) => (given as Partial<Ruled> | undefined)?.[option] !== undefined);
  if (refused) {
    const advice = refused.other === 'method' ? `Use the method '${OWN_METHOD}'.` : 'Set keepLengths to 0.';
    throw invalidOption(`${unsupported(refused, options)}. ${advice}`);
  }
  const warnings = left.map(
    (conflict): Warning => ({
      ...NO_PLACE,
      code: 'option-left-out',
      message: `${unsupported(conflict, options)}. The motion is made without ${RULES[conflict.dropped].words}.`,
      count: 0,
    }),
  );
  return { motion, warnings };
}

function unsupported({ option, other }: Conflict, { method }: MotionOptions): string {
  const what = other === 'method' ? `The method '${method}'` : 'The option keepLengths';
  return `${what} does not support ${RULES[option].words}`;
}

/** The refusal of another motion of the same sequence. */
export function notUpdated({ method, keepLengths }: MotionOptions): EngineError {
  const what =
    METHOD[method].curve === 'fitted' ? `The method '${method}'` : `A motion with keepLengths ${keepLengths}`;
  return invalidOption(`${what} cannot be updated: make a new sequence with createSequence.`);
}

export function motionOf(options: SequenceOptions): MotionOptions {
  return picked(options, MOTION_DEFAULTS);
}

export function encodingOf(options: SequenceOptions): EncodingOptions {
  return picked(options, ENCODING_DEFAULTS);
}

/** The options that also exist in `like`. */
function picked<T extends object>(options: T, like: Readonly<T>): T {
  return Object.fromEntries((Object.keys(like) as (keyof T)[]).map((name) => [name, options[name]])) as T;
}

/** Checks the names of call options. */
export function checkCall(call: object | undefined): void {
  const names = ['signal', 'onProgress'];
  const name = Object.keys(call ?? {}).find((key) => !names.includes(key));
  if (name) throw invalidOption(`There is no call option '${name}'; the options are ${names.join(', ')}.`);
}

/** The problem with a time, or null. */
export const timeProblem: Check = (t) => (isTime(t) ? null : `must be a number ${BETWEEN_TIMES}`);

export function checkTime(t: unknown): number {
  const wrong = timeProblem(t);
  if (wrong || !isTime(t)) throw invalidOption(`A time ${wrong}.`);
  return t;
}

/** Checks the weights of a blend of this many keys. */
export function checkWeights(given: unknown, keys: number): number[] {
  const wrong = ofKind.weights(given);
  if (wrong) throw invalidOption(`The weights of a blend ${wrong}.`);
  const weights = given as number[];
  if (weights.length !== keys)
    throw invalidOption(`There are ${weights.length} weights for ${keys} keys. Give one per key.`);
  return [...weights];
}

/** Checks the number of samples of a discrete path; the core checks the lower limit. */
export function checkSamples(given: unknown): number {
  if (!Number.isSafeInteger(given) || (given as number) < 0 || (given as number) > MAX_SAMPLES)
    throw invalidOption(`The number of samples must be a whole number of at most ${grouped(MAX_SAMPLES)}.`);
  return given as number;
}

/** Checks a face index. Also used for patch indices, which never exceed the number of faces. */
export function checkFace(given: unknown, faces: number, what = 'face'): number {
  if (!Number.isSafeInteger(given) || (given as number) < 0 || (given as number) >= faces)
    throw invalidOption(`The index of a ${what} must be a whole number from 0 to ${grouped(faces - 1)}.`);
  return given as number;
}

export function checkTimes(given: unknown): number[] {
  const wrong = times(given);
  if (wrong) throw invalidOption(`Times ${wrong}.`);
  return [...(given as number[])];
}
