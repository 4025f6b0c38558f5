/** Translates changes of the state into requests to the frame loop and the playback clock. */
import type { AppState } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import type { RunningMotion } from '../../playback/frame-set.ts';
import type { StateChanges } from '../session/state-changes.ts';
import type { Store } from '../session/store.ts';
import { Demand } from '../../playback/demand.ts';
import { FrameLoop } from '../../playback/frame-loop.ts';
import type { Screen } from '../../playback/frame-loop.ts';
import { Player } from '../../playback/player.ts';

export interface PlaybackParts {
  store: Store;
  screen: Screen;
  sequences(): readonly RunningMotion[];
  range(): Range;
  /** The blend of keys shown instead of the motion, or null. */
  blend(): readonly number[] | null;
}

export interface Playback {
  frameLoop: FrameLoop;
  /** Stops playback until `resume`, in any state; resolves when no work is left. */
  rest(): Promise<void>;
  resume(): void;
  /** Call when the state has changed. */
  follow(state: AppState, changed: StateChanges): void;
}

export function createPlayback({ store, screen, sequences, range, blend }: PlaybackParts): Playback {
  const frameLoop = new FrameLoop(screen, new Demand(sequences, blend));
  const player = new Player(
    () => {
      const { time, play, doc } = store.get();
      return { time, play, range: range(), periodic: doc.motion.boundary === 'periodic' };
    },
    (time, playing) => store.set({ time, play: { ...store.get().play, playing } }),
    () => frameLoop.advance(),
  );
  let rests = false;
  const play = (): void => {
    if (rests) return;
    frameLoop.play(player);
    player.start();
  };
  return {
    frameLoop,
    rest() {
      rests = true;
      player.stop();
      return frameLoop.rest();
    },
    resume() {
      rests = false;
      if (store.get().play.playing) play();
    },
    follow({ time, play: { playing } }, changed) {
      if (changed.drawing) void frameLoop.request(time);
      else if (changed.time && !playing) frameLoop.follow(time);
      if (changed.started) play();
      if (changed.stopped) {
        player.stop();
        frameLoop.pause();
        frameLoop.follow(time);
      }
    },
  };
}
