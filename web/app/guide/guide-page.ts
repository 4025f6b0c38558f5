/** One page of the guide: a state of the app and its text. */
import type { Keys, Motion } from '../../engine/api/api.ts';
import type { SequenceStats, Stretch } from '../../engine/api/types.ts';
import type { Plot } from '../../model/state.ts';
import type { Formula } from '../../ui/guide-panel.ts';
import type { PanelName } from '../panels/layout.ts';

/** Numbers of the shown motion, from the engine; null while they are computed. */
export interface Facts {
  keyTimes: readonly number[];
  faces: number;
  patches: number;
  /** Volume in whole percent of the first key's, for this method and the compared one. */
  volumes: readonly string[];
  stats: SequenceStats;
  stretch: Stretch;
  /** Milliseconds of the last frame. */
  ms: number | null;
}

export interface GuidePage {
  /** Fragment of the page's link, without '#'. */
  link: string;
  title: string;
  /** The state of the app, encoded as in a link. */
  state: string;
  /** The panel that the page describes. */
  panel?: PanelName;
  /** Id of the panel's part to scroll to. */
  part?: string;
  /** The plot that the page describes; a presentation shows it first. */
  plot?: Plot;
  /** Panels have more width than usual. */
  wide?: true;
  /** Id of a control that the page presses. Leaving the page clears a check box that it ticked. */
  press?: string;
  /** A field that the page fills in, by its id. Leaving the page empties it. */
  fill?: { field: string; value: string };
  /** Describes the view in a few sentences. */
  text: string;
  /** The reader's task. */
  task: string;
  /** The sentence to remember. */
  sentence: string;
  /** Text with numbers from the engine. */
  live?(facts: Facts): string;
  /**
   * Text with numbers that are requested from the engine; `poses` are all poses of the file, including those that are
   * not keys.
   */
  ask?(sequence: Motion, facts: Facts, poses: Keys): Promise<string>;
  formula?: Formula;
  more?: string;
  /** A related page of this site. If there is room, it replaces the panels, under a title. */
  beside?: { label: string; href: string; framed: string };
}
