/** Connects the export dialog: planning while it is open, then the export and its cancellation. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Motion } from '../../engine/api/api.ts';
import type { ExportRequest, Playing, VideoFormat } from '../../model/export-request.ts';
import { ownRate, playRange } from '../../model/frames.ts';
import type { AppState } from '../../model/state.ts';
import { exportName, safeName } from '../../ui/export-name.ts';
import { analyseAt } from '../analysis/analysis.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { Viewer } from '../../viewer/viewer.ts';
import type { Display } from '../drawing/display.ts';
import type { Session } from '../session/session.ts';
import type { Feedback } from '../view/feedback.ts';
import type { ViewStateHolder } from '../view/view-state.ts';
import { embedPage, embedSnippet } from './embed-snippet.ts';
import type { ExportPlan } from './export-job.ts';
import { videoFormats } from './write-video.ts';

export interface ExportParts {
  session: Session;
  display: Display;
  analysis: AnalysisCache;
  viewState: ViewStateHolder;
  feedback: Feedback;
  titleOf(source: AppState['source']): string;
}

/** The export code is loaded when the dialog first opens. */
const exporting = () => import('./export-job.ts');

export class ExportController {
  private abort: AbortController | null = null;
  /** Cancels the running plan when a new request makes it obsolete. */
  private planning: AbortController | null = null;
  private formats: Promise<VideoFormat[]> | null = null;

  constructor(private readonly parts: ExportParts) {}

  /** Computes the size of the requested export. */
  plan(request: ExportRequest): void {
    const { session, display, viewState } = this.parts;
    if (!this.formats) {
      this.formats = videoFormats();
      void this.formats.then((found) => viewState.change({ videoFormats: found }));
    }
    this.planning?.abort();
    const sequence = session.sequence();
    if (!sequence) return;
    this.planning = new AbortController();
    const { signal } = this.planning;
    const { time } = session.store.get();
    const asked = { sequence, time, playing: this.playing, window: display.scene.viewer.canvas, signal };
    const tell = (plan: ExportPlan): void => {
      if (viewState.opened.exporting.request === request) viewState.changeOpened({ exporting: { request, plan } });
    };
    exporting()
      .then(({ describeExport }) => describeExport(request, asked))
      .then(tell, (error: unknown) => {
        if (!signal.aborted) tell({ text: error instanceof Error ? error.message : '', warnings: [] });
      });
  }

  async run(request: ExportRequest): Promise<void> {
    const { session, display, feedback } = this.parts;
    const { store } = session;
    const { viewer } = display.scene;
    const sequence = session.sequence();
    if (!sequence || this.abort) return;
    this.abort = new AbortController();
    const { signal } = this.abort;
    const before = store.get();
    const camera = viewer.cameraPose();
    store.set({ play: { ...before.play, playing: false } });
    feedback.onStart();
    this.planning?.abort();
    try {
      // Earlier changes are still being drawn.
      await display.playback.frameLoop.idle();
      await this.runJob(request, sequence, before, signal);
      feedback.say('Saved to your downloads.');
    } catch (error) {
      if (!isCancelled(error) && !signal.aborted) feedback.onError(error);
    } finally {
      this.abort = null;
      feedback.onWorking(null);
      viewer.setCameraPose(camera);
      store.set({ time: before.time, view: { ...store.get().view, camera: before.view.camera } });
    }
  }

  /** The HTML that embeds the shape. */
  snippet(): string {
    const state = this.parts.session.store.get();
    return embedSnippet(state, `${this.name}.glb`, this.parts.titleOf(state.source));
  }

  cancel(): void {
    this.abort?.abort();
  }

  /** The typed name, or that of the files. */
  private get name(): string {
    const { session, viewState } = this.parts;
    const { request } = viewState.opened.exporting;
    return safeName(request.name) || exportName(session.store.get().source, session.workspace.info);
  }

  private get playing(): Playing {
    const { store, range, workspace } = this.parts.session;
    const { between, fps, speed } = store.get().play;
    return { range: playRange(between, range()), fps, speed, own: workspace.info && ownRate(workspace.info) };
  }

  private async runJob(
    request: ExportRequest,
    sequence: Motion,
    { doc, time, source }: AppState,
    signal: AbortSignal,
  ): Promise<void> {
    const { display, analysis, viewState, feedback } = this.parts;
    const { runExport } = await exporting();
    return runExport(request, {
      sequence,
      signal,
      doc,
      time,
      name: this.name,
      page: embedPage(this.parts.titleOf(source), this.snippet()),
      playing: this.playing,
      scene: display.scene,
      show: (t) => this.show(t),
      turn: turned(display.scene.viewer),
      async analyseAt(times, report, stop) {
        const what = analysis.input();
        if (!what || !viewState.page.charts.shellBending) return what && analyseAt(what, times, report, stop);
        const half = await analyseAt(what, times, (fraction) => report(fraction / 2), stop);
        const { withShellBendings } = await import('../analysis/shell-bendings.ts');
        return withShellBendings(half, what, {
          signal: stop,
          onProgress: ({ fraction }) => report((1 + fraction) / 2),
        });
      },
      onProgress: (working) => {
        if (!signal.aborted) feedback.onWorking(working);
      },
    });
  }

  /** Draws the exact shape at a time; resolves when it is on the screen. */
  private async show(t: number): Promise<void> {
    const { session, display, viewState } = this.parts;
    session.store.set({ time: t });
    // Exports contain the motion, so a blend is hidden first.
    if (viewState.opened.blend) viewState.changeOpened({ blend: null });
    await display.playback.frameLoop.request(t);
  }
}

function turned(viewer: Viewer): (share: number) => Promise<void> {
  let before = 0;
  return async (share) => {
    viewer.orbit((share - before) * 2 * Math.PI, 0);
    before = share;
    await viewer.drawn();
  };
}
