/** The components, what they are shown of the state, and which command each of their events is. */
import { METHOD } from '../../engine/api/methods.ts';
import type { Warning } from '../../engine/api/types.ts';
import { tightness } from '../../model/edits.ts';
import { DEFAULT_REQUEST } from '../../model/export-request.ts';
import type { ExportRequest } from '../../model/export-request.ts';
import type { AppState } from '../../model/state.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, bounces, endTangents, referenceKey } from '../../model/state.ts';
import { playRange } from '../../model/frames.ts';
import { OFF_CURVE, phaseOf, timeScale } from '../../model/time-scale.ts';
import type { End } from '../../model/speeds.ts';
import type { Range } from '../../model/time-scale.ts';
import { viridisGradient } from '../../plots/viridis.ts';
import { createClockMenu } from '../../ui/clock-menu.ts';
import { createColourBar } from '../../ui/colour-bar.ts';
import type { ColourBarProps } from '../../ui/colour-bar.ts';
import type { ExportDialog, ExportDialogProps } from '../../ui/export-dialog.ts';
import type { EmbedDialog } from '../../ui/embed-dialog.ts';
import { createDivider } from '../../ui/divider.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import { createDropZone, createPicker } from '../../ui/file-drop.ts';
import type { DropPoint } from '../../ui/file-drop.ts';
import { createGhostPanel } from '../../ui/ghost-panel.ts';
import { createHeader } from '../../ui/header.ts';
import type { Help, ShortcutLine } from '../../ui/help.ts';
import { createKeyStrip } from '../../ui/key-strip.ts';
import type { KeyItem } from '../../ui/key-strip.ts';
import { createErrorMessage, createFitHint, createProgress, createWelcome } from '../../ui/messages.ts';
import type { LinkDialog } from '../../ui/link-dialog.ts';
import { createMotionPanel } from '../../ui/motion-panel.ts';
import type { OpeningSheet } from '../../ui/opening-sheet.ts';
import type { Sampling, SamplingProps } from '../../ui/sampling.ts';
import { createShapePanel } from '../../ui/shape-panel.ts';
import { createStatusLine } from '../../ui/status-line.ts';
import type { Theme } from '../../ui/theme.ts';
import { createTimeline } from '../../ui/timeline.ts';
import { createTransport } from '../../ui/transport.ts';
import type { WarningItem, WarningsList, WarningsProps } from '../../ui/warnings.ts';
import { createPhaseLabel, createTileLabels, createViewBar } from '../../ui/view-bar.ts';
import type { TileLabel } from '../../ui/view-bar.ts';
import { addReason } from './commands.ts';
import type { Commands } from './commands.ts';
import type { GhostStudyPanel } from './ghost-study-panel.ts';
import type { AnalysisPlace } from './analysis-place.ts';
import { warningItems } from '../drawing/marking.ts';
import type { Marking } from '../drawing/marking.ts';
import type { Opener } from '../sources/opener.ts';
import { ownFiles } from '../sources/own-files.ts';
import type { TakeFiles } from '../sources/take-files.ts';
import { PLAYING_TOLERANCE } from '../drawing/scene-controller.ts';
import { h } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LazyComponent } from '../../ui/lazy.ts';
import type { ViewState } from './view-state.ts';
import type { Layout } from './layout.ts';

export interface ComponentsInput {
  onError(error: unknown): void;
  layout: Layout;
  root: HTMLElement;
  /** Where short news appear. */
  toast: HTMLElement;
  /** What waits for the user's word. */
  offers: readonly HTMLElement[];
  /** The one of them that is about files just opened. */
  importOffer: HTMLElement;
  commands: Commands;
  files: Opener;
  takeFiles: TakeFiles;
  analysis: AnalysisPlace;
  ghostStudy: LazyComponent<void, GhostStudyPanel>;
  marking: Marking;
  poseName(pose: number): string;
  /** An indefinite face of the shape on the screen. */
  indefiniteFace(): number;
  shortcuts: readonly ShortcutLine[];
  /** The mouse points at a moment of the timeline, or at none any more. */
  onPeek(t: number | null): void;
  onUndo(): void;
  onRedo(): void;
  onOwn(project: string): void;
  onLink(): void;
  /** The link to what is on the screen; null where there is none. */
  link(): string | null;
  /** The way out of the presentation. */
  leave: HTMLElement;
  onRemember(): void;
  onTheme(): void;
  onPlacing(placing: boolean): void;
  /** Pins where they are on the shape. */
  pinHandles: HTMLElement;
  onCancel(): void;
  onCloseError(): void;
  onSingleKeys(on: boolean): void;
  /** Takes the keys anew, at these seconds of the animation. */
  onTake(animation: number, times: number[]): void;
  /** Looks for the fewest keys of an animation, for an error in percent of the diagonal. */
  onFewest(animation: number, percent: number): Promise<void>;
  /** The sheet on opening an animation has been seen. */
  onAsked(): void;
  /** Escape: ends the newest of what can be ended. */
  onStepBack(): void;
  onOriginal(shown: boolean): void;
  /** Files hold an animation to compare with. */
  onTruth(picked: PickedFile[] | Promise<PickedFile[]>): void;
  onExportOpen(): void;
  onExportChange(request: ExportRequest): void;
  onExport(request: ExportRequest): void;
  /** What a page says to show what is open. */
  snippet(): Promise<string>;
}

export interface Shown {
  state: AppState;
  viewState: ViewState;
  range: Range;
  theme: Theme;
  undo: string | null;
  redo: string | null;
  labels: readonly TileLabel[];
  /** Two motions are on either side of a divider. */
  split: boolean;
  outOfView: boolean;
  colourBar: ColourBarProps | null;
}

export interface Components {
  update(shown: Shown): void;
  openFiles(): void;
  /** Has the user choose an animation to compare with. */
  openTruth(): void;
  openExport(): void;
  openHelp(): void;
  openLink(): void;
  toggleLook(): void;
  toggleClock(): void;
}

export function createComponents(input: ComponentsInput): Components {
  const { commands, files, analysis, ghostStudy, layout } = input;
  const picker = createPicker('file-input', (picked) => void input.takeFiles.take(picked));
  const keyPicker = createPicker('key-file-input', (picked) => void files.addKeys(picked));
  let tangentOf: End = 'start';
  const tangentPicker = createPicker('tangent-file-input', (picked) => void files.takeTangent(picked, tangentOf));
  const truthPicker = createPicker('truth-file-input', input.onTruth);
  const takesTruth = ({ x, y }: DropPoint): boolean =>
    document.elementsFromPoint(x, y).some((one) => one.closest('[data-takes="truth"]'));
  const dropZone = createDropZone(
    (dropped, at) => {
      if (takesTruth(at)) return input.onTruth(dropped);
      const end = motionPanel.endAt(at);
      void (end ? files.takeTangent(dropped, end) : input.takeFiles.take(dropped, keyStrip.placeAt(at)));
    },
    (at) => {
      const place = at && keyStrip.placeAt(at);
      keyStrip.showPlace(place);
      if (place !== null) return `A pose of this mesh becomes key ${place + 1}`;
      if (at && takesTruth(at)) return 'An animation of this mesh is compared with the motion';
      const end = at && motionPanel.endAt(at);
      return end && `The motion ${end === 'start' ? 'leaves towards' : 'arrives from'} a pose of this mesh`;
    },
  );
  const header = createHeader({
    onSample: (id) => void files.sample(id),
    onOwn: input.onOwn,
    onOpen: picker.open,
    onUndo: input.onUndo,
    onRedo: input.onRedo,
    onExport: () => openExport(),
    onLink: input.onLink,
    onRemember: input.onRemember,
    onHelp: () => openHelp(),
    onTheme: input.onTheme,
  });
  const timeline = createTimeline({
    onSeek: commands.seek,
    onRetime: commands.retimeKey,
    onBetween: commands.between,
    onWindow: commands.window,
    onSpeed: commands.endSpeed,
    onPeek: input.onPeek,
  });
  const clockMenu = createClockMenu({
    onFps: commands.fps,
    onLoopEnd: commands.loopEnd,
    onBetween: commands.between,
    onZoom: commands.zoomTime,
    onWindow: commands.window,
  });
  const transport = createTransport(timeline.element, clockMenu.element, {
    onTogglePlay: commands.togglePlay,
    onLoop: commands.loop,
    onSpeed: commands.speed,
    onSeek: commands.goTo,
  });
  const keyStrip = createKeyStrip({
    onSeek: commands.seek,
    onMove: commands.moveKey,
    onRemove: commands.removeKey,
    onRetime: commands.retimeKey,
    onRename: commands.renameKey,
    onShaping: commands.shaping,
    onTurns: commands.turns,
    onComponent: input.marking.component,
    onReference: commands.reference,
    onAddCurrent: () => void commands.addCurrent(),
    onAddFile: keyPicker.open,
    onError: input.onError,
  });
  const sampling = lazyComponent<SamplingProps, Sampling>(async () => {
    const { createSampling } = await import('../../ui/sampling.ts');
    return createSampling({ onTake: input.onTake, onFewest: input.onFewest, onOriginal: input.onOriginal });
  }, input.onError);
  const opening = h('section', {
    class: 'opening',
    'aria-label': 'The animation',
    'data-testid': 'opening',
    hidden: true,
  });
  const openingSheet = lazyComponent<boolean, OpeningSheet>(
    async () => {
      const [{ createOpeningSheet }] = await Promise.all([import('../../ui/opening-sheet.ts'), sampling.need()]);
      return createOpeningSheet({
        element: opening,
        choices: sampling.element,
        over: [progress.element, input.importOffer],
        next: layout.viewport,
        onClose: input.onAsked,
        onEscape: input.onStepBack,
      });
    },
    input.onError,
    opening,
  );
  const motionPanel = createMotionPanel(
    {
      onMotion: commands.motion,
      onSpeed: commands.endSpeed,
      onEncoding: commands.encoding,
      onTangentFile(end) {
        tangentOf = end;
        tangentPicker.open();
      },
      onCompare: commands.compare,
      onPlacing: input.onPlacing,
      onTightness: commands.tightness,
      onAutoTightness: () => void commands.autoTightness().catch(input.onError),
      onSpacing: (spacing) => void commands.spaceKeys(spacing).catch(input.onError),
      onReverse: commands.reverse,
      onReset: commands.resetMotion,
    },
    sampling.element,
  );
  const ghostPanel = createGhostPanel({ onEncoding: commands.encoding, onView: commands.view }, ghostStudy.element);
  const shapePanel = createShapePanel(ghostPanel.element, {
    onEncoding: commands.encoding,
    onReset: commands.resetShape,
    onOrient: (orientation) => void files.reorient(orientation),
    onObjects: (names) => void files.takeObjects(names),
  });
  const viewBar = createViewBar({
    onFit: commands.fit,
    onView: commands.view,
    onSplit: commands.toggleSplit,
    onPresent: () => commands.present('shape'),
    onQr: () => openLink(),
    onUp: (up) => void (lying && files.reorient({ ...lying, up })),
  });
  let lying: ViewState['orientation'] = null;
  const fitHint = createFitHint(() => commands.fit(null));
  const phaseLabel = createPhaseLabel(() => input.marking.around(input.indefiniteFace()));
  const tileLabels = createTileLabels();
  const divider = createDivider((split) => commands.view({ split }));
  const colourBar = createColourBar(viridisGradient('var(--ramp-way, to top)'));
  const warnings = lazyComponent<WarningsProps, WarningsList>(async () => {
    const { createWarnings } = await import('../../ui/warnings.ts');
    return createWarnings(input.marking.warning);
  }, input.onError);
  const status = createStatusLine((from) => void warnings.need().then((list) => list?.toggle(from)));
  const progress = createProgress(input.onCancel);
  const errorMessage = createErrorMessage(input.onCloseError, () => location.reload());
  const welcome = createWelcome(picker.open);
  const exporting = lazyComponent<ExportDialogProps, ExportDialog>(async () => {
    const { createExportDialog } = await import('../../ui/export-dialog.ts');
    return createExportDialog({
      onChange: input.onExportChange,
      onExport: input.onExport,
      onEmbed: () => void openEmbed().catch(input.onError),
    });
  }, input.onError);
  const help = lazyComponent<boolean, Help>(async () => {
    const { createHelp } = await import('../../ui/help.ts');
    return createHelp(input.shortcuts, input.onSingleKeys);
  }, input.onError);
  const openHelp = (): void => void help.need().then((dialog) => dialog?.open());
  const linkDialog = lazyComponent<void, LinkDialog>(async () => {
    const { createLinkDialog } = await import('../../ui/link-dialog.ts');
    return createLinkDialog(input.onLink);
  }, input.onError);
  const openLink = (): void => void linkDialog.need().then((dialog) => dialog?.open(input.link()));
  const embedDialog = lazyComponent<void, EmbedDialog>(async () => {
    const { createEmbedDialog } = await import('../../ui/embed-dialog.ts');
    return createEmbedDialog({ onSave: () => input.onExport({ ...DEFAULT_REQUEST }), onError: input.onError });
  }, input.onError);
  const openEmbed = async (): Promise<void> => {
    const [dialog, snippet] = await Promise.all([embedDialog.need(), input.snippet()]);
    dialog?.open(snippet);
  };
  const openExport = (): void => {
    input.onExportOpen();
    void exporting.need().then((dialog) => dialog?.open());
  };

  layout.mount(input.root, {
    header: header.element,
    transport: transport.element,
    keyStrip: keyStrip.element,
    warnings: warnings.element,
    status: status.element,
    opening,
    overlays: [
      tileLabels.element,
      input.pinHandles,
      divider.element,
      colourBar.element,
      welcome.element,
      phaseLabel.element,
      viewBar.element,
      input.leave,
    ],
    messages: [errorMessage.element, progress.element, fitHint.element, ...input.offers],
    panels: [motionPanel.element, shapePanel.element, analysis.element],
    floating: [
      exporting.element,
      help.element,
      linkDialog.element,
      embedDialog.element,
      dropZone.element,
      picker.element,
      keyPicker.element,
      tangentPicker.element,
      truthPicker.element,
      input.toast,
    ],
  });

  const update = ({
    state,
    viewState,
    range,
    theme,
    undo,
    redo,
    labels,
    split,
    outOfView,
    colourBar: heat,
  }: Shown): void => {
    const { doc, play, time, view, source } = state;
    const { info } = viewState;
    const disabled = info === null;
    const periodic = doc.motion.boundary === 'periodic';
    const phase = phaseOf({
      t: time,
      keys: doc.keys,
      range,
      periodic,
      tolerance: play.playing ? PLAYING_TOLERANCE : undefined,
    });
    const shownPhase = viewState.blend ? OFF_CURVE : phase;
    header.update({
      samples: viewState.samples,
      sample: source.kind === 'sample' ? source.id : null,
      theme,
      undo,
      redo,
      own: ownFiles(state, files.openings.all, viewState.shelf),
      project: state.project,
      canExport: !disabled,
      remembered: viewState.remembered,
    });
    const { fps, between, playing } = play;
    const speeds =
      doc.motion.boundary === 'hermite' && !disabled
        ? { start: doc.motion.startSpeed, end: doc.motion.endSpeed }
        : null;
    const scale = timeScale(range, doc.keys.length);
    timeline.update({
      ...scale,
      keys: doc.keys,
      time,
      playing,
      phase,
      periodic,
      disabled,
      fps,
      between,
      window: view.window,
      speeds,
      mostSpeeds: viewState.mostSpeeds,
      towards: endTangents(doc),
      pace: disabled ? null : viewState.pace,
      picture: viewState.timePicture,
    });
    clockMenu.update({ ...scale, time, fps, between, window: view.window, disabled });
    transport.update({ play, time, range, periodic, disabled });
    keyStrip.update({
      keys: keyItems(state, viewState),
      time,
      range,
      disabled,
      canRemove: doc.keys.length > 2,
      components: viewState.stats?.components ?? 1,
      addReason: addReason(
        doc.keys.map((key) => key.time),
        time,
        range,
      ),
    });
    motionPanel.update({
      motion: doc.motion,
      encoding: doc.encoding,
      compare: view.compare,
      mostSpeeds: viewState.mostSpeeds,
      keys: doc.keys,
      poseName: input.poseName,
      placing: viewState.placing,
      tightness: tightness(doc),
      period: range[1] - range[0],
      disabled,
      defaults: viewState.initial?.motion ?? DEFAULT_MOTION,
    });
    shapePanel.update({
      encoding: doc.encoding,
      keys: doc.keys,
      reference: referenceKey(doc),
      info,
      stats: viewState.stats,
      threads: viewState.threads,
      canSample: source.kind === 'files',
      orientation: viewState.orientation,
      objects: viewState.objects,
      disabled,
      defaults: viewState.initial?.encoding ?? DEFAULT_ENCODING,
      lriMethod: METHOD[doc.motion.method].space === 'lri',
    });
    ghostPanel.update({
      encoding: doc.encoding,
      view,
      faces: info?.report.faces ?? 0,
      stats: viewState.stats,
      lriMethod: METHOD[doc.motion.method].space === 'lri',
      disabled,
    });
    // Not before the first shape is seen, which needs none of it.
    if (viewState.ms !== null) void ghostStudy.need();
    ghostStudy.update();
    lying = viewState.orientation;
    if (source.kind === 'files' && info?.animations.some(({ moves }) => moves)) void sampling.need();
    sampling.update({
      info: source.kind === 'files' ? info : null,
      fewest: viewState.fewest,
      original: viewState.original,
    });
    if (viewState.opening) void openingSheet.need();
    openingSheet.update(viewState.opening);
    viewBar.update({ view, up: lying?.up ?? null, disabled });
    // A film strip shows no one moment; a first key is not of what is open.
    phaseLabel.update(disabled || view.film || viewState.seen === 'first key' ? null : shownPhase, {
      share: viewState.indefinite / Math.max(info?.report.faces ?? 0, 1),
      hasPlace: viewState.indefiniteFace >= 0,
    });
    fitHint.update(!disabled && outOfView);
    tileLabels.update(labels, split);
    divider.update({
      share: split ? view.split : null,
      left: labels[1]?.title ?? '',
      right: labels[0]?.title ?? '',
    });
    colourBar.update(heat);
    status.update({
      keys: doc.keys.length,
      vertices: info?.report.vertices ?? 0,
      faces: info?.report.faces ?? 0,
      ms: viewState.ms,
      warnings: viewState.warnings.length,
      offline: viewState.offline,
    });
    warnings.update({ items: itemsOf(viewState.warnings), shown: viewState.shownWarning });
    progress.update(viewState.working);
    errorMessage.update(viewState.errorMessage);
    const covered =
      heat !== null || (labels.length > 0 && !split) || viewState.errorMessage !== null || viewState.working !== null;
    // The divider is on its way: what it says of it is not said after something else.
    const divided = state.view.split !== null && state.view.compare.length === 1;
    welcome.update(viewState.welcome, covered, divided);
    const { videoFormats } = viewState;
    exporting.update({
      ...viewState.exporting,
      range: playRange(between, range),
      fps,
      speed: play.speed,
      bounces: bounces(play.loop, doc.motion.boundary),
      videoFormats,
    });
    help.update(viewState.singleKeys);
    if (viewState.ms !== null) void analysis.need();
    const { blend, mostSpeeds } = viewState;
    analysis.update({ time, colouring: view.colouring, blend, keys: doc.keys, speeds, mostSpeeds });
  };
  return {
    update,
    openFiles: picker.open,
    openTruth: truthPicker.open,
    openExport,
    openHelp,
    openLink,
    toggleLook: viewBar.toggleLook,
    toggleClock: clockMenu.toggle,
  };
}

/** The same list as long as nothing in it changes, so that the strip is not drawn anew on every frame. */
const keyItems = (() => {
  let last: { doc: unknown; thumbnails: unknown; items: ReturnType<typeof makeItems> } | null = null;
  return ({ doc }: AppState, { thumbnails }: ViewState): ReturnType<typeof makeItems> => {
    if (last?.doc !== doc || last.thumbnails !== thumbnails)
      last = { doc, thumbnails, items: makeItems(doc, thumbnails) };
    return last.items;
  };
})();

/** The same list as long as the warnings are the same. */
const itemsOf = (() => {
  let last: { warnings: unknown; items: WarningItem[] } | null = null;
  return (warnings: readonly Warning[]): WarningItem[] => {
    if (last?.warnings !== warnings) last = { warnings, items: warningItems(warnings) };
    return last.items;
  };
})();

function makeItems(doc: AppState['doc'], thumbnails: ViewState['thumbnails']): KeyItem[] {
  const reference = referenceKey(doc);
  return doc.keys.map((key, index) => ({
    ...key,
    isReference: index === reference,
    thumbnail: thumbnails.get(key.pose) ?? null,
  }));
}
