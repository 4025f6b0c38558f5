/** What an export is made from: the sequence as far as it takes part, and the frames that were planned. */
import type { Frame, Scene, SequenceOptions } from '../api/types.ts';
import type { KeyData } from '../wire/protocol.ts';
import type { Frames } from './export-plan.ts';
import type { PrincipalTargets } from './principal-targets.ts';
import type { WorkerClient } from './worker-client.ts';

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
  freshWorker(): WorkerClient;
  frame(t: number): Promise<Frame>;
  /** Of an animated GLB without its images: its bytes, and the vertices of its primitives. */
  glbSize(
    faces: Uint32Array,
    vertices: number,
    frames: number,
    scene: Scene,
  ): Promise<{ bytes: number; vertices: number }>;
}
