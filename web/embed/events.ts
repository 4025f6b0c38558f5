/** Events of <shape-spline>. Events do not bubble: a page with several elements listens to each of them. */

export interface LoadDetail {
  vertices: number;
  faces: number;
  /** Times of the keys. */
  keyTimes: readonly number[];
}
export interface ErrorDetail {
  /** Stable: a code of the engine, `not-found`, `not-a-model`, `no-source` or `no-webgl`; `failed` for other errors. */
  code: string;
  /** A sentence for users: the problem and what to do. */
  message: string;
  /** Index of the key concerned; -1 for none. */
  key: number;
}
export interface ProgressDetail {
  stage: string;
  /** Progress of the whole work, in [0, 1], never decreasing. */
  fraction: number;
}
export interface TimeDetail {
  currentTime: number;
}
export interface KeyDetail {
  /** Index of the last key at or before the time. */
  index: number;
}

/** Type of each event's detail. */
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

/** Descriptions for the manifest and the documentation. */
export const EVENTS: Readonly<Record<keyof EventDetails, { detail: string; doc: string }>> = {
  load: {
    detail: '{ vertices, faces, keyTimes }',
    doc: 'The shape is drawn for the first time, or again after its keys or its motion changed.',
  },
  error: {
    detail: '{ code, message, key }',
    doc: 'The motion cannot be shown. The message states the reason and what to do.',
  },
  progress: { detail: '{ stage, fraction }', doc: 'Progress of fetching and computing.' },
  play: { detail: 'null', doc: 'Playback started.' },
  pause: { detail: 'null', doc: 'Playback paused.' },
  timeupdate: { detail: '{ currentTime }', doc: 'A new time is shown.' },
  seeked: { detail: '{ currentTime }', doc: 'The time requested with `seek()` is shown.' },
  loopend: { detail: '{ currentTime }', doc: 'Playback reached an end of its range.' },
  keychange: { detail: '{ index }', doc: 'The last key at or before the current time has changed.' },
};
