/** The composition root: creates all parts, passes their dependencies and connects them. */
import { endTangents } from '../model/state.ts';
import { registerServiceWorker } from '../offline/register.ts';
import { lazy } from '../ui/lazy.ts';
import { createTheme } from '../ui/theme.ts';
import { bindActions } from './actions/action.ts';
import type { Context, IoControllers } from './actions/context.ts';
import { ACTIONS } from './actions/table.ts';
import { createAnalysisCache } from './analysis/analysis-cache.ts';
import { createMotionSpeed } from './analysis/motion-speed.ts';
import { createDisplay } from './drawing/display.ts';
import { applyLook, followState, sessionEvents } from './follow-state.ts';
import { factsOf } from './guide/facts.ts';
import type { Guide } from './guide/guide.ts';
import { createLayout } from './panels/layout.ts';
import type { Layout } from './panels/layout.ts';
import { createPage } from './panels/page.ts';
import { createSession } from './session/session.ts';
import type { Session, StartedEngine } from './session/session.ts';
import { FileIntake } from './sources/file-intake.ts';
import { createFeedback } from './view/feedback.ts';
import { createOffers } from './view/offers.ts';
import { createViewState } from './view/view-state.ts';
import { listenToLeaving, listenToNetwork, listenToPointer } from './view/window-events.ts';
import { createStartup } from './startup.ts';
import { createIoControllers } from './io-controllers.ts';

export function startApp(root: HTMLElement, engine: StartedEngine): void {
  const layout = createLayout();
  const offers = createOffers();
  const redraw = (): void => page.redraw();
  const viewState = createViewState(redraw);
  const feedback = createFeedback(viewState);
  const session = createSession(
    engine,
    sessionEvents(() => context),
  );
  const { store } = session;
  const seek = (t: number): void => commands.seek(t);
  const display = createDisplay({ session, area: layout, viewState, feedback, seek, onResize: redraw });
  const analysis = createAnalysisCache(session, () => viewState.get().ms ?? 1, feedback.onError);
  const ioControllers = createIoControllers({
    session,
    display,
    analysis,
    viewState,
    feedback,
    onOffer: offers.imported.offer,
    onGuide(fragment) {
      if (fragment === null) void guide.now?.close();
      else openGuide(fragment).catch(feedback.onError);
    },
  });
  const guide = lazy(() => loadGuide(session, ioControllers, layout, () => startup.openBegun()));
  const openGuide = async (fragment: string): Promise<boolean> => (await guide.get()).open(fragment);
  const context: Context = {
    ...ioControllers,
    session,
    display,
    viewState,
    feedback,
    analysis,
    guide,
    theme: createTheme(() => {
      applyLook(context);
      redraw();
    }),
    motionSpeed: createMotionSpeed({
      sequence: session.sequence,
      towards: () => endTangents(store.get().doc),
      onSpeed: (speedCurve, maxSpeeds) => viewState.change({ speedCurve, maxSpeeds }),
    }),
    fileIntake: new FileIntake({
      store,
      files: ioControllers.files,
      say: feedback.say,
      onOffer: offers.pose.offer,
      onPick: () => page.overlays.pickFiles(),
    }),
    offerImport: offers.imported.offer,
    get overlays() {
      return page.overlays;
    },
  };
  const commands = bindActions(ACTIONS, context);
  const onDrawn = (): void => {
    if (guide.now?.isOpen) guide.now.setFacts(factsOf(viewState.get(), store.get(), display.scene.labels));
  };
  const page = createPage({ root, layout, context, commands, offers, onDrawn });
  followState(context, () => guide.now?.onOpened(), redraw);
  listenToWindow(context);
  const startup = createStartup({ context, offers, onGuide: openGuide });
  const onNewVersion = (reload: () => void): void =>
    offers.newVersion.offer({
      message: 'A new version of this page is ready.',
      action: 'Reload',
      onAccept: () => void ioControllers.remembered.settle().then(reload),
    });
  registerServiceWorker({ onNewVersion, onRepaired: feedback.say }, startup.begin());
  void display.scene.viewer.firstSeen.then(redraw);
  applyLook(context);
  redraw();
}

async function loadGuide(
  { store, workspace }: Session,
  { files, remembered, link }: IoControllers,
  layout: Layout,
  openInitial: () => Promise<void>,
): Promise<Guide> {
  const { createGuide } = await import('./guide/guide.ts');
  return createGuide({
    store,
    workspace,
    files,
    openInitial,
    place: layout.setGuide,
    showPanel: layout.showPanel,
    frame: layout.setFramed,
    keep: () => remembered.flush(),
    pin: (fragment) => link.pin(fragment),
  });
}

function listenToWindow({ session: { store }, remembered, viewState }: Context): void {
  listenToPointer(store.hold);
  listenToLeaving(
    () => remembered.unsaved,
    () => remembered.flush(),
  );
  listenToNetwork((offline) => viewState.change({ offline }));
}
