/** Input of an export: parts of the sequence, and the planned frames. */
import type { Frame, SequenceOptions } from '../api/types.ts';
import type { FileCalls, KeyData } from '../wire/protocol.ts';
import type { Frames } from './export-plan.ts';
import type { PrincipalTargets } from './principal-targets.ts';
import type { FilesWorker } from './worker-client.ts';

export interface PlannedFrames extends Frames {
  /** Number of keys whose poses are stored after the stills, never shown: none, or all. */
  poses: number;
  /** Replaces one target per time. */
  principal: PrincipalTargets | null;
  /** Largest distance between playback and motion, relative to the diagonal; null without an animation. */
  error: number | null;
}

export interface ExportSource {
  keys: KeyData;
  keyTimes: readonly number[];
  options: SequenceOptions;
  range: readonly [number, number];
  /** The last plan and its options, cached because planning can cost as much as exporting. */
  planned: { latest: { for: string; frames: PlannedFrames; rounding: number | null } | null };
  /** Starts a worker for this export alone. */
  filesWorker(): FilesWorker;
  frame(t: number): Promise<Frame>;
  glbSize(request: FileCalls['glbSize']['request']): Promise<FileCalls['glbSize']['result']>;
}
