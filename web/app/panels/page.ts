/** The page: its components with their commands, the keyboard, and one redrawing per animation frame. */
import type { ExportRequest } from '../../model/export-request.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { ThemeSwitch } from '../../ui/theme.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { Marking } from '../drawing/marking.ts';
import type { SceneController } from '../drawing/scene-controller.ts';
import type { Session } from '../session/session.ts';
import type { Opener } from '../sources/opener.ts';
import type { TakeFiles } from '../sources/take-files.ts';
import type { Undo } from '../sources/undo.ts';
import { createAnalysisPlace } from './analysis-place.ts';
import type { Commands } from './commands.ts';
import { createComponents } from './components.ts';
import type { Feedback } from './feedback.ts';
import { listenToCamera } from '../../viewer/camera-keys.ts';
import { createShortcuts, listenToArrows } from './keyboard.ts';
import { setAttribute } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { Layout } from './layout.ts';
import { createPinsInView } from './pins-in-view.ts';
import { createPresentation } from './presentation.ts';
import { listen, shortcutLines } from './shortcuts.ts';
import { listenToClicks } from './window-events.ts';
import type { Plot } from '../../model/state.ts';
import type { Blend, ViewStateHolder } from './view-state.ts';

export interface PageParts {
  root: HTMLElement;
  layout: Layout;
  offers: readonly HTMLElement[];
  /** The one of them that is about files just opened. */
  importOffer: HTMLElement;
  session: Session;
  viewState: ViewStateHolder;
  feedback: Feedback;
  scene: SceneController;
  analysis: AnalysisCache;
  commands: Commands;
  marking: Marking;
  files: Opener;
  takeFiles: TakeFiles;
  undo: Undo;
  theme: ThemeSwitch;
  /** Nothing is shown anew now; asked for again afterwards. */
  waits(): boolean;
  onPeek(t: number | null): void;
  onLink(): void;
  /** The link to what is on the screen; null where there is none. */
  link(): string | null;
  /** Opens files of the user by their project. */
  onOwn(project: string): void;
  onRemember(): void;
  /** Ends the work under way. */
  onCancel(): void;
  /** Escape was pressed, and neither work nor a message is there to end. */
  onEscape(): void;
  onTake(animation: number, times: number[]): void;
  onFewest(animation: number, percent: number): Promise<void>;
  /** The sheet on opening an animation has been seen. */
  onAsked(): void;
  onOriginal(shown: boolean): void;
  /** Files hold an animation to compare with; null: no more. */
  onTruth(picked: PickedFile[] | Promise<PickedFile[]> | null): void;
  /** What it is called; null: there is none. */
  truth(): string | null;
  onExportPlan(request: ExportRequest): void;
  onExport(request: ExportRequest): void;
  snippet(): Promise<string>;
  /** Shows a shape off the curve; null: the motion again. */
  onBlend(blend: Blend | null): void;
  /** The analysis failed. */
  onAnalysisError(error: unknown): void;
}

export interface Page {
  /** Something that the components show has changed. */
  redraw(): void;
  /** Has the user choose files. */
  openFiles(): void;
}

export function createPage(parts: PageParts): Page {
  const { layout, session, viewState, feedback, scene, commands, theme, undo, onCancel } = parts;
  const { engine, store, workspace, range } = session;
  // What is chosen counts at once: its plan may come after the next choice.
  const planExport = (chosen: ExportRequest): void => {
    const request = { ...chosen };
    viewState.change({ exporting: { request, plan: null } });
    parts.onExportPlan(request);
  };
  const { onError } = feedback;
  const closeError = (): void => viewState.change({ errorMessage: null });
  const stepBack = (): void => {
    const { working, blend, errorMessage } = viewState.get();
    if (viewState.get().placing) viewState.change({ placing: false });
    else if (working) onCancel();
    else if (blend) parts.onBlend(null);
    else if (errorMessage) closeError();
    else if (viewState.get().opening) parts.onAsked();
    else if (store.get().view.present) commands.present(null);
    else parts.onEscape();
  };
  const presentation = createPresentation({
    presented: () => store.get().view.present,
    present: commands.present,
    show: layout.present,
    say: feedback.say,
  });
  const shortcuts = createShortcuts(store, commands, {
    openFiles: () => components.openFiles(),
    openExport: () => {
      if (viewState.get().info) components.openExport();
    },
    openHelp: () => components.openHelp(),
    toggleLook: () => components.toggleLook(),
    toggleClock: () => components.toggleClock(),
    nextTheme: theme.next,
    undo: undo.undo,
    redo: undo.redo,
    openLink: () => components.openLink(),
    escape: stepBack,
    // What it is seen by lies under the sheet.
    onEdit: () => viewState.get().opening && parts.onAsked(),
  });
  const onEnlarge = (plot: Plot): void => commands.present(store.get().view.present === plot ? null : plot);
  const pins = createPinsInView({ store, viewState, scene, commands, range, say: feedback.say });
  const analysis = createAnalysisPlace(
    parts.analysis,
    {
      onSeek: commands.seek,
      onSpeed: commands.endSpeed,
      onEnlarge,
      onBlend: parts.onBlend,
      compared() {
        const diagonal = workspace.info?.report.diagonal;
        return diagonal === undefined ? null : { original: scene.shownOriginal, truth: parts.truth(), diagonal };
      },
      onPickTruth: () => components.openTruth(),
      onLeaveTruth: () => parts.onTruth(null),
      onColouring: (colouring) => commands.view({ colouring }),
      onMark(what) {
        if (!what) return parts.marking.component(null);
        if ('face' in what) return parts.marking.around(what.face);
        parts.marking.patches(what.patches);
      },
      onError: parts.onAnalysisError,
    },
    () => layout.present(store.get().view.present),
  );
  const components = createComponents({
    root: parts.root,
    layout,
    toast: feedback.toast,
    onError,
    offers: parts.offers,
    importOffer: parts.importOffer,
    commands,
    files: parts.files,
    takeFiles: parts.takeFiles,
    marking: parts.marking,
    analysis,
    ghostStudy: lazyComponent(async () => {
      const { createGhostStudyPanel } = await import('./ghost-study-panel.ts');
      return createGhostStudyPanel({ engine, store, range, pool: () => workspace.pool, onEnlarge, onError });
    }, onError),
    poseName: (pose) => workspace.pool?.keys.info.names[pose] ?? '',
    indefiniteFace: () => viewState.get().indefiniteFace,
    shortcuts: shortcutLines(shortcuts),
    onPeek: parts.onPeek,
    onUndo: undo.undo,
    onRedo: undo.redo,
    onOwn: parts.onOwn,
    onTheme: theme.next,
    onPlacing: (placing) => viewState.change({ placing }),
    pinHandles: pins.element,
    onCancel,
    onLink: parts.onLink,
    link: parts.link,
    leave: presentation.element,
    onRemember: parts.onRemember,
    onCloseError: closeError,
    onSingleKeys: (singleKeys) => viewState.change({ singleKeys }),
    onTake: parts.onTake,
    onFewest: parts.onFewest,
    onAsked: parts.onAsked,
    onStepBack: stepBack,
    onOriginal: parts.onOriginal,
    onTruth: parts.onTruth,
    onExportOpen: () => planExport(viewState.get().exporting.request),
    onExportChange: planExport,
    onExport: parts.onExport,
    snippet: parts.snippet,
  });
  listen(shortcuts, () => viewState.get().singleKeys);
  listenToArrows({ store, commands, viewport: layout.viewport, range, isOpen: () => viewState.get().info !== null });
  listenToCamera(scene.viewer, layout.viewport);
  listenToClicks(layout.viewport, (x, y) => {
    if (viewState.get().placing) return pins.place({ x, y });
    void analysis.need().then((panel) => panel?.clicked(() => scene.pick(x, y)));
  });

  let frame = 0;
  const draw = (): void => {
    frame = 0;
    if (parts.waits()) return;
    presentation.update(store.get().view.present);
    const { placing, seen, info } = viewState.get();
    setAttribute(layout.viewport, 'data-placing', placing);
    setAttribute(layout.viewport, 'data-dimmed', seen === 'dimmed' && info !== null);
    components.update({
      state: store.get(),
      viewState: viewState.get(),
      range: range(),
      theme: theme.theme(),
      labels: scene.shownLabels,
      split: scene.isSplit,
      outOfView: scene.outOfView,
      colourBar: scene.colourBar,
      undo: undo.undoLabel(),
      redo: undo.redoLabel(),
    });
  };
  return {
    openFiles: () => components.openFiles(),
    redraw: () => {
      if (frame === 0) frame = requestAnimationFrame(draw);
    },
  };
}
