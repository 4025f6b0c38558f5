/** What the parts of the app share. */
import type { Engine } from '../engine/api/api.ts';
import type { Range } from '../model/time-scale.ts';
import type { Picture } from './drawing/scene-controller.ts';
import type { FrameLoop } from './playback/frame-loop.ts';
import type { ViewState } from './panels/view-state.ts';
import type { Store } from './session/store.ts';
import type { Workspace } from './session/workspace.ts';

export interface Context {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  picture: Picture;
  frameLoop: FrameLoop;
  viewState(): ViewState;
  /** Changes what is shown besides the state. */
  inform(change: Partial<ViewState>): void;
  /** Where the keys define the motion, also while an edit is still being worked out. */
  range(): Range;
  reducedMotion(): boolean;
  /** Short news. */
  say(text: string): void;
  /** Shows a failure; a cancelled call is none. */
  fail(error: unknown): void;
}
