/** Input of an export: parts of the sequence, and the planned frames. */
import type { Frame, SequenceOptions } from '../api/types.ts';
import type { FileCalls, KeyData } from '../wire/protocol.ts';
import type { Frames } from './export-plan.ts';
import type { PrincipalTargets } from './principal-targets.ts';
import type { FilesWorker } from './worker-client.ts';

export interface PlannedFrames extends Frames {
  /** Keys whose poses come along as well, unseen, after the stills: none, or all. */
  poses: number;
  /** Instead of a target for each time. */
  principal: PrincipalTargets | null;
  /** Largest distance between playback and motion, relative to the diagonal; null without an animation. */
  error: number | null;
}

export interface ExportSource {
  keys: KeyData;
  keyTimes: readonly number[];
  options: SequenceOptions;
  range: readonly [number, number];
  /** The last plan and its options: planning can cost as much as exporting. */
  planned: { latest: { for: string; frames: PlannedFrames; rounding: number | null } | null };
  /** Starts a worker that no other export uses. */
  filesWorker(): FilesWorker;
  frame(t: number): Promise<Frame>;
  glbSize(request: FileCalls['glbSize']['request']): Promise<FileCalls['glbSize']['result']>;
}
