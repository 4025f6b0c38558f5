/** The composition root: creates all parts, passes their dependencies and connects them. */
import { endTangents } from '../model/state.ts';
import { registerServiceWorker } from '../offline/register.ts';
import { lazy } from '../ui/lazy.ts';
import type { Lazy } from '../ui/lazy.ts';
import { createTheme } from '../ui/theme.ts';
import { bindActions } from './actions/action.ts';
import { noOverlays } from './actions/context.ts';
import type { Context, IoControllers } from './actions/context.ts';
import { seek } from './actions/time.ts';
import { ACTIONS } from './actions/table.ts';
import { createAnalysisCache } from './analysis/analysis-cache.ts';
import { createMotionSpeed } from './analysis/motion-speed.ts';
import { createDisplay } from './drawing/display.ts';
import { applyLook, followState } from './follow-state.ts';
import { factsOf } from './guide/facts.ts';
import type { Guide } from './guide/guide.ts';
import { createLayout } from './panels/layout.ts';
import type { Layout } from './panels/layout.ts';
import { createPage } from './panels/page.ts';
import { createSession } from './session/session.ts';
import type { Session, StartedEngine } from './session/session.ts';
import { FileIntake } from './sources/file-intake.ts';
import { createFeedback } from './view/feedback.ts';
import type { Feedback } from './view/feedback.ts';
import { createOffers } from './view/offers.ts';
import { createSignal } from './view/signal.ts';
import { createViewState } from './view/view-state.ts';
import { listenToLeaving, listenToNetwork, listenToPointer } from './view/window-events.ts';
import { begin, createStartup } from './startup.ts';
import type { GuideLinks, Startup } from './startup.ts';
import { createIoControllers } from './io-controllers.ts';

export function startApp(root: HTMLElement, engine: StartedEngine): void {
  const layout = createLayout();
  const offers = createOffers();
  const overlays = noOverlays();
  const changed = createSignal();
  const themeChanged = createSignal();
  const viewState = createViewState(changed.send);
  const feedback = createFeedback(viewState);
  const session = createSession(engine);
  const { store } = session;
  const display = createDisplay({
    session,
    area: layout,
    viewState,
    feedback,
    seek: (t) => seek({ session, viewState }, t),
    onResize: changed.send,
  });
  const analysis = createAnalysisCache(session, () => viewState.opened.ms ?? 1, feedback.onError);
  const onOffer = offers.imported.offer;
  const ioControllers = createIoControllers({ session, display, analysis, viewState, feedback, onOffer });
  const startup = createStartup({ ...ioControllers, viewState, feedback, offers });
  const guide = lazy(() => loadGuide(session, ioControllers, layout, startup));
  const context: Context = {
    ...ioControllers,
    session,
    display,
    viewState,
    feedback,
    analysis,
    guide,
    overlays,
    theme: createTheme(themeChanged.send),
    motionSpeed: createMotionSpeed({
      sequence: session.sequence,
      towards: () => endTangents(store.get().doc),
      onSpeed: (speedCurve, maxSpeeds) => viewState.changeOpened({ speedCurve, maxSpeeds }),
    }),
    fileIntake: new FileIntake({
      store,
      files: ioControllers.files,
      say: feedback.say,
      onOffer: offers.pose.offer,
      onPick: () => overlays.pickFiles(),
    }),
    offerImport: onOffer,
  };
  const commands = bindActions(ACTIONS, context);
  const onDrawn = (): void => {
    if (guide.now?.isOpen) guide.now.setFacts(factsOf(viewState.opened, store.get(), display.scene.labels));
  };
  const redraw = createPage({ root, layout, context, commands, offers, onDrawn });
  const look = (): void => {
    applyLook(context);
    redraw();
  };
  changed.listen(redraw);
  themeChanged.listen(look);
  followState(context, () => guide.now?.onOpened(), redraw);
  listenToWindow(context);
  const onNewVersion = (reload: () => void): void =>
    offers.newVersion.offer({
      message: 'A new version of this page is ready.',
      action: 'Reload',
      onAccept: () => void ioControllers.remembered.settle().then(reload),
    });
  registerServiceWorker(
    { onNewVersion, onRepaired: feedback.say },
    begin(context, startup, offers, guideLinks(guide, feedback)),
  );
  void display.scene.viewer.firstSeen.then(redraw);
  look();
}

function guideLinks(guide: Lazy<Guide>, { onError }: Feedback): GuideLinks {
  const open = async (fragment: string): Promise<boolean> => (await guide.get()).open(fragment);
  return {
    open,
    follow(fragment) {
      if (fragment === null) void guide.now?.close();
      else open(fragment).catch(onError);
    },
  };
}

async function loadGuide(
  { store, workspace }: Session,
  { files, remembered, link }: IoControllers,
  layout: Layout,
  startup: Startup,
): Promise<Guide> {
  const { createGuide } = await import('./guide/guide.ts');
  return createGuide({
    store,
    workspace,
    files,
    openInitial: startup.openBegun,
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
