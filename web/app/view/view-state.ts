/** Page content outside the saved state: running work, results, thumbnails. */
import type { Frame, KeysInfo, Method, SequenceStats, Warning } from '../../engine/api/types.ts';
import type { SpeedCurve } from '../../model/speed-curve.ts';
import { USUAL_MAX_SPEEDS } from '../../model/speeds.ts';
import type { Speeds } from '../../model/speeds.ts';
import type { Doc } from '../../model/state.ts';
import type { ExportRequest, VideoFormat } from '../../model/export-request.ts';
import { DEFAULT_REQUEST } from '../../model/export-request.ts';
import type { ErrorMessage, Working } from '../../ui/messages.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { Fewest } from '../sources/animation.ts';
import type { OpenResult } from '../sources/opener.ts';
import type { ProjectOnShelf } from '../storage/project-shelf.ts';
import type { Sample } from '../sources/samples.ts';

/** A shape off the curve: a blend of the keys with these weights, one per key, sum 1. */
export interface Blend {
  weights: readonly number[];
  /** The blend's position in the shape plane. */
  at: readonly [number, number];
}

/** The visible content: the open shape, the dimmed open shape, or the first key of files being opened. */
export type Seen = 'open' | 'dimmed' | 'first key';

export interface ViewState {
  samples: readonly Sample[];
  info: KeysInfo | null;
  /** Orientation of open files that do not specify it, else null. */
  orientation: Orientation | null;
  /** The chosen objects of the open files; empty for all. */
  objects: readonly string[];
  /** The initial document of the open files; links store differences from it. */
  initial: Doc | null;
  warnings: readonly Warning[];
  /** Index of the warning marked on the shape, or null. */
  shownWarning: number | null;
  working: Working | null;
  seen: Seen;
  errorMessage: ErrorMessage | null;
  stats: SequenceStats | null;
  /** Milliseconds of the last frame. */
  ms: number | null;
  /** Number of threads for a frame; null before the first frame. */
  threads: number | null;
  /** Number of indefinite faces in the last frame, and one of them; -1 if unknown. */
  indefinite: number;
  indefiniteFace: number;
  /** Thumbnails by pose index. */
  thumbnails: ReadonlyMap<number, string>;
  /** The motion's speed over time; null until known. */
  speedCurve: SpeedCurve | null;
  /** Hermite: the largest offered end speeds. */
  maxSpeeds: Speeds;
  /** Image of the time under the mouse on the timeline, as a URL; null for none. */
  timePicture: string | null;
  welcome: boolean;
  offline: boolean;
  /** This browser stores the user's files for the next visit. */
  remembered: boolean;
  /** All stored files of the user, the last changed first. */
  shelf: readonly ProjectOnShelf[];
  singleKeys: boolean;
  /** The next click on the shape pins that vertex. */
  placing: boolean;
  /** Bending energy is also measured by edge lengths and angles. */
  shellBending: boolean;
  /** The compared methods before the divider. */
  beside: readonly Method[];
  /** Result of the search for the fewest keys of an animation. */
  fewest: Fewest | null;
  /** The animation is shown beside the motion. */
  original: boolean;
  /** The dialog for choosing keys of an animation is open. */
  opening: boolean;
  /** The blend shown instead of the motion until the time changes. */
  blend: Blend | null;
  /** Formats that the browser can write; null until the export dialog has requested them. */
  videoFormats: readonly VideoFormat[] | null;
  exporting: { request: ExportRequest; plan: { text: string; warnings: readonly string[] } | null };
}

export interface ViewStateHolder {
  get(): ViewState;
  change(part: Partial<ViewState>): void;
}

/** The view state after opening other files. */
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
    maxSpeeds: USUAL_MAX_SPEEDS,
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
    exporting: opened.stays ? before.exporting : { request: forOtherFiles(before.exporting.request), plan: null },
  };
}

/** Names and times belong to the files. */
function forOtherFiles(request: ExportRequest): ExportRequest {
  const { name, range, duration, frames, rate } = DEFAULT_REQUEST;
  return { ...request, name, range, duration, frames, rate };
}

/**
 * The animation has more frames than the keys. Project files and files with separate poses do not need the question.
 */
function asksForKeys({ animation, animations, names, project, warnings }: KeysInfo): boolean {
  const alike = warnings.some(({ code }) => code === 'same-poses');
  const moving = animations.filter(({ moves }) => moves);
  const whole = moving.length === 1 && moving[0]!.keys <= names.length;
  return project === null && moving.length > 0 && (animation >= 0 ? !whole : alike);
}

/** The part of the view state that describes the shown frame. */
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
  maxSpeeds: USUAL_MAX_SPEEDS,
  timePicture: null,
  welcome: true,
  offline: false,
  remembered: false,
  shelf: [],
  singleKeys: true,
  placing: false,
  shellBending: false,
  beside: [],
  fewest: null,
  original: false,
  opening: false,
  blend: null,
  videoFormats: null,
  exporting: { request: { ...DEFAULT_REQUEST }, plan: null },
};
