/** What an export is made from: the sequence as far as it takes part, and the frames that were planned. */
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
  /** The largest distance of what plays from the motion, as a share of the diagonal; null where nothing plays. */
  error: number | null;
}

export interface ExportSource {
  keys: KeyData;
  keyTimes: readonly number[];
  options: SequenceOptions;
  range: readonly [number, number];
  /** What was planned last, and for what: planning may cost as much as exporting. */
  planned: { latest: { for: string; frames: PlannedFrames; rounding: number | null } | null };
  /** Starts a worker that no other export uses. */
  filesWorker(): FilesWorker;
  frame(t: number): Promise<Frame>;
  glbSize(request: FileCalls['glbSize']['request']): Promise<FileCalls['glbSize']['result']>;
}
