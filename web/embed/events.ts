/** What <shape-spline> tells of itself. No event bubbles: a page with several elements listens to each. */

export interface LoadDetail {
  vertices: number;
  faces: number;
  /** Times of the keys. */
  keyTimes: readonly number[];
}
export interface ErrorDetail {
  /** Stable: the engine's codes, `not-found`, `not-a-model`, `no-source`, `no-webgl`. */
  code: string;
  /** A sentence for people: what is wrong and what to do. */
  message: string;
  /** Index of the key that it is about; -1 where there is none. */
  key: number;
}
export interface ProgressDetail {
  stage: string;
  /** Of the whole work, in [0, 1], never falling. */
  fraction: number;
}
export interface TimeDetail {
  currentTime: number;
}
export interface KeyDetail {
  /** The key that was reached last. */
  index: number;
}

/** Type of the event's detail by its name. */
export interface EventDetails {
  load: LoadDetail;
  error: ErrorDetail;
  progress: ProgressDetail;
  play: null;
  pause: null;
  timeupdate: TimeDetail;
  seeked: TimeDetail;
  loopend: TimeDetail;
  keychange: KeyDetail;
}

export type ShapeSplineEventMap = { [N in keyof EventDetails]: CustomEvent<EventDetails[N]> };

/** For the manifest and the documentation. */
export const EVENTS: Readonly<Record<keyof EventDetails, { detail: string; doc: string }>> = {
  load: {
    detail: '{ vertices, faces, keyTimes }',
    doc: 'The shape is drawn: at first, and again when its keys or its motion have changed.',
  },
  error: { detail: '{ code, message, key }', doc: 'It cannot be shown; the message says why and what to do.' },
  progress: { detail: '{ stage, fraction }', doc: 'Of fetching and computing.' },
  play: { detail: 'null', doc: 'It begins to play.' },
  pause: { detail: 'null', doc: 'It plays no more.' },
  timeupdate: { detail: '{ currentTime }', doc: 'Another moment is drawn.' },
  seeked: { detail: '{ currentTime }', doc: 'The moment that was asked for is drawn.' },
  loopend: { detail: '{ currentTime }', doc: 'It has played to an end of its range.' },
  keychange: { detail: '{ index }', doc: 'It has reached another key.' },
};
