/** The composition root: makes every part, gives it what it needs, and says who hears of what. */
import { createEngine } from '../engine/index.ts';
import type { Sequence } from '../engine/api/api.ts';
import type { Progress } from '../engine/api/types.ts';
import { EMPTY_STATE } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { clampTime } from '../model/time-scale.ts';
import { registerServiceWorker } from '../offline/register.ts';
import { createOffer, createToast } from '../ui/messages.ts';
import { plural } from '../ui/status-line.ts';
import { createTheme } from '../ui/theme.ts';
import { analysisInput } from './analysis/analysis.ts';
import { AnalysisCache } from './analysis/analysis-cache.ts';
import { createMarking } from './drawing/marking.ts';
import { SceneController } from './drawing/scene-controller.ts';
import { createThumbnails } from './drawing/thumbnails.ts';
import { createExportController } from './export/export-controller.ts';
import { createCommands } from './panels/commands.ts';
import { errorMessageOf } from './panels/error-message.ts';
import { createLayout } from './panels/layout.ts';
import { createPage } from './panels/page.ts';
import { createViewState, openedView, shownView } from './panels/view-state.ts';
import { listenToNetwork, listenToPointer, reducedMotion } from './panels/window-events.ts';
import type { FrameSet } from './playback/frame-set.ts';
import { createPlayback } from './playback/playback.ts';
import { readMoving } from './playback/preview-policy.ts';
import { motionRange } from './session/motion-range.ts';
import { isCancelled } from './session/sequence-set.ts';
import { sequencePlan } from './session/sequence-plan.ts';
import { ServedDocument } from './session/served-document.ts';
import { changesBetween } from './session/state-changes.ts';
import { createStore } from './session/store.ts';
import { WorkerRestart } from './session/worker-restart.ts';
import { Workspace } from './session/workspace.ts';
import { createOpenFiles } from './sources/open-files.ts';
import type { OpenedFiles } from './sources/open-files.ts';
import { openFirst } from './sources/open-first.ts';
import { createPageLink } from './sources/page-link.ts';
import { createRememberedFiles } from './sources/remembered-files.ts';
import type { Sample } from './sources/samples.ts';
import { createTestHook, installTestHook } from './test-hook.ts';

export function startApp(root: HTMLElement): void {
  const store = createStore(EMPTY_STATE);
  const layout = createLayout();
  const toast = createToast();
  const newVersion = createOffer('new-version');
  const notReopened = createOffer('not-reopened');
  const viewState = createViewState(() => page.redraw());
  const sequence = (): Sequence | undefined => workspace.sequences[0]?.sequence;
  const range = (): Range => motionRange(store.get().doc, workspace.range);
  const { say } = toast;
  const onError = (error: unknown): void => {
    if (!isCancelled(error)) viewState.change({ errorMessage: errorMessageOf(error) });
  };
  const onStart = (): void => viewState.change({ errorMessage: null });
  const onWorking = (working: Progress | null): void => viewState.change({ working });

  // Session: what is open.
  const restart = new WorkerRestart(() => {
    say('The browser stopped the computation. Restarting it; nothing was lost.');
    void frameLoop.request(store.get().time);
  });
  const engine = createEngine({ onLost: () => void restart.tryAgain() });
  const served = new ServedDocument(store);
  const workspace = new Workspace(engine, {
    onProgress: onWorking,
    onReady: () => onServed(),
    onRefused: (error) => {
      onError(error);
      served.goBack();
    },
  });

  // Drawing and playback: what is on the screen, and when.
  const scene = new SceneController(layout.viewport, {
    onCamera: (camera) => store.set({ view: { ...store.get().view, camera } }),
    onResize: () => page.redraw(),
    covered: (views) => layout.covered(views),
    onContextLost: () => say('The browser lost the graphics card. The picture comes back by itself.'),
    onContextRestored: () => void frameLoop.request(store.get().time),
  });
  const { frameLoop, follow: play } = createPlayback({
    store,
    range,
    moving: readMoving(location.search),
    sequences: () => workspace.sequences,
    screen: {
      show: (frames, eased) => show(frames, eased),
      drawn: () => scene.viewer.drawn(),
      onError: (error) => {
        if (!restart.takesUp(error)) onError(error);
      },
    },
  });
  const thumbnails = createThumbnails({
    store,
    workspace,
    scene,
    idle: () => frameLoop.idle(),
    has: (pose) => viewState.get().thumbnails.has(pose),
    onThumbnail: (pose, url) => viewState.change({ thumbnails: new Map(viewState.get().thumbnails).set(pose, url) }),
  });
  const commands = createCommands({
    store,
    range,
    pool: () => workspace.pool,
    initial: () => viewState.get().initial,
    async exactShape(t) {
      await frameLoop.request(t);
      return scene.viewer.positions(0);
    },
    fit: (view) => scene.fit(view, !reducedMotion()),
    onUse: () => viewState.change({ welcome: false }),
  });
  const marking = createMarking({
    scene,
    sequence,
    range,
    onError,
    seek: commands.seek,
    warnings: () => viewState.get().warnings,
    keyTimes: () => store.get().doc.keys.map(({ time }) => time),
    onWarning: (shownWarning) => viewState.change({ shownWarning }),
  });

  // Ways in and out.
  const files = createOpenFiles({
    engine,
    store,
    workspace,
    reducedMotion,
    say,
    onStart,
    onError,
    samples: () => viewState.get().samples,
    onOpened: (opened) => onOpened(opened),
    onWorking,
  });
  const remembered = createRememberedFiles({
    store,
    workspace,
    say,
    onError,
    onChange: (kept) => viewState.change({ remembered: kept }),
  });
  const link = createPageLink({
    store,
    say,
    initial: () => viewState.get().initial,
    onLink: (to) => void files.sample(to.sample, to),
  });
  const analysis = new AnalysisCache(
    () => analysisInput(workspace.sequences, store.get().doc, range(), viewState.get().ms ?? 1),
    onAnalysisError,
  );
  const exporting = createExportController({
    store,
    scene,
    analysis,
    sequence,
    range,
    say,
    onStart,
    onError,
    onWorking,
    drawExactly: (t) => frameLoop.request(t),
    idle: () => frameLoop.idle(),
    onVideoFormats: (videoFormats) => viewState.change({ videoFormats }),
    onPlan: (planned) => viewState.change({ exporting: planned }),
  });

  const theme = createTheme(() => {
    applyLook();
    page.redraw();
  });
  const page = createPage({
    root,
    layout,
    toast: toast.element,
    offers: [newVersion.element, notReopened.element],
    engine,
    store,
    viewState,
    workspace,
    scene,
    analysis,
    commands,
    marking,
    files,
    theme,
    range,
    onError,
    onAnalysisError,
    onLink: () => void link.copy(),
    onRemember: () => void remembered.toggle().catch(onError),
    onExportPlan: exporting.plan,
    onExport: (request) => void exporting.run(request),
    onCancel() {
      exporting.cancel();
      workspace.cancel();
      served.goBack();
    },
  });

  function applyLook(): void {
    scene.setLook(store.get().view, theme.isDark());
  }

  async function show(frames: FrameSet, eased: boolean): Promise<void> {
    await scene.show(frames, store.get(), range(), eased && !reducedMotion());
    viewState.change(shownView(frames.frames[0], frames.preview));
  }

  function onOpened(opened: OpenedFiles): void {
    const { info, pool, source, doc, camera } = opened;
    scene.setImport(info, pool, camera);
    viewState.change(openedView(opened, viewState.get()));
    if (source.kind !== 'files') return;
    say(`${plural(doc.keys.length, 'key', 'keys')}, ${plural(info.report.vertices, 'vertex', 'vertices')}.`);
  }

  /** The sequences follow the document now. */
  function onServed(): void {
    served.note(store.get());
    const main = sequence();
    if (!main) return;
    viewState.change({ warnings: workspace.warnings });
    marking.follow();
    main.stats().then((stats) => viewState.change({ stats }), onError);
    frameLoop.follow(store.get().time);
    analysis.invalidate();
    thumbnails.refresh();
  }

  function onAnalysisError(error: unknown): void {
    if (restart.takesUp(error)) analysis.invalidate();
    else onError(error);
  }

  let before = store.get();
  store.subscribe((state) => {
    const changed = changesBetween(before, state);
    before = state;
    if (changed.motions) workspace.want(sequencePlan(state.doc, state.view.compare, state.view.ghostDifference));
    if (changed.look) applyLook();
    play(state, changed);
    if (changed.motions && !changed.opened) viewState.change({ welcome: false });
    if (!state.play.playing) {
      link.follow();
      remembered.follow();
    }
    page.redraw();
  });

  listenToPointer((down) => {
    store.hold(down);
    if (!down) frameLoop.settle();
  });
  listenToNetwork((offline) => viewState.change({ offline }));

  const onSamples = (samples: readonly Sample[]): void => viewState.change({ samples, offline: !navigator.onLine });
  const ready = openFirst({ files, remembered, onSamples, onStopped: notReopened.offer }).then(() => frameLoop.idle());
  ready.catch(onError);
  installTestHook(
    createTestHook({
      ready,
      sequence,
      viewer: scene.viewer,
      state: () => store.get(),
      shown: () => frameLoop.shown,
      difference: () => scene.difference?.percent ?? null,
      async seekExactly(t) {
        const time = clampTime(t, range());
        store.set({ time, play: { ...store.get().play, playing: false } });
        await frameLoop.request(time);
      },
      async idle() {
        await files.idle();
        await workspace.idle();
        await frameLoop.idle();
      },
      busy: () => files.busy || (frameLoop.busy && !store.get().play.playing),
    }),
  );
  registerServiceWorker((reload) => {
    newVersion.offer({ message: 'A new version of this page is ready.', action: 'Reload', onAccept: reload });
  });
  applyLook();
  page.redraw();
}
