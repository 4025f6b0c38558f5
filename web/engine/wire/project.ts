/**
 * A project: the content of `extras.shapespline` in an exported GLB, which restores keys, times and options. The core
 * reads the keys (wasm/io/gltf/project.h), this file the options. The text is untrusted.
 */
import { goneIn, withoutGone } from '../api/gone-options.ts';
import { ENCODING, MOTION, SHAPES, optionsIn } from '../api/option-table.ts';
import { checkProject, choiceNow } from '../api/options.ts';
import type { Point, SequenceOptions } from '../api/types.ts';

const VERSION = 1;

export interface ProjectKeys {
  /** Key times in the user's unit of time. */
  times: readonly number[];
  names: readonly string[];
  /** Frame of each key: 0 is the mesh itself, k its morph target k - 1. */
  frames: readonly number[];
}

/** The mesh as written, and the largest playback error relative to the diagonal. */
export interface ProjectMesh {
  vertices: number;
  faces: number;
  error: number | null;
}

/** Playback speed of the animation relative to its key times, and its range of key times. */
export interface ProjectPlay {
  speed: number;
  start: number;
  end: number;
}

/** JSON stores shapes as base64 of little-endian float32. */
export function writeProject(
  keys: ProjectKeys,
  options: SequenceOptions,
  mesh: ProjectMesh,
  play: Partial<ProjectPlay> = {},
  offset: Point = [0, 0, 0],
): string {
  const shapes = SHAPES.map((name) => [name, options[name] && toBase64(options[name])]);
  return JSON.stringify({
    version: VERSION,
    keys,
    mesh,
    speed: 1,
    ...play,
    ...(offset.some((value) => value !== 0) && { offset }),
    options: { ...options, ...Object.fromEntries(shapes) },
  });
}

/** Reads the mesh; null if missing, as in files of earlier versions. */
export function readMesh(text: string): ProjectMesh | null {
  try {
    const { vertices, faces, error } = record(record(JSON.parse(text))['mesh']);
    if (typeof vertices !== 'number' || typeof faces !== 'number') return null;
    return { vertices, faces, error: typeof error === 'number' ? error : null };
  } catch {
    return null;
  }
}

/** Reads the playback speed; null if missing, as in files of earlier versions. */
export function readSpeed(text: string): number | null {
  try {
    const { speed } = record(JSON.parse(text));
    return typeof speed === 'number' && speed > 0 && Number.isFinite(speed) ? speed : null;
  } catch {
    return null;
  }
}

/** Reads the played range; null if missing, as in files of earlier versions. */
export function readPlayed(text: string): [start: number, end: number] | null {
  try {
    const { start, end } = record(JSON.parse(text));
    const areTimes = typeof start === 'number' && typeof end === 'number' && Number.isFinite(end - start);
    return areTimes && start < end ? [start, end] : null;
  } catch {
    return null;
  }
}

/** Reads the options; null if the text has another version, or is broken or invalid. */
export function readOptions(text: string): SequenceOptions | null {
  try {
    const { version, options } = record(JSON.parse(text));
    if (version !== VERSION) return null;
    const written = withoutGone(record(options));
    const choices = [MOTION, ENCODING]
      .flatMap(optionsIn)
      .filter(([name]) => name in written)
      .map(([name, option]) => [name, choiceNow(option, written[name])]);
    const shapes = SHAPES.map((name) => [name, fromBase64(written[name])]);
    return checkProject({ ...written, ...Object.fromEntries([...choices, ...shapes]) });
  } catch {
    return null;
  }
}

/** The names of a project's options that are gone and were in use. */
export function goneOptions(text: string): string[] {
  try {
    return goneIn(record(record(JSON.parse(text))['options']));
  } catch {
    return [];
  }
}

function record(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new TypeError('not an object');
  return value as Record<string, unknown>;
}

function toBase64(numbers: Float32Array): string {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

function fromBase64(text: unknown): Float32Array | null {
  if (typeof text !== 'string') return null;
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Float32Array(bytes.buffer, 0, bytes.length >> 2);
}
