/** Input and output: files and samples, content of an earlier visit, the page's URL, exports. */
import { setMotion } from '../model/edits.ts';
import { lazy } from '../ui/lazy.ts';
import type { Offer, ToastAction } from '../ui/messages.ts';
import { plural } from '../ui/status-line.ts';
import type { IoControllers } from './actions/context.ts';
import type { AnalysisCache } from './analysis/analysis-cache.ts';
import type { Display } from './drawing/display.ts';
import { originalOf } from './drawing/original.ts';
import type { Feedback } from './view/feedback.ts';
import { importOffer } from './panels/import-offer.ts';
import type { ViewStateHolder } from './view/view-state.ts';
import { reducedMotion } from './view/window-events.ts';
import type { Session } from './session/session.ts';
import { Opener } from './sources/opener.ts';
import { reopening } from './sources/open-initial.ts';
import type { OpenResult } from './sources/opener.ts';
import { sourceTitle } from './sources/own-files.ts';
import { createPageLink } from './sources/page-link.ts';
import { RememberedFiles } from './storage/remembered-files.ts';
import { createUndo } from './sources/undo.ts';

export interface IoControllersParts {
  session: Session;
  display: Display;
  analysis: AnalysisCache;
  viewState: ViewStateHolder;
  feedback: Feedback;
  /** Offers actions for an import's warnings; null for none. */
  onOffer(offer: Offer | null): void;
}

const NOT_ITS_KEYS =
  'The keys are not from this animation, so it cannot be shown beside the motion. Choose its keys first.';

export function createIoControllers(parts: IoControllersParts): IoControllers {
  const { session, viewState, feedback } = parts;
  const { engine, store, workspace } = session;
  const { say, onStart, onWorking, onError } = feedback;
  const files: IoControllers['files'] = new Opener({
    engine,
    store,
    workspace,
    reducedMotion,
    say,
    onStart,
    onError,
    samples: () => viewState.page.samples,
    onOpened(opened) {
      showOpened(parts, files, opened);
      if (viewState.opened.original) showOriginal(true).catch(onError);
    },
    onRead: session.serve,
    onWorking,
  });
  const animation = lazy(async () => {
    const { Animation } = await import('./sources/animation.ts');
    return new Animation({ engine, store, workspace, files, onWorking, onError });
  });
  const remembered = new RememberedFiles({
    store,
    workspace,
    say,
    onError,
    onChange: (kept, shelf) => viewState.change({ remembered: kept, shelf }),
  });
  const link = createPageLink({
    store,
    say,
    initial: () => viewState.opened.initial,
    onLink: (to) => void files.sample(to.sample, to),
  });
  const titleOf: IoControllers['titleOf'] = (source) => sourceTitle(source, viewState.page.samples);
  const exporting = lazy(async () => {
    const { ExportController } = await import('./export/export-controller.ts');
    return new ExportController({ ...parts, titleOf });
  });
  let asked = 0;
  const showOriginal = async (shown: boolean): Promise<void> => {
    const { display, analysis } = parts;
    const ask = ++asked;
    viewState.changeOpened({ original: shown });
    const reference = shown ? await (await animation.get()).reference() : null;
    // The user has unticked the box, or opened other files.
    if (ask !== asked || viewState.opened.original !== shown) return;
    const { info } = workspace;
    if (shown && !reference && info && info.animation < 0) say(NOT_ITS_KEYS);
    display.scene.setOriginal(reference && info && originalOf(reference, info.faces));
    viewState.changeOpened({ original: reference !== null });
    analysis.invalidate();
    await display.playback.frameLoop.request(store.get().time);
  };
  const undo = createUndo({ store, files, titleOf });
  const openOwn = async (project: string): Promise<void> => {
    const left = files.history.all.find(({ state }) => state.project === project);
    if (left) await files.again(left);
    else await remembered.reopen(project, reopening(files)).catch(onError);
  };
  return { files, remembered, undo, animation, showOriginal, openOwn, link, exporting, titleOf };
}

function showOpened(
  { session: { store }, display, viewState, feedback, onOffer }: IoControllersParts,
  files: IoControllers['files'],
  opened: OpenResult,
): void {
  const { info, pool, source, doc, camera } = opened;
  const { scene, firstKey } = display;
  const loopMotion = (): void => {
    store.edit('ends', (before) => setMotion(before, { boundary: 'periodic' }));
    store.set({ play: { ...store.get().play, loop: 'loop' } });
  };
  firstKey.settle();
  viewState.open(opened);
  const offer = withRoom(importOffer(opened, files, loopMotion), () => scene.viewer.refit(!reducedMotion()));
  // The shape is fitted below the offer. If the import dialog is open, the offer is beside the shape.
  if (!viewState.opened.opening) onOffer(offer);
  scene.setImport(info, pool, camera);
  if (viewState.opened.opening) onOffer(offer);
  feedback.withdraw();
  if (source.kind === 'files')
    feedback.say(
      `${plural(doc.keys.length, 'key', 'keys')}, ${plural(info.report.vertices, 'vertex', 'vertices')}.`,
      opened.picked ? undoOpening(files) : undefined,
    );
}

/** Restores the previous content, unless its opening was already undone or replaced. */
function undoOpening(files: IoControllers['files']): ToastAction | undefined {
  const { before } = files.history;
  const run = (): void => {
    if (files.history.before === before) void files.back();
  };
  return before ? { label: 'Undo', testId: 'toast-undo', run } : undefined;
}

/** When it disappears, the view can use its space. */
function withRoom(offer: Offer | null, leave: () => void): Offer | null {
  if (!offer) return null;
  const onAccept = (): void => {
    offer.onAccept?.();
    leave();
  };
  return { ...offer, onAccept, onDecline: leave };
}
