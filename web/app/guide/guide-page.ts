/** One page of the guide: a state of the app, and what is said of it. */
import type { Keys, Motion } from '../../engine/api/api.ts';
import type { SequenceStats, Stretch } from '../../engine/api/types.ts';
import type { Plot } from '../../model/state.ts';
import type { Formula } from '../../ui/guide-panel.ts';
import type { PanelName } from '../panels/layout.ts';

/** Numbers of what is shown, as the engine has them; null while it computes. */
export interface Facts {
  keyTimes: readonly number[];
  faces: number;
  patches: number;
  /** Volume in whole percent of the first key's, of this method and of the one beside it. */
  volumes: readonly string[];
  stats: SequenceStats;
  stretch: Stretch;
  /** Milliseconds of the last exact frame. */
  ms: number | null;
}

export interface GuidePage {
  /** The fragment of its link, without '#'. */
  link: string;
  title: string;
  /** The state of the app, as a link has it. */
  state: string;
  /** The options or plots that it speaks of. */
  panel?: PanelName;
  /** What of that panel is brought in sight, by its test id. */
  part?: string;
  /** The plot that it speaks of: the first one of a presentation. */
  plot?: Plot;
  /** Options and plots have more room than the rest of the time. */
  wide?: true;
  /** A control that is pressed for the reader, by its test id; a tick is taken back with the page. */
  press?: string;
  /** A field that is filled in for the reader, by its test id; it is emptied with the page. */
  fill?: { field: string; value: string };
  /** What is seen: a few sentences. */
  text: string;
  /** What the reader does. */
  task: string;
  /** What is to be remembered of it. */
  sentence: string;
  /** Numbers from the engine, in words. */
  live?(facts: Facts): string;
  /** Numbers that the engine is asked for, in words; `poses` are those of the file, keys or not. */
  ask?(sequence: Motion, facts: Facts, poses: Keys): Promise<string>;
  formula?: Formula;
  more?: string;
  /** A page of its own that it speaks of; where there is room it stands in the place of the options, under a title. */
  beside?: { label: string; href: string; framed: string };
}
