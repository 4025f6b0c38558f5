/** The composition root: makes every part, gives it what it needs, and says who hears of what. */
import type { Warning } from '../engine/api/types.ts';
import { endTangents } from '../model/state.ts';
import type { Plot } from '../model/state.ts';
import { clampTime } from '../model/time-scale.ts';
import { registerServiceWorker } from '../offline/register.ts';
import { lazy } from '../ui/lazy.ts';
import { createOffer } from '../ui/messages.ts';
import type { PickedFile } from '../ui/dropped-files.ts';
import { createTheme } from '../ui/theme.ts';
import { analysisInput } from './analysis/analysis.ts';
import { createMotionPace } from './analysis/motion-pace.ts';
import { AnalysisCache } from './analysis/analysis-cache.ts';
import { createDisplay } from './display.ts';
import type { Display } from './display.ts';
import { originalOf } from './drawing/original.ts';
import { withPlaces } from './drawing/warning-places.ts';
import { createCommands } from './panels/commands.ts';
import type { Commands } from './panels/commands.ts';
import { factsOf } from './guide/facts.ts';
import type { GuideParts } from './guide/guide.ts';
import type { Facts } from './guide/guide-page.ts';
import { createFeedback } from './panels/feedback.ts';
import type { Feedback } from './panels/feedback.ts';
import { createLayout } from './panels/layout.ts';
import { createPage } from './panels/page.ts';
import { createViewState } from './panels/view-state.ts';
import type { Blend, ViewStateHolder } from './panels/view-state.ts';
import { listenToLeaving, listenToNetwork, listenToPointer, reducedMotion } from './panels/window-events.ts';
import { createSession } from './session/session.ts';
import type { Session, StartedEngine } from './session/session.ts';
import { changesBetween } from './session/state-changes.ts';
import { sourceTitle } from './sources/own-files.ts';
import { openFirst } from './sources/open-first.ts';
import { guideLink } from './sources/page-link.ts';
import type { Opener } from './sources/opener.ts';
import { TakeFiles } from './sources/take-files.ts';
import { createTestHook, installTestHook } from './test-hook.ts';
import type { TestHook } from './test-hook.ts';
import { createWays } from './ways.ts';
import type { Ways } from './ways.ts';

export function startApp(root: HTMLElement, engine: StartedEngine): void {
  const layout = createLayout();
  const newVersion = createOffer('new-version');
  const notReopened = createOffer('not-reopened');
  const importOffer = createOffer('import-offer');
  const poseOffer = createOffer('pose-offer');
  /** What is open comes before what is said of it. */
  const waits = (): boolean =>
    store.get().source.kind !== 'none' && !scene.viewer.hasSeen && !viewState.get().errorMessage;
  const redraw = (): void => {
    if (waits()) return;
    page.redraw();
    if (guide.now?.isOpen) guide.now.setFacts(facts());
  };
  const viewState = createViewState(redraw);
  const feedback = createFeedback(viewState);
  const session = createSession(engine, {
    onServed: () => onServed(),
    onRestart() {
      feedback.say('The browser stopped the computation. Restarting it; nothing was lost.');
      void frameLoop.request(store.get().time);
    },
    onWorking: feedback.onWorking,
    onRead: (info) => scene.expect(info),
    onLarge: () => display.firstKey.begin(),
    onKeys: (opening) => (opening ? void display.firstKey.show(opening) : display.firstKey.end()),
    onGivenUp: () => display.firstKey.end(),
    onError: feedback.onError,
  });
  const { store, workspace, sequence } = session;
  const seek = (t: number): void => commands.seek(t);
  const display = createDisplay({ session, layout, viewState, feedback, seek, onResize: redraw });
  const { scene, marking } = display;
  const { frameLoop } = display.playback;
  const commands = commandsOf(session, display, viewState, feedback.say, () => guide.now?.plot ?? null);
  const { analysis, onAnalysisError } = analysisOf(session, viewState, feedback);
  const motionPace = createMotionPace({
    sequence,
    towards: () => endTangents(store.get().doc),
    onPace: (pace, mostSpeeds) => viewState.change({ pace, mostSpeeds }),
  });
  const ways = createWays({
    session,
    display,
    analysis,
    viewState,
    feedback,
    onOffer: importOffer.offer,
    onGuide(fragment) {
      if (fragment === null) void guide.now?.close();
      else openGuide(fragment).catch(feedback.onError);
    },
  });
  const { files, remembered, undo, animation, exporting } = ways;
  /** What the address named before any page of the guide. */
  let begun = '';
  const address = (): string => {
    if (!guideLink(location.hash)) begun = location.hash;
    return location.hash;
  };
  const visit = (named: () => string): Promise<void> =>
    openFirst(
      {
        files,
        remembered,
        onSamples(samples) {
          viewState.change({ samples, offline: !navigator.onLine });
          ways.link.listen();
        },
        say: feedback.say,
        onGuide: (page) => openGuide(page),
        onStopped: notReopened.offer,
      },
      named,
    );
  const guideParts: GuideParts = {
    store,
    workspace,
    files,
    // What was on its way when the guide was turned to.
    openFirst: () => visit(() => begun),
    place: layout.setGuide,
    showPanel: layout.showPanel,
    frame: layout.setFramed,
    keep: () => remembered.flush(),
    pin: (fragment) => ways.link.pin(fragment),
  };
  const guide = lazy(async () => (await import('./guide/guide.ts')).createGuide(guideParts));
  const openGuide = async (fragment: string): Promise<boolean> => (await guide.get()).open(fragment);
  const facts = (): Facts | null => factsOf(viewState.get(), store.get(), scene.labels);
  const applyLook = (): void => {
    scene.setLook(store.get().view, theme.isDark());
    display.timePictures.forget();
  };
  const theme = createTheme(() => {
    applyLook();
    redraw();
  });
  const takeFiles = new TakeFiles({
    store,
    files,
    say: feedback.say,
    onOffer: poseOffer.offer,
    onPick: () => page.openFiles(),
  });
  const offers = [newVersion, notReopened, importOffer, poseOffer].map(({ element }) => element);
  const page = createPage({
    ...{
      root,
      layout,
      offers,
      importOffer: importOffer.element,
      session,
      viewState,
      feedback,
      scene,
      marking,
      commands,
      analysis,
      theme,
      files,
      takeFiles,
      undo,
    },
    waits,
    onAnalysisError,
    onBlend: showBlend,
    onPeek: display.timePictures.want,
    onLink: () => void ways.link.copy(),
    link: ways.link.address,
    onOwn: (id) => void ways.openOwn(id),
    onRemember: () => void remembered.toggle().catch(feedback.onError),
    onTake: (of, times) => void besideOriginal(() => files.resample(of, times)),
    onFewest: (of, percent) => besideOriginal(() => takeFewest(of, percent)),
    onAsked() {
      viewState.change({ opening: false });
      importOffer.offer(null);
    },
    onOriginal: (shown) => void showOriginal(shown),
    onTruth: (picked) => void compareWith(picked).catch(feedback.onError),
    truth: () => animation.now?.truth ?? null,
    onExportPlan: (request) => void exporting.get().then((loaded) => loaded.plan(request), feedback.onError),
    onExport: (request) => void exporting.get().then((loaded) => loaded.run(request), feedback.onError),
    snippet: async () => (await exporting.get()).snippet(),
    onCancel() {
      if (guide.now?.cancel()) return;
      exporting.now?.cancel();
      animation.now?.cancel();
      session.cancel();
    },
    onEscape: () => void guide.now?.close(),
  });

  /** A function declaration: parts that are made before it are given it. */
  function showBlend(blend: Blend | null): void {
    if (blend === viewState.get().blend) return;
    if (blend && store.get().play.playing) store.set({ play: { ...store.get().play, playing: false } });
    viewState.change({ blend });
    frameLoop.follow(store.get().time);
  }
  const takeFewest = async (of: number, percent: number): Promise<void> => {
    viewState.change({ fewest: null });
    const fewest = await (await animation.get()).takeFewest(of, percent);
    if (fewest) viewState.change({ fewest });
  };
  /** Other keys leave the animation where it is shown. */
  const besideOriginal = async (work: () => Promise<unknown>): Promise<void> => {
    const { original } = viewState.get();
    await work();
    if (original && !viewState.get().original) await showOriginal(true);
  };
  const showOriginal = async (shown: boolean): Promise<void> => {
    viewState.change({ original: shown });
    const reference = shown ? await (await animation.get()).reference() : null;
    const { info } = workspace;
    scene.setOriginal(reference && info && originalOf(reference, info.faces));
    viewState.change({ original: reference !== null });
    analysis.invalidate();
    await frameLoop.request(store.get().time);
  };

  /** An animation of other files, or again that of the keys. */
  const compareWith = async (picked: PickedFile[] | Promise<PickedFile[]> | null): Promise<void> => {
    if (!picked) {
      animation.now?.dropTruth();
      return showOriginal(false);
    }
    if (await (await animation.get()).takeTruth(picked)) await showOriginal(true);
  };

  function onServed(): void {
    const main = sequence();
    if (!main) return;
    viewState.change({ warnings: warningsOf(session) });
    marking.follow();
    main.shape.stats().then((stats) => viewState.change({ stats }), feedback.onError);
    frameLoop.follow(store.get().time);
    analysis.invalidate();
    motionPace.refresh();
    display.timePictures.forget();
    display.thumbnails.refresh();
  }

  const onEdit = (): void => viewState.change({ welcome: false });
  const onOpened = (): void => {
    takeFiles.forget();
    guide.now?.onOpened();
  };
  const onMoved = (): void => {
    if (viewState.get().blend) viewState.change({ blend: null });
  };
  followState({ session, display, ways, applyLook, onEdit, onMoved, onOpened, redraw });
  listenToPointer((down) => store.hold(down));
  listenToLeaving(
    () => remembered.unsaved,
    () => remembered.flush(),
  );
  listenToNetwork((offline) => viewState.change({ offline }));
  const ready = visit(address).then(() => frameLoop.idle());
  /** With all that is shown of it, as far as there is anything. */
  const shown = ready
    .then(() => (workspace.info ? scene.viewer.firstSeen : undefined))
    .then(() => workspace.idle())
    .then(() => frameLoop.idle())
    .then(() => scene.viewer.drawn());
  void scene.viewer.firstSeen.then(redraw);
  const title = (): string => sourceTitle(store.get().source, viewState.get().samples);
  shown
    .then(() => import('./sources/playground.ts'))
    .then((playground) =>
      playground.listenToPlayground({ store, workspace, sequence, title, onError: feedback.onError }),
    )
    .catch(feedback.onError);
  const withdrawOffers = (): void => [notReopened, importOffer, poseOffer].forEach(({ offer }) => offer(null));
  const resetParts = {
    session,
    ways,
    viewState,
    feedback,
    theme,
    withdrawOffers,
    refit: () => scene.viewer.refit(false),
    visit: (fragment: string) => visit(() => fragment),
  };
  const resetTo = (fragment: string): Promise<void> =>
    import('./reset.ts').then(({ reset }) => reset(resetParts, fragment));
  installTestHook(testHookOf(ready, session, display, files, onMoved, resetTo));
  registerServiceWorker(
    {
      onNewVersion(reload) {
        newVersion.offer({ message: 'A new version of this page is ready.', action: 'Reload', onAccept: reload });
      },
      onRepaired: feedback.say,
    },
    shown,
  );
  applyLook();
  redraw();
}

function commandsOf(
  { store, workspace, sequence, range }: Session,
  display: Display,
  viewState: ViewStateHolder,
  say: (text: string) => void,
  ownPlot: () => Plot | null,
): Commands {
  const { scene, playback } = display;
  return createCommands({
    store,
    range,
    pool: () => workspace.pool,
    initial: () => viewState.get().initial,
    keyPace: async () => (await sequence()?.keyPace()) ?? null,
    async exactShape(t) {
      await playback.frameLoop.request(t);
      return scene.viewer.positions(0);
    },
    fit: (view) => scene.fit(view, !reducedMotion()),
    ownPlot,
    onUse: () => viewState.change({ welcome: false }),
    say,
  });
}

interface RestartedAnalysis {
  analysis: AnalysisCache;
  /** The end of a worker has it computed again. */
  onAnalysisError(error: unknown): void;
}

function analysisOf(
  { store, workspace, restart, range }: Session,
  viewState: ViewStateHolder,
  { onError }: Feedback,
): RestartedAnalysis {
  const onAnalysisError = (error: unknown): void => {
    if (restart.takesUp(error)) analysis.invalidate();
    else onError(error);
  };
  const analysis = new AnalysisCache(
    () => analysisInput(workspace.sequences, store.get().doc, range(), viewState.get().ms ?? 1),
    onAnalysisError,
  );
  return { analysis, onAnalysisError };
}

interface Followers {
  session: Session;
  display: Display;
  ways: Ways;
  applyLook(): void;
  /** What is open has been edited. */
  onEdit(): void;
  /** The motion or its time is another one, or it plays. */
  onMoved(): void;
  /** Something else is open. */
  onOpened(): void;
  redraw(): void;
}

/** With the place of each, in the pose of its key. */
function warningsOf({ store, workspace: { warnings, info, pool } }: Session): Warning[] {
  if (!info || !pool) return warnings;
  return withPlaces(warnings, info.faces, (key) => {
    const pose = store.get().doc.keys[key]?.pose;
    return pose === undefined ? null : pool.keys.positions(pose);
  });
}

/** At once, but on a visit that has seen no shape yet: other motions than the first one do not hold it up. */
function serveAfterFirst({ serve, store }: Session, { scene: { viewer }, playback }: Display): void {
  if (viewer.hasSeen) return serve();
  void viewer.firstSeen.then(serve);
  playback.frameLoop.follow(store.get().time);
}

/** The one subscriber of the state: what changed decides who hears of it. */
function followState({ session, display, ways, applyLook, onEdit, onMoved, onOpened, redraw }: Followers): void {
  const { store } = session;
  let before = store.get();
  store.subscribe((state) => {
    const changed = changesBetween(before, state);
    before = state;
    if (changed.time || changed.started || changed.motions || changed.opened) onMoved();
    if (changed.motions) serveAfterFirst(session, display);
    if (changed.look) applyLook();
    display.playback.follow(state, changed);
    if (changed.opened) onOpened();
    else if (changed.motions) onEdit();
    // Own files take the address of what was open before, whether they play or not.
    if (!state.play.playing || changed.opened) ways.link.follow();
    if (!state.play.playing || changed.opened || changed.motions) ways.remembered.follow();
    redraw();
  });
}

function testHookOf(
  ready: Promise<void>,
  { store, workspace, sequence, range }: Session,
  { scene, playback: { frameLoop } }: Display,
  files: Opener,
  showMotion: () => void,
  resetTo: (fragment: string) => Promise<void>,
): TestHook {
  return createTestHook({
    ready,
    sequence,
    viewer: scene.viewer,
    state: () => store.get(),
    shown: () => frameLoop.shown,
    difference: () => scene.difference?.percent ?? null,
    async seekExactly(t) {
      const time = clampTime(t, range());
      showMotion();
      store.set({ time, play: { ...store.get().play, playing: false } });
      await frameLoop.request(time);
    },
    async idle() {
      await files.idle();
      if (workspace.info) await scene.viewer.firstSeen;
      await workspace.idle();
      await frameLoop.idle();
    },
    reset: resetTo,
    busy: () => files.busy || (frameLoop.busy && !store.get().play.playing),
  });
}
