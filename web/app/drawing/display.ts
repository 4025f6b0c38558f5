/** Schedules everything on the screen: scene, frames, thumbnails and markers. */
import { FirstKey } from './first-key.ts';
import { createMarking } from './marking.ts';
import type { Marking } from './marking.ts';
import { createPinPaths } from './pin-paths.ts';
import type { PinPaths } from './pin-paths.ts';
import { SceneController } from './scene-controller.ts';
import { createTimePictures } from './time-pictures.ts';
import type { TimePictures } from './time-pictures.ts';
import { createThumbnails } from './thumbnails.ts';
import type { Thumbnails } from './thumbnails.ts';
import type { Feedback } from '../view/feedback.ts';
import type { FilmLabel } from '../../ui/film-labels.ts';
import { shownView } from '../view/view-state.ts';
import type { ViewStateHolder } from '../view/view-state.ts';
import type { CameraPose } from '../../model/camera.ts';
import type { ViewerEvents } from '../../viewer/viewer.ts';
import type { FrameSet } from '../../playback/frame-set.ts';
import { createPlayback } from '../playback/playback.ts';
import type { Playback } from '../playback/playback.ts';
import type { Session } from '../session/session.ts';

/** The surface for drawing the scene. */
export interface DisplayArea {
  viewport: HTMLElement;
  /** Shows names on the image of a film strip. */
  showFilmLabels(labels: readonly FilmLabel[]): void;
  covered: ViewerEvents['covered'];
}

export interface DisplayParts {
  session: Session;
  area: DisplayArea;
  viewState: ViewStateHolder;
  feedback: Feedback;
  seek(t: number): void;
  onResize(): void;
}

export interface Display {
  scene: SceneController;
  playback: Playback;
  firstKey: FirstKey;
  thumbnails: Thumbnails;
  timePictures: TimePictures;
  marking: Marking;
  pinPaths: PinPaths;
}

export function createDisplay({ session, area, viewState, feedback, seek, onResize }: DisplayParts): Display {
  const { store, workspace, restart, sequence, range } = session;
  const { say, onError } = feedback;
  const events = {
    onCamera: (camera: CameraPose) => store.set({ view: { ...store.get().view, camera } }),
    onResize,
    covered: area.covered,
    onContextLost: () => say('The browser lost access to the graphics card. The image will be restored.'),
    onContextRestored: () => void playback.frameLoop.request(store.get().time),
  };
  const scene = new SceneController(area.viewport, events, area.showFilmLabels);
  void scene.viewer.firstSeen.then(() => performance.mark('shapespline seen'));
  const yields = (): boolean => viewState.page.working !== null;
  const show = async (frames: FrameSet): Promise<void> => {
    // A request for the open shape ends the display of the first key.
    if (firstKey.isShown) firstKey.end();
    await scene.show(frames, store.get(), range());
    viewState.changeOpened(shownView(frames.frames[0]));
  };
  const playback = createPlayback({
    store,
    range,
    sequences: () => workspace.sequences,
    blend: () => viewState.opened.blend?.weights ?? null,
    screen: {
      show,
      // The drawing time is known only after the GPU has finished.
      drawn: () => (yields() ? scene.viewer.finished() : scene.viewer.drawn()),
      yields,
      onError: (error) => {
        if (!restart.takesUp(error)) onError(error);
      },
    },
  });
  const firstKey = new FirstKey({
    rest: playback.rest,
    resume: playback.resume,
    async show(opening) {
      scene.showFirstKey(opening);
      await scene.viewer.textured();
      performance.mark('shapespline first key');
    },
    hide: () => scene.hideFirstKey(),
    onSeen: (seen) => viewState.change({ seen }),
  });
  const thumbnails = createThumbnails({
    store,
    workspace,
    scene,
    // Thumbnails are drawn after the main view.
    idle: () => playback.frameLoop.idle().then(() => scene.viewer.finished()),
    has: (pose) => viewState.opened.thumbnails.has(pose),
    onThumbnail: (pose, url) =>
      viewState.changeOpened({ thumbnails: new Map(viewState.opened.thumbnails).set(pose, url) }),
  });
  const timePictures = createTimePictures({
    sequence,
    isPlaying: () => store.get().play.playing,
    idle: () => playback.frameLoop.idle(),
    draw: (frame) => scene.timePicture(frame, store.get(), range()),
    onPicture: (timePicture) => viewState.changeOpened({ timePicture }),
  });
  const pinPaths = createPinPaths({
    motion: sequence,
    pins: () => store.get().doc.motion.pins,
    idle: () => playback.frameLoop.idle(),
    onPaths: () => scene.viewer.invalidate(),
  });
  const marking = createMarking({
    scene,
    sequence,
    range,
    onError,
    seek,
    warnings: () => viewState.opened.warnings,
    keyTimes: () => store.get().doc.keys.map(({ time }) => time),
    onWarning: (shownWarning) => viewState.changeOpened({ shownWarning }),
  });
  return { scene, playback, firstKey, thumbnails, timePictures, marking, pinPaths };
}
