/** Ways in and out: files and samples, what an earlier visit left, the page's address, exports. */
import { setMotion } from '../model/edits.ts';
import { lazy } from '../ui/lazy.ts';
import type { Lazy } from '../ui/lazy.ts';
import type { Offer } from '../ui/messages.ts';
import { plural } from '../ui/status-line.ts';
import type { AnalysisCache } from './analysis/analysis-cache.ts';
import type { Display } from './display.ts';
import type { ExportController, ExportParts } from './export/export-controller.ts';
import type { Feedback } from './panels/feedback.ts';
import { importOffer } from './panels/import-offer.ts';
import { openedView } from './panels/view-state.ts';
import type { ViewStateHolder } from './panels/view-state.ts';
import { reducedMotion } from './panels/window-events.ts';
import type { Session } from './session/session.ts';
import type { Animation } from './sources/animation.ts';
import { Opener } from './sources/opener.ts';
import { reopening } from './sources/open-first.ts';
import type { Opened } from './sources/opener.ts';
import { sourceTitle } from './sources/own-files.ts';
import { createPageLink } from './sources/page-link.ts';
import type { PageLink } from './sources/page-link.ts';
import { RememberedFiles } from './kept/remembered-files.ts';
import { createUndo } from './sources/undo.ts';
import type { Undo } from './sources/undo.ts';

export interface WaysParts {
  session: Session;
  display: Display;
  analysis: AnalysisCache;
  viewState: ViewStateHolder;
  feedback: Feedback;
  /** What can be done about what an import warns of; null: nothing. */
  onOffer(offer: Offer | null): void;
  /** The address names a page of the guide. */
  onGuide(fragment: string | null): void;
}

export interface Ways {
  files: Opener;
  remembered: RememberedFiles;
  undo: Undo;
  animation: Lazy<Animation>;
  /** Opens files of the user again. */
  openOwn(project: string): Promise<void>;
  link: PageLink;
  exporting: Lazy<ExportController>;
}

export function createWays({ session, display, analysis, viewState, feedback, onOffer, onGuide }: WaysParts): Ways {
  const { engine, store, workspace, sequence, range } = session;
  const { scene, playback } = display;
  const { say, onStart, onWorking, onError } = feedback;
  const loopMotion = (): void => {
    store.edit('ends', (doc) => setMotion(doc, { boundary: 'periodic' }));
    store.set({ play: { ...store.get().play, loop: 'loop' } });
  };
  /** Gone from above the shape, it leaves its room to it. */
  const withRoom = (offer: Offer | null): Offer | null => {
    const leave = (): void => scene.viewer.refit(!reducedMotion());
    if (!offer) return null;
    const onAccept = (): void => {
      offer.onAccept?.();
      leave();
    };
    return { ...offer, onAccept, onDecline: leave };
  };
  const onOpened = (opened: Opened): void => {
    const { info, pool, source, doc, camera } = opened;
    display.firstKey.settle();
    viewState.change(openedView(opened, viewState.get()));
    const offer = withRoom(importOffer(opened, files, loopMotion));
    // The shape is fitted below what is offered, which is beside it where there is a sheet.
    if (!viewState.get().opening) onOffer(offer);
    scene.setImport(info, pool, camera);
    if (viewState.get().opening) onOffer(offer);
    if (source.kind === 'files')
      say(`${plural(doc.keys.length, 'key', 'keys')}, ${plural(info.report.vertices, 'vertex', 'vertices')}.`);
  };
  const files = new Opener({
    engine,
    store,
    workspace,
    reducedMotion,
    say,
    onStart,
    onError,
    samples: () => viewState.get().samples,
    onOpened,
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
    initial: () => viewState.get().initial,
    onLink: (to) => void files.sample(to.sample, to),
    onGuide,
  });
  const exportParts: ExportParts = {
    store,
    scene,
    analysis,
    sequence,
    range,
    say,
    onStart,
    onError,
    onWorking,
    title: ({ source }) => sourceTitle(source, viewState.get().samples),
    drawExactly(t) {
      // What is exported is the motion.
      if (viewState.get().blend) viewState.change({ blend: null });
      return playback.frameLoop.request(t);
    },
    idle: () => playback.frameLoop.idle(),
    onVideoFormats: (videoFormats) => viewState.change({ videoFormats }),
    onPlan(request, plan) {
      if (viewState.get().exporting.request === request) viewState.change({ exporting: { request, plan } });
    },
  };
  const exporting = lazy(async () =>
    (await import('./export/export-controller.ts')).createExportController(exportParts),
  );
  const undo = createUndo({ store, files, titleOf: (source) => sourceTitle(source, viewState.get().samples) });
  const openOwn = async (project: string): Promise<void> => {
    const left = files.openings.all.find(({ state }) => state.project === project);
    if (left) await files.again(left);
    else await remembered.reopen(project, reopening(files)).catch(onError);
  };
  return { files, remembered, undo, animation, openOwn, link, exporting };
}
