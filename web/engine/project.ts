/**
 * A project: what an exported GLB holds in `extras.shapespline` besides its frames, so that it opens again with the same
 * keys, times and options. The text comes from a file and is trusted in nothing.
 */
import { checkSequenceOptions } from './options.ts';
import type { SequenceOptions } from './types.ts';

const VERSION = 1;

export interface Project {
  keys: {
    /** In the user's unit of time. */
    times: number[];
    names: string[];
    /** On the exported animation's own time line, in the float32 that the file holds. */
    seconds: number[];
  };
  options: Partial<SequenceOptions>;
}

/** Options as JSON holds them: end tangents as base64 of little-endian float32. */
type StoredOptions = Omit<Partial<SequenceOptions>, 'startTangent' | 'endTangent'> & {
  startTangent?: string;
  endTangent?: string;
};

export function writeProject({ keys, options }: Project): string {
  const { startTangent, endTangent, ...rest } = options;
  const stored: StoredOptions = { ...rest };
  if (startTangent) stored.startTangent = toBase64(startTangent);
  if (endTangent) stored.endTangent = toBase64(endTangent);
  return JSON.stringify({ version: VERSION, keys, options: stored });
}

/** null where there is none, 'unreadable' where it is of another version, broken or made by hand. */
export function readProject(text: string): Project | 'unreadable' | null {
  if (text === '') return null;
  try {
    return parse(JSON.parse(text));
  } catch {
    return 'unreadable';
  }
}

function parse(json: unknown): Project {
  const { version, keys, options } = record(json);
  if (version !== VERSION) throw new TypeError('another version');
  const { times, names, seconds } = record(keys);
  if (!isNumbers(times) || !isNumbers(seconds) || !isStrings(names)) throw new TypeError('keys');
  if (times.length < 2 || times.length !== names.length || times.length !== seconds.length) throw new TypeError('keys');
  const { startTangent, endTangent, ...rest } = record(options);
  return {
    keys: { times, names, seconds },
    options: checkSequenceOptions({ ...rest, startTangent: tangent(startTangent), endTangent: tangent(endTangent) }),
  };
}

function record(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new TypeError('not an object');
  return value as Record<string, unknown>;
}

const isNumbers = (value: unknown): value is number[] => Array.isArray(value) && value.every((v) => Number.isFinite(v));
const isStrings = (value: unknown): value is string[] => Array.isArray(value) && value.every((v) => typeof v === 'string');

function tangent(value: unknown): Float32Array | null {
  return typeof value === 'string' ? fromBase64(value) : null;
}

function toBase64(numbers: Float32Array): string {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

function fromBase64(text: string): Float32Array {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Float32Array(bytes.buffer, 0, bytes.length >> 2);
}
