/** What the page shows besides the state: work under way, what was found, pictures. It is never saved. */
import type { KeysInfo, SequenceStats, Warning } from '../../engine/api/types.ts';
import type { Doc } from '../../model/state.ts';
import type { ExportRequest } from '../../ui/export-dialog.ts';
import { DEFAULT_REQUEST } from '../../ui/export-dialog.ts';
import type { Problem, Working } from '../../ui/messages.ts';
import type { Orientation } from '../../ui/orientation.ts';
import type { Sample } from '../sources/samples.ts';

export interface ViewState {
  samples: readonly Sample[];
  info: KeysInfo | null;
  /** How the open files were read where they do not say it themselves, else null. */
  orientation: Orientation | null;
  /** The document that the open files started with: links are written against it. */
  initial: Doc | null;
  warnings: readonly Warning[];
  /** Index of the warning whose place is marked on the shape, or null. */
  shownWarning: number | null;
  working: Working | null;
  problem: Problem | null;
  stats: SequenceStats | null;
  /** The range of the running sequence. */
  range: readonly [number, number];
  /** Of the last exact shape. */
  ms: number | null;
  /** That work on an exact shape; null before the first. */
  threads: number | null;
  /** Of the shape on the screen where that is about right only, else null. */
  aboutMs: number | null;
  /** Faces of that shape that have turned inside out, and one of them; -1 where none is known. */
  lost: number;
  lostFace: number;
  /** By pose. */
  thumbnails: ReadonlyMap<number, string>;
  welcome: boolean;
  offline: boolean;
  /** The user's files are kept in this browser for the next visit. */
  remembered: boolean;
  singleKeys: boolean;
  exporting: { request: ExportRequest; plan: { text: string; warnings: readonly string[] } | null };
}

export const EMPTY_VIEW_STATE: ViewState = {
  samples: [], info: null, orientation: null, initial: null, warnings: [], shownWarning: null, working: null, problem: null, stats: null, range: [0, 1], ms: null, threads: null, aboutMs: null, lost: 0, lostFace: -1,
  thumbnails: new Map(), welcome: false, offline: false, remembered: false, singleKeys: true, exporting: { request: { ...DEFAULT_REQUEST }, plan: null },
};
