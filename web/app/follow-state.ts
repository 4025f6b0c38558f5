/** Reactions to changes of the state, its files and its motions. */
import type { Warning } from '../engine/api/types.ts';
import type { Context } from './actions/context.ts';
import { withPlaces } from './drawing/warning-places.ts';
import type { Session, SessionEvents } from './session/session.ts';
import { changesBetween } from './session/state-changes.ts';

/** Passes each change of the state, loaded files and finished motions to the parts concerned. */
export function followState(context: Context, onOpened: () => void, redraw: () => void): void {
  const { session, display, viewState, fileIntake, link, remembered } = context;
  const { store } = session;
  session.listen(sessionEvents(context));
  let before = store.get();
  store.subscribe((state) => {
    const changed = changesBetween(before, state);
    before = state;
    if (changed.time || changed.started || changed.motions || changed.opened) showMotion(context);
    if (changed.motions) serveAfterFirst(context);
    if (changed.look) applyLook(context);
    display.playback.follow(state, changed);
    if (changed.opened) {
      fileIntake.forget();
      onOpened();
    } else if (changed.motions) viewState.change({ welcome: false });
    // The user's files have no link, so the URL is cleared even while they play.
    if (!state.play.playing || changed.opened) link.follow();
    if (!state.play.playing || changed.opened || changed.motions) remembered.follow();
    redraw();
  });
}

/** Shows the motion again instead of a blend of the keys. */
export function showMotion({ viewState }: Context): void {
  if (viewState.opened.blend) viewState.changeOpened({ blend: null });
}

export function applyLook({ session: { store }, display, theme }: Context): void {
  display.scene.setLook(store.get().view, theme.isDark());
  display.timePictures.forget();
}

/** Makes the motions once the first shape is drawn, so further motions do not delay it. */
function serveAfterFirst({ session: { serve, store }, display: { scene, playback } }: Context): void {
  if (scene.viewer.hasSeen) return serve();
  void scene.viewer.firstSeen.then(serve);
  playback.frameLoop.follow(store.get().time);
}

/** Reactions to loaded files and finished motions. */
function sessionEvents(context: Context): SessionEvents {
  const { feedback, display, session } = context;
  const { firstKey, scene } = display;
  return {
    onApplied: () => showApplied(context),
    onRestart() {
      feedback.say('The browser stopped the computation. It restarts now, and nothing was lost.');
      void display.playback.frameLoop.request(session.store.get().time);
    },
    onWorking: feedback.onWorking,
    onRead: (info) => scene.expect(info),
    onLarge: () => firstKey.begin(),
    onKeys(opening) {
      if (opening) void firstKey.show(opening);
      else firstKey.end();
    },
    onGivenUp: () => firstKey.end(),
    onError: feedback.onError,
  };
}

/** The motions match the document. */
function showApplied({ session, display, viewState, feedback, analysis, motionSpeed }: Context): void {
  const main = session.sequence();
  if (!main) return;
  viewState.changeOpened({ warnings: warningsOf(session) });
  display.marking.follow();
  main.shape.stats().then((stats) => viewState.changeOpened({ stats }), feedback.onError);
  display.playback.frameLoop.follow(session.store.get().time);
  analysis.invalidate();
  motionSpeed.refresh();
  display.pinPaths.refresh();
  display.timePictures.forget();
  display.thumbnails.refresh();
}

/** The warnings, each with its location in the pose of its key. */
function warningsOf({ store, workspace }: Session): Warning[] {
  const { info, pool } = workspace;
  const { keys } = store.get().doc;
  const warnings = workspace.warningsOf(keys);
  if (!info || !pool) return warnings;
  return withPlaces(warnings, info.faces, (key) => {
    const pose = keys[key]?.pose;
    return pose === undefined ? null : pool.keys.positions(pose);
  });
}
