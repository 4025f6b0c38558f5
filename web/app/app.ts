/** The composition root: puts state, engine, viewer and components together and says who hears of what. */
import { createEngine } from '../engine/index.ts';
import type { Warning } from '../engine/api/types.ts';
import type { AppState, Doc, View } from '../model/state.ts';
import { EMPTY_STATE, tangentKeys } from '../model/state.ts';
import type { Range } from '../model/time-scale.ts';
import { clampTime } from '../model/time-scale.ts';
import { createTheme } from '../ui/theme.ts';
import { createCommands } from './panels/commands.ts';
import type { Context } from './context.ts';
import { createExportController } from './export/export-controller.ts';
import { createGhostStudy } from './panels/ghost-study-panel.ts';
import { installTestHook } from './test-hook.ts';
import { createAnalysisPanel } from './panels/analysis-panel.ts';
import type { AnalysisInput } from './panels/analysis-panel.ts';
import { createComponents } from './panels/components.ts';
import { createShortcuts, listenToArrows, listenToCamera } from './panels/keyboard.ts';
import { isCancelled } from './session/sequence-set.ts';
import { createMarking } from './drawing/marking.ts';
import { createRememberedFiles } from './sources/remembered-files.ts';
import { createOpenFiles } from './sources/open-files.ts';
import { readPermalink, writePermalink } from './sources/permalink.ts';
import { Picture } from './drawing/scene-controller.ts';
import { Player } from './playback/player.ts';
import { errorMessageOf } from './panels/error-message.ts';
import { PreviewPolicy, readMoving } from './playback/preview-policy.ts';
import { FrameLoop } from './playback/frame-loop.ts';
import { EMPTY_VIEW_STATE } from './panels/view-state.ts';
import type { ViewState } from './panels/view-state.ts';
import { fetchSamples } from './sources/samples.ts';
import { createLayout } from './panels/layout.ts';
import { listen, shortcutLines } from './panels/shortcuts.ts';
import { specOf } from './session/sequence-plan.ts';
import { createStore } from './session/store.ts';
import { createThumbnails } from './drawing/thumbnails.ts';
import { Workspace } from './session/workspace.ts';

const LINK_DELAY_MS = 300;
const SAME_DEATH_MS = 1000;
const NEXT_DEATH_MS = 10_000;

export function startApp(root: HTMLElement): void {
  const engine = createEngine({ onLost: () => void restart() });
  const store = createStore(EMPTY_STATE);
  const theme = createTheme(() => { applyLook(); render(); });
  const layout = createLayout();
  let viewState: ViewState = { ...EMPTY_VIEW_STATE, welcome: true };
  let good: { doc: Doc; view: Pick<View, 'compare' | 'ghostDifference'> } | null = null;
  let drawnState = store.get();
  let restartedAt = -Infinity;

  const picture = new Picture(layout.picture, {
    onCamera: (camera) => store.set({ view: { ...store.get().view, camera } }),
    onResize: () => render(),
    covered: (views) => layout.covered(views),
    onContextLost: () => context.say('The graphics card was taken away. The picture comes back by itself.'),
    onContextRestored: () => void frameLoop.request(store.get().time),
  });

  const workspace = new Workspace(engine, {
    onProgress: (working) => context.inform({ working }),
    onReady: () => served(),
    onRefused: (error) => {
      context.fail(error);
      goBack();
    },
  });

  const frameLoop = new FrameLoop({
    sequences: () => workspace.sequences,
    async show(shapes, eased) {
      await picture.show(shapes, store.get(), context.range(), eased && !context.reducedMotion());
      const { about, frames: [first] } = shapes;
      if (about) context.inform({ aboutMs: first?.ms ?? null });
      else context.inform({ ms: first?.ms ?? null, threads: first?.threads ?? null, aboutMs: null, lost: first?.lostDefiniteness ?? 0, lostFace: first?.lostFace ?? -1 });
    },
    drawn: () => picture.viewer.drawn(),
    onError: (error) => { if (!restarts(error)) context.fail(error); },
  }, new PreviewPolicy(readMoving(location.search)));

  const player = new Player(
    () => ({ time: store.get().time, play: store.get().play, range: context.range(), periodic: store.get().doc.motion.boundary === 'periodic' }),
    (time, playing) => store.set({ time, play: { ...store.get().play, playing } }),
    () => frameLoop.advance(),
  );

  const context: Context = {
    engine, store, workspace, picture, frameLoop,
    viewState: () => viewState,
    inform(change) {
      viewState = { ...viewState, ...change };
      render();
    },
    range: () => rangeOf(store.get(), viewState),
    reducedMotion: () => window.matchMedia('(prefers-reduced-motion: reduce)').matches,
    say: (text) => ui.say(text),
    fail(error) {
      if (!isCancelled(error)) context.inform({ problem: errorMessageOf(error) });
    },
  };

  const thumbnails = createThumbnails(context);
  const commands = createCommands(context);
  const marking = createMarking(context, commands.seek);
  const opening = createOpenFiles(context);
  const memory = createRememberedFiles(context);
  const analysis = createAnalysisPanel(insightInput, {
    onSeek: commands.seek, onSpeed: commands.endSpeed,
    onError: (error) => { if (restarts(error)) analysis.invalidate(); else context.fail(error); },
  });
  const exporting = createExportController(context, analysis);
  const ghostStudy = createGhostStudy(context);
  const cancel = (): void => {
    exporting.cancel();
    workspace.cancel();
    goBack();
  };
  const shortcuts = createShortcuts(context, commands, {
    openFiles: () => ui.openFiles(), openExport: () => { if (viewState.info) ui.openExport(); }, openHelp: () => ui.openHelp(),
    toggleLook: () => ui.toggleLook(), toggleClock: () => ui.toggleClock(), nextTheme: theme.next, undo: store.undo, redo: store.redo,
    escape: () => (viewState.working ? cancel() : context.inform({ problem: null })),
  });
  const ui = createComponents({
    layout, root, commands, opening, analysis, ghostStudy, marking, lostFace: () => viewState.lostFace, shortcuts: shortcutLines(shortcuts),
    onUndo: store.undo, onRedo: store.redo, onTheme: theme.next, onCancel: cancel,
    onLink: () => void copyLink(),
    onRemember: () => void memory.toggle().catch(context.fail),
    onCloseProblem: () => context.inform({ problem: null }),
    onSingleKeys: (singleKeys) => context.inform({ singleKeys }),
    onExportOpen: () => exporting.plan(),
    onExportChange: (request) => exporting.plan(request),
    onExport: (request) => void exporting.run(request),
  });
  window.addEventListener('pointerdown', () => store.hold(true), { capture: true });
  for (const end of ['pointerup', 'pointercancel'] as const) {
    window.addEventListener(end, () => {
      store.hold(false);
      frameLoop.settle();
    }, { capture: true });
  }
  listen(shortcuts, () => viewState.singleKeys);
  listenToArrows(context, commands, layout.picture);
  listenToCamera(context, layout.picture);

  // Everything below reacts to changes.

  let frame = 0;
  function render(): void {
    if (frame === 0) frame = requestAnimationFrame(draw);
  }

  function draw(): void {
    frame = 0;
    ui.update({
      state: store.get(), viewState, range: context.range(), theme: theme.theme(), labels: picture.labels, colourBar: picture.colourBar,
      undo: store.undoLabel(), redo: store.redoLabel(),
    });
  }

  function applyLook(): void {
    picture.setLook(store.get().view, theme.isDark());
  }

  /** The sequences now follow the document. */
  function served(): void {
    const { doc, view } = store.get();
    good = { doc, view: { compare: view.compare, ghostDifference: view.ghostDifference } };
    const main = workspace.sequences[0]?.sequence;
    if (!main) return;
    context.inform({ range: main.range, warnings: distinct([...(viewState.info?.warnings ?? []), ...main.warnings]) });
    marking.follow();
    main.stats().then((stats) => context.inform({ stats }), context.fail);
    frameLoop.follow(store.get().time);
    analysis.invalidate();
    thumbnails.refresh();
  }

  function insightInput(): AnalysisInput {
    const [main] = workspace.sequences;
    const { doc } = store.get();
    return {
      sequences: workspace.sequences.filter((running) => running === main || running.ghost === main?.ghost),
      keyTimes: doc.keys.map((key) => key.time), range: context.range(), ms: viewState.ms ?? 1, towards: tangentKeys(doc),
    };
  }

  /** A worker has died: the engine starts another for the next shape that is asked for. Returns whether that is worth a try. */
  function restart(): boolean {
    const since = performance.now() - restartedAt;
    // One death is told by everyone who waited for an answer; another soon after it is a matter of the shape.
    if (since < SAME_DEATH_MS) return true;
    if (since < NEXT_DEATH_MS) return false;
    restartedAt = performance.now();
    context.say('The browser has ended the computation. It is started again; nothing is lost.');
    void frameLoop.request(store.get().time);
    return true;
  }

  function restarts(error: unknown): boolean {
    return error instanceof Error && 'code' in error && error.code === 'crashed' && restart();
  }

  /** After a refused or cancelled edit the document is again what the sequences serve. */
  function goBack(): void {
    if (!good) return;
    if (showsOtherMotions(store.get().view, good.view)) store.set({ view: { ...store.get().view, ...good.view } });
    if (store.get().doc !== good.doc) store.revert(good.doc);
  }

  store.subscribe((state) => {
    const before = drawnState;
    drawnState = state;
    const otherMotions = state.doc !== before.doc || showsOtherMotions(state.view, before.view);
    if (otherMotions) workspace.want(specOf(state.doc, state.view.compare, state.view.ghostDifference));
    if (lookOf(state) !== lookOf(before)) applyLook();
    if (drawsOtherwise(state, before)) void frameLoop.request(state.time);
    else if (state.time !== before.time && !state.play.playing) frameLoop.follow(state.time);
    if (state.play.playing && !before.play.playing) {
      frameLoop.play(player);
      player.start();
    }
    if (!state.play.playing && before.play.playing) {
      player.stop();
      frameLoop.pause();
      frameLoop.follow(state.time);
    }
    if (state.source === before.source && otherMotions) context.inform({ welcome: false });
    if (!state.play.playing) {
      saveLink();
      memory.follow();
    }
    render();
  });

  let linkTimer = 0;
  function saveLink(): void {
    window.clearTimeout(linkTimer);
    linkTimer = window.setTimeout(() => {
      const { initial } = viewState;
      const link = initial && writePermalink(store.get(), initial);
      history.replaceState(null, '', link ? `#${link}` : location.pathname + location.search);
    }, LINK_DELAY_MS);
  }

  async function copyLink(): Promise<void> {
    const link = viewState.initial && writePermalink(store.get(), viewState.initial);
    if (!link) return;
    const url = new URL(`#${link}`, location.href).href;
    try {
      await navigator.clipboard.writeText(url);
      context.say('Link copied.');
    } catch {
      history.replaceState(null, '', url);
      context.say('The link is in the address bar now.');
    }
  }

  window.addEventListener('hashchange', () => {
    const link = readPermalink(location.hash);
    if (link) void opening.sample(link.sample, link);
  });
  window.addEventListener('offline', () => context.inform({ offline: true }));
  window.addEventListener('online', () => context.inform({ offline: false }));

  const ready = start();
  ready.catch(context.fail);
  installTestHook({
    ready,
    async setTime(t) {
      const time = clampTime(t, context.range());
      store.set({ time, play: { ...store.get().play, playing: false } });
      await frameLoop.request(time);
    },
    settled: () => settled(),
    get state() { return structuredClone(store.get()); },
    stats: async () => (await workspace.sequences[0]?.sequence.stats()) ?? null,
    async evaluate(t) {
      const [frame] = (await workspace.sequences[0]?.sequence.evaluateMany([t])) ?? [];
      const positions = frame?.positions.slice() ?? new Float32Array();
      frame?.release();
      return positions;
    },
    async ghost() {
      const sequence = workspace.sequences[0]?.sequence;
      const mesh = (await sequence?.ghost()) ?? null;
      return mesh && { ...mesh, positions: await sequence!.ghostPositions(store.get().time) };
    },
    get shown() { return { time: frameLoop.shown.t, about: frameLoop.shown.about }; },
    difference: () => picture.difference?.percent.slice() ?? null,
    positions: (view = 0) => picture.viewer.positions(view),
    project: (points, view = 0) => picture.viewer.project(Float32Array.from(points), view),
  });
  applyLook();
  render();

  async function start(): Promise<void> {
    const link = readPermalink(location.hash);
    const [samples, left] = await Promise.all([fetchSamples(), link ? null : memory.recall()]);
    context.inform({ samples, offline: !navigator.onLine });
    if (left && await opening.again(left)) return frameLoop.idle();
    const first = viewState.samples.find(({ id }) => id === link?.sample) ?? viewState.samples[0];
    if (!first) throw new Error('There are no samples beside this page. Open files of your own.');
    await opening.sample(first.id, first.id === link?.sample ? link : null);
    await frameLoop.idle();
  }

  async function settled(): Promise<void> {
    do {
      await opening.idle();
      await workspace.idle();
      await frameLoop.idle();
      await picture.viewer.drawn();
      // What the last frame changed is shown by the components on the next one.
      await new Promise((resolve) => requestAnimationFrame(resolve));
    } while (opening.busy || (frameLoop.busy && !store.get().play.playing));
  }
}

/** Where the keys define the motion. Only the engine knows the period of a closed motion that does not close by itself. */
function rangeOf({ doc }: AppState, viewState: ViewState): Range {
  const first = doc.keys[0]?.time ?? 0;
  const last = doc.keys.at(-1)?.time ?? 1;
  if (doc.motion.boundary !== 'periodic') return [first, last];
  return doc.motion.period !== null ? [first, first + doc.motion.period] : viewState.range;
}

/** Changes that the viewer draws without asking for another shape. */
function lookOf({ view }: AppState): string {
  return `${view.colouring} ${view.shading} ${view.wireframe} ${view.floor}`;
}

function drawsOtherwise({ view }: AppState, before: AppState): boolean {
  return (['onion', 'film', 'colouring', 'ghostWire', 'ghostBeside'] as const).some((name) => view[name] !== before.view[name]);
}

/** Changes of the view that need other sequences. */
function showsOtherMotions(view: Pick<View, 'compare' | 'ghostDifference'>, before: Pick<View, 'compare' | 'ghostDifference'>): boolean {
  return view.compare !== before.compare || view.ghostDifference !== before.ghostDifference;
}

/** The import and the sequence may say the same; the same of two places is said twice. */
function distinct(warnings: readonly Warning[]): Warning[] {
  const words = warnings.map((warning) => JSON.stringify(warning));
  return warnings.filter((_, index) => words.indexOf(words[index]!) === index);
}
