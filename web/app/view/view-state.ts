/** Content of the page outside the state: running work, results, thumbnails. It is never saved. */
import type { Frame, KeysInfo, Method, SequenceStats, Warning } from '../../engine/api/types.ts';
import type { SpeedCurve } from '../../model/speed-curve.ts';
import { USUAL_MOST } from '../../model/speeds.ts';
import type { Speeds } from '../../model/speeds.ts';
import type { Doc } from '../../model/state.ts';
import type { ExportRequest, VideoFormat } from '../../model/export-request.ts';
import { DEFAULT_REQUEST } from '../../model/export-request.ts';
import type { ErrorMessage, Working } from '../../ui/messages.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { Fewest } from '../sources/animation.ts';
import type { OpenResult } from '../sources/opener.ts';
import type { ProjectOnShelf } from '../kept/project-shelf.ts';
import type { Sample } from '../sources/samples.ts';

/** A shape off the curve: the keys blended in these weights, one per key, sum 1. */
export interface Blend {
  weights: readonly number[];
  /** Where it lies in the shape plane. */
  at: readonly [number, number];
}

/** What is seen: what is open, that dimmed, or the first key of what is being opened. */
export type Seen = 'open' | 'dimmed' | 'first key';

export interface ViewState {
  samples: readonly Sample[];
  info: KeysInfo | null;
  /** How the open files were read where they do not say it themselves, else null. */
  orientation: Orientation | null;
  /** The objects of the open files that were taken; empty for all of them. */
  objects: readonly string[];
  /** The document that the open files started with: links are written against it. */
  initial: Doc | null;
  warnings: readonly Warning[];
  /** Index of the warning whose place is marked on the shape, or null. */
  shownWarning: number | null;
  working: Working | null;
  seen: Seen;
  errorMessage: ErrorMessage | null;
  stats: SequenceStats | null;
  /** Milliseconds of the last exact frame. */
  ms: number | null;
  /** Threads that work on an exact frame; null before the first. */
  threads: number | null;
  /** Indefinite faces of the last exact frame, and one of them; -1 where none is known. */
  indefinite: number;
  indefiniteFace: number;
  /** By pose. */
  thumbnails: ReadonlyMap<number, string>;
  /** How the motion goes over time; null until it is known. */
  speedCurve: SpeedCurve | null;
  /** Hermite: the fastest on offer at the ends. */
  mostSpeeds: Speeds;
  /** Of the moment that the mouse points at on the timeline, as an address; null = none of this motion. */
  timePicture: string | null;
  welcome: boolean;
  offline: boolean;
  /** The user's files are kept in this browser for the next visit. */
  remembered: boolean;
  /** All files of the user that are kept, the last changed first. */
  shelf: readonly ProjectOnShelf[];
  singleKeys: boolean;
  /** The next click on the shape pins it there. */
  placing: boolean;
  /** What was compared before there was a divider. */
  beside: readonly Method[];
  /** What was found when the fewest keys of an animation were looked for. */
  fewest: Fewest | null;
  /** The animation is shown beside the motion. */
  original: boolean;
  /** The sheet that asks which keys to take of an animation is up. */
  opening: boolean;
  /** Shown instead of the motion, until the time moves. */
  blend: Blend | null;
  /** What the browser can write; null until the export dialog has asked. */
  videoFormats: readonly VideoFormat[] | null;
  exporting: { request: ExportRequest; plan: { text: string; warnings: readonly string[] } | null };
}

export interface ViewStateHolder {
  get(): ViewState;
  change(part: Partial<ViewState>): void;
}

/** What other files bring with them. */
export function openedView(opened: OpenResult, before: ViewState): Partial<ViewState> {
  const { info, initial, orientation, objects, source } = opened;
  return {
    info,
    initial,
    orientation,
    objects,
    warnings: info.warnings,
    thumbnails: new Map(),
    speedCurve: null,
    mostSpeeds: USUAL_MOST,
    timePicture: null,
    placing: false,
    fewest: null,
    original: opened.stays === true && before.original,
    opening: opened.picked ? asksForKeys(info) : opened.stays === true && before.opening,
    blend: null,
    stats: null,
    shownWarning: null,
    indefinite: 0,
    indefiniteFace: -1,
    ms: null,
    threads: null,
    welcome: before.welcome && source.kind === 'sample',
  };
}

/** There is more in the animations than the keys: project files, and poses of their own, have said what is wanted. */
function asksForKeys({ animation, animations, names, project, warnings }: KeysInfo): boolean {
  const alike = warnings.some(({ code }) => code === 'same-poses');
  const moving = animations.filter(({ moves }) => moves);
  const whole = moving.length === 1 && moving[0]!.keys <= names.length;
  return project === null && moving.length > 0 && (animation >= 0 ? !whole : alike);
}

/** What is to be said of the frame on the screen. */
export function shownView(frame: Frame | undefined): Partial<ViewState> {
  return {
    ms: frame?.ms ?? null,
    threads: frame?.threads ?? null,
    indefinite: frame?.indefiniteFaces ?? 0,
    indefiniteFace: frame?.indefiniteFace ?? -1,
  };
}

export function createViewState(onChange: () => void): ViewStateHolder {
  let viewState = EMPTY_VIEW_STATE;
  return {
    get: () => viewState,
    change(part) {
      viewState = { ...viewState, ...part };
      onChange();
    },
  };
}

const EMPTY_VIEW_STATE: ViewState = {
  samples: [],
  info: null,
  orientation: null,
  objects: [],
  initial: null,
  warnings: [],
  shownWarning: null,
  working: null,
  seen: 'open',
  errorMessage: null,
  stats: null,
  ms: null,
  threads: null,
  indefinite: 0,
  indefiniteFace: -1,
  thumbnails: new Map(),
  speedCurve: null,
  mostSpeeds: USUAL_MOST,
  timePicture: null,
  welcome: true,
  offline: false,
  remembered: false,
  shelf: [],
  singleKeys: true,
  placing: false,
  beside: [],
  fewest: null,
  original: false,
  opening: false,
  blend: null,
  videoFormats: null,
  exporting: { request: { ...DEFAULT_REQUEST }, plan: null },
};
