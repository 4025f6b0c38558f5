/** What the app and the playground tell each other where both are open in one browser. */
import type { Boundary } from '../engine/api/types.ts';

/** One number that a shape is described by, at each of its keys. */
export interface ShapeCoordinate {
  name: string;
  unit: string;
  values: number[];
}

/** How a motion passes its keys. */
export interface KeyPassing {
  times: number[];
  boundary: Boundary;
  startSpeed: number;
  endSpeed: number;
  /** One per key, as `bias` is. */
  tension: number[];
  bias: number[];
}

export interface OpenShape extends KeyPassing {
  /** The page that it is open in. */
  page: string;
  title: string;
  coordinates: ShapeCoordinate[];
}

export type PlaygroundMessage =
  /** From the playground: what is open? */
  | { type: 'ask' }
  | { type: 'open'; shape: OpenShape }
  /** From the playground: pass the keys of that page's shape like this. */
  | ({ type: 'back'; page: string } & KeyPassing)
  | { type: 'done'; page: string };

/** Another release of the page may stand beside this one on the same host: each has its own. */
export function playgroundChannel(): BroadcastChannel {
  return new BroadcastChannel(`shapespline playground ${new URL('./', document.baseURI).pathname}`);
}
