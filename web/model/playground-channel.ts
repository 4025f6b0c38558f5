/** Messages between the app and the playground in one browser. */
import type { Boundary } from '../engine/api/types.ts';

/** One coordinate of a shape, with its value at each key. */
export interface ShapeCoordinate {
  name: string;
  unit: string;
  values: number[];
}

/** Options of a motion at its keys. */
export interface KeyPassing {
  times: number[];
  boundary: Boundary;
  startSpeed: number;
  endSpeed: number;
  /** Tensions, one per key, as for `bias`. */
  tension: number[];
  bias: number[];
}

export interface SourceShape extends KeyPassing {
  /** Id of the page with the open shape. */
  page: string;
  title: string;
  coordinates: ShapeCoordinate[];
}

export type PlaygroundMessage =
  /** From the playground: a request for the open shape. */
  | { type: 'ask' }
  | { type: 'open'; shape: SourceShape }
  /** From the playground: use these options for the keys of that page's shape. */
  | ({ type: 'back'; page: string } & KeyPassing)
  | { type: 'done'; page: string };

const BOUNDARIES: readonly Boundary[] = ['natural', 'hermite', 'periodic'];
/** Upper limits for keys, coordinates and text length in our pages' messages. */
const [MAX_KEYS, MAX_COORDINATES, LONGEST] = [4096, 64, 300];

/** A valid message from the channel, otherwise null. Any page of the same host can send messages. */
export function messageFrom(data: unknown): PlaygroundMessage | null {
  if (!isRecord(data)) return null;
  const { type, page, shape } = data;
  if (type === 'ask') return { type };
  if (type === 'open') return isShape(shape) ? { type, shape } : null;
  if (!isWord(page)) return null;
  if (type === 'done') return { type, page };
  return type === 'back' && isPassing(data) ? { ...data, type, page } : null;
}

function isShape(value: unknown): value is SourceShape & Record<string, unknown> {
  if (!isRecord(value) || !isPassing(value) || !isWord(value['page']) || !isWord(value['title'])) return false;
  const keys = value.times.length;
  const isCoordinate = (one: unknown): boolean =>
    isRecord(one) && isWord(one['name']) && isWord(one['unit']) && isNumbers(one['values'], keys);
  const { coordinates } = value;
  return Array.isArray(coordinates) && coordinates.length <= MAX_COORDINATES && coordinates.every(isCoordinate);
}

function isPassing(value: Record<string, unknown>): value is KeyPassing & Record<string, unknown> {
  const { times, tension, bias, boundary, startSpeed, endSpeed } = value;
  if (!Array.isArray(times) || times.length > MAX_KEYS || !isNumbers(times, times.length)) return false;
  const ascending = times.length > 1 && times.every((time, i) => i === 0 || time > times[i - 1]!);
  const passed = isNumbers(tension, times.length) && isNumbers(bias, times.length);
  return ascending && passed && isNumbers([startSpeed, endSpeed], 2) && BOUNDARIES.includes(boundary as Boundary);
}

const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null;
const isWord = (value: unknown): value is string => typeof value === 'string' && value.length <= LONGEST;
const isNumbers = (value: unknown, count: number): value is number[] =>
  Array.isArray(value) && value.length === count && value.every((one) => Number.isFinite(one));

/** The name contains the scope, so another release of the page on the same host has its own channel. */
export function playgroundChannel(): BroadcastChannel {
  return new BroadcastChannel(`shapespline playground ${new URL('./', document.baseURI).pathname}`);
}
