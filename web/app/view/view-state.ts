/** Page content outside the saved state: running work, results, thumbnails. */
import type { Frame, KeysInfo, Method, SequenceStats, Warning } from '../../engine/api/types.ts';
import type { TimingResult } from '../../model/fitted-timing.ts';
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

/** Choices inside charts of the Analysis panel. They stay for other files, but a part that these lack is dropped. */
export interface ChartChoices {
  /** Coordinates over time of a face or of a patch. */
  part: 'face' | 'patch';
  /** The picked face and patch, counted from 0; null for none. */
  face: number | null;
  patch: number | null;
  /** The patch whose rotation relative to the picked patch is drawn; null for the one with the largest rotation. */
  neighbour: number | null;
  /** The minimiser's curve is drawn in the shape plane, with this number of samples. */
  minimised: boolean;
  samples: number;
  /** Bending energy is also measured by edge lengths and angles. */
  shellBending: boolean;
}

/** What stays while files are opened. */
export interface PageState {
  samples: readonly Sample[];
  working: Working | null;
  seen: Seen;
  errorMessage: ErrorMessage | null;
  welcome: boolean;
  offline: boolean;
  /** This browser stores the user's files for the next visit. */
  remembered: boolean;
  /** All stored files of the user, the last changed first. */
  shelf: readonly ProjectOnShelf[];
  singleKeys: boolean;
  /** The compared methods before the divider. */
  beside: readonly Method[];
  /** Formats that the browser can write; null until the export dialog has requested them. */
  videoFormats: readonly VideoFormat[] | null;
  charts: ChartChoices;
}

/** What belongs to the open files. Opening others starts with `EMPTY_OPENED`. */
export interface OpenedState {
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
  /** The next click on the shape pins that vertex. */
  placing: boolean;
  /** Result of the search for the fewest keys of an animation. */
  fewest: Fewest | null;
  /** Result of the last fit of the timing. */
  timing: TimingResult | null;
  /** The animation is shown beside the motion. */
  original: boolean;
  /** The dialog for choosing keys of an animation is open. */
  opening: boolean;
  /** The blend shown instead of the motion until the time changes. */
  blend: Blend | null;
  exporting: { request: ExportRequest; plan: { text: string; warnings: readonly string[] } | null };
}

export interface ViewState {
  page: PageState;
  opened: OpenedState;
}

export interface ViewStateHolder extends Readonly<ViewState> {
  change(part: Partial<PageState>): void;
  changeOpened(part: Partial<OpenedState>): void;
  /** Other files, or the same files in another way, are open. */
  open(result: OpenResult): void;
}

/** The state after opening: empty, except for what belongs to the same files. */
function openedState(
  { info, initial, orientation, objects, stays, picked }: OpenResult,
  before: OpenedState,
): OpenedState {
  const { original, exporting } = before;
  return {
    ...EMPTY_OPENED,
    ...(stays ? { original, exporting } : { exporting: forOtherFiles(exporting.request) }),
    info,
    initial,
    orientation,
    objects,
    warnings: info.warnings,
    opening: picked ? asksForKeys(info) : stays === true && before.opening,
  };
}

/** Names and times belong to the files. */
function forOtherFiles(request: ExportRequest): OpenedState['exporting'] {
  const { name, range, duration, frames, rate } = DEFAULT_REQUEST;
  return { request: { ...request, name, range, duration, frames, rate }, plan: null };
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
export function shownView(frame: Frame | undefined): Partial<OpenedState> {
  return {
    ms: frame?.ms ?? null,
    threads: frame?.threads ?? null,
    indefinite: frame?.indefiniteFaces ?? 0,
    indefiniteFace: frame?.indefiniteFace ?? -1,
  };
}

export function createViewState(onChange: () => void): ViewStateHolder {
  let page = EMPTY_PAGE;
  let opened = EMPTY_OPENED;
  return {
    get page() {
      return page;
    },
    get opened() {
      return opened;
    },
    change(part) {
      page = { ...page, ...part };
      onChange();
    },
    changeOpened(part) {
      opened = { ...opened, ...part };
      onChange();
    },
    open(result) {
      page = { ...page, welcome: page.welcome && result.source.kind === 'sample' };
      opened = openedState(result, opened);
      onChange();
    },
  };
}

export const NO_CHOICES: ChartChoices = {
  part: 'face',
  face: null,
  patch: null,
  neighbour: null,
  minimised: false,
  samples: 24,
  shellBending: false,
};

const EMPTY_PAGE: PageState = {
  samples: [],
  working: null,
  seen: 'open',
  errorMessage: null,
  welcome: true,
  offline: false,
  remembered: false,
  shelf: [],
  singleKeys: true,
  beside: [],
  videoFormats: null,
  charts: NO_CHOICES,
};

export const EMPTY_OPENED: OpenedState = {
  info: null,
  orientation: null,
  objects: [],
  initial: null,
  warnings: [],
  shownWarning: null,
  stats: null,
  ms: null,
  threads: null,
  indefinite: 0,
  indefiniteFace: -1,
  thumbnails: new Map(),
  speedCurve: null,
  maxSpeeds: USUAL_MAX_SPEEDS,
  timePicture: null,
  placing: false,
  fewest: null,
  timing: null,
  original: false,
  opening: false,
  blend: null,
  exporting: { request: { ...DEFAULT_REQUEST }, plan: null },
};
