/**
 * Checks of what callers pass as options: an unknown name, a wrong type or a value out of range is refused with
 * code 'invalid-option' and the option's name, before anything is posted to a worker.
 */
import { invalidOption } from './errors.ts';
import {
  EXPORT_DEFAULTS, IMPORT_DEFAULTS, SEQUENCE_DEFAULTS,
  type EncodingOptions, type ExportOptions, type ImportOptions, type MotionOptions, type SequenceOptions,
} from './types.ts';

/** What is wrong with a value, such as 'must be a number', or null. */
type Check = (value: unknown) => string | null;
type Checks<T> = { [K in keyof T]-?: Check };

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
const isWhole = (value: unknown): value is number => isNumber(value) && Number.isInteger(value);

const number: Check = (v) => (isNumber(v) ? null : 'must be a finite number');
const positive: Check = (v) => (isNumber(v) && v > 0 ? null : 'must be a number above 0');
const boolean: Check = (v) => (typeof v === 'boolean' ? null : 'must be true or false');
const floats: Check = (v) => (v instanceof Float32Array ? null : 'must be a Float32Array of positions');
/** Of what the core holds in 32 bits. */
const MOST = 2 ** 31 - 1;
const wholeFrom = (least: number): Check => (v) => {
  if (!isWhole(v) || v < least) return `must be a whole number of at least ${least}`;
  return v <= MOST ? null : `must be at most ${MOST}`;
};
const oneOf = (...names: string[]): Check => (v) =>
  names.includes(v as string) ? null : `must be one of ${names.map((n) => `'${n}'`).join(', ')}`;
const orNull = (check: Check): Check => (v) => (v === null ? null : check(v));
const numbers: Check = (v) => (Array.isArray(v) && v.every(isNumber) ? null : 'must be an array of finite numbers');
const range: Check = (v) =>
  Array.isArray(v) && v.length === 2 && v.every(isNumber) && v[0] < v[1] ? null : 'must be [first, last] with first < last';

const turns: Check = (v) => {
  const good = (entry: unknown): boolean => {
    if (typeof entry !== 'object' || entry === null) return false;
    const { key, turns: count, component = 0, ...rest } = entry as Record<string, unknown>;
    return !wholeFrom(1)(key) && !wholeFrom(-MOST)(count) && !wholeFrom(0)(component) && Object.keys(rest).length === 0;
  };
  return Array.isArray(v) && v.every(good) ? null
    : 'must be an array of { key, turns, component? } with whole numbers, key at least 1 and component at least 0';
};

const animation: Check = (v) =>
  typeof v === 'string' || !wholeFrom(0)(v) ? null : "must be an animation's name or index";
const sample: Check = (v) => {
  if (!wholeFrom(2)(v)) return null;
  const increasing = Array.isArray(v) && v.length > 0 && v.every((t, i) => isNumber(t) && (i === 0 || t > v[i - 1]));
  return increasing ? null : 'must be increasing times in seconds, or how many (at least 2)';
};

const encodingChecks: Checks<EncodingOptions> = {
  reference: wholeFrom(0),
  patches: wholeFrom(0),
  stretch: oneOf('linear', 'log'),
  ghostFaces: (v) => (v === 0 ? null : wholeFrom(4)(v) && 'must be 0 (off) or a whole number of at least 4'),
  transfer: oneOf('exact', 'paper'),
  placement: oneOf('vertices', 'optimal'),
  precision: oneOf('single', 'double', 'exact'),
  startTangent: orNull(floats),
  endTangent: orNull(floats),
};

const motionChecks: Checks<MotionOptions> = {
  method: oneOf('lri', 'geodesic', 'linear', 'cubic-vertex'),
  boundary: oneOf('natural', 'hermite', 'periodic'),
  startSpeed: number,
  endSpeed: number,
  period: orNull(positive),
  tension: numbers,
  bias: (v) => numbers(v) ?? ((v as number[]).every((b) => Math.abs(b) <= 1) ? null : 'must hold numbers from -1 to 1'),
  turns,
  inPlace: boolean,
};

const importChecks: Checks<ImportOptions> = {
  animation,
  sample,
  keyTimes: numbers,
  up: oneOf('y', 'z'),
  unit: positive,
  like: (v) => (v instanceof Uint32Array ? null : 'must be a Uint32Array of vertices'),
};

const exportChecks: Checks<ExportOptions> = {
  format: oneOf('glb', 'obj', 'ply'),
  frames: wholeFrom(2),
  range: orNull(range),
  times: orNull((v) => numbers(v) ?? ((v as number[]).length > 0 ? null : 'must name at least one time')),
  duration: orNull(positive),
  pose: orNull(number),
  inPlace: boolean,
};

/** The given options over the defaults; undefined means the default. */
function checked<T extends object>(what: string, checks: Checks<T>, defaults: Readonly<T>, given: object | undefined): T {
  const result: Record<string, unknown> = { ...defaults };
  for (const [name, value] of Object.entries(given ?? {})) {
    if (!Object.hasOwn(checks, name)) {
      throw invalidOption(`There is no ${what} option '${name}'; the names are ${Object.keys(checks).join(', ')}.`);
    }
    if (value === undefined) continue;
    const wrong = checks[name as keyof T](value);
    if (wrong) throw invalidOption(`The ${what} option '${name}' ${wrong}.`);
    result[name] = value;
  }
  return result as T;
}

export function checkImportOptions(given?: object): ImportOptions {
  return checked('import', importChecks, IMPORT_DEFAULTS, given);
}

export function checkExportOptions(given?: object): ExportOptions {
  return checked('export', exportChecks, EXPORT_DEFAULTS, given);
}

export function checkSequenceOptions(given?: object): SequenceOptions {
  return checked<SequenceOptions>('sequence', { ...encodingChecks, ...motionChecks }, SEQUENCE_DEFAULTS, given);
}

/** A change of motion options over the present ones, and the key times taken out of it. */
export function checkUpdate(present: MotionOptions, change: object): { motion: MotionOptions; keyTimes: number[] | null } {
  const { keyTimes, ...rest } = change as { keyTimes?: unknown };
  const name = Object.keys(rest).find((key) => Object.hasOwn(encodingChecks, key));
  if (name) {
    throw invalidOption(`The option '${name}' changes the encoding: make a new sequence with createSequence for it.`);
  }
  if (keyTimes !== undefined && numbers(keyTimes)) throw invalidOption("'keyTimes' must be an array of finite numbers.");
  return { motion: checked('motion', motionChecks, present, rest), keyTimes: (keyTimes as number[] | undefined) ?? null };
}

export function motionOf(options: SequenceOptions): MotionOptions {
  const { method, boundary, startSpeed, endSpeed, period, tension, bias, turns: added, inPlace } = options;
  return { method, boundary, startSpeed, endSpeed, period, tension, bias, turns: added, inPlace };
}

export function encodingOf(options: SequenceOptions): EncodingOptions {
  const { reference, patches, stretch, ghostFaces, transfer, placement, precision, startTangent, endTangent } = options;
  return { reference, patches, stretch, ghostFaces, transfer, placement, precision, startTangent, endTangent };
}

/** Names of the call options, checked like the rest. */
export function checkCall(call: object | undefined): void {
  const name = Object.keys(call ?? {}).find((key) => key !== 'signal' && key !== 'onProgress');
  if (name) throw invalidOption(`There is no call option '${name}'; the names are signal, onProgress.`);
}

export function checkTime(t: unknown): number {
  if (!isNumber(t)) throw invalidOption('A time must be a finite number.');
  return t;
}

export function checkTimes(times: unknown): number[] {
  if (numbers(times)) throw invalidOption('Times must be an array of finite numbers.');
  return [...(times as number[])];
}
