/** The export dialog's side of things: the plan while it is open, the work and its cancel afterwards. */
import { isCancelled } from '../../engine/api/errors.ts';
import { modelName } from '../../engine/api/paths.ts';
import type { Motion } from '../../engine/api/api.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { ExportRequest, Playing, VideoFormat } from '../../model/export-request.ts';
import { playRange } from '../../model/frames.ts';
import { bounces } from '../../model/state.ts';
import type { AppState } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import { analyseAt } from '../analysis/analysis.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { SceneController } from '../drawing/scene-controller.ts';
import type { Store } from '../session/store.ts';
import { embedSnippet } from './embed-snippet.ts';
import type { ExportPlan } from './export-job.ts';
import { videoFormats } from './write-video.ts';

export interface ExportParts {
  store: Store;
  scene: SceneController;
  analysis: AnalysisCache;
  /** The first running sequence. */
  sequence(): Motion | undefined;
  range(): Range;
  /** Draws the exact shape of a moment; resolves when it is on the screen. */
  title(state: AppState): string;
  drawExactly(t: number): Promise<void>;
  /** Resolves when the shape on the screen is the exact one. */
  idle(): Promise<void>;
  onVideoFormats(formats: readonly VideoFormat[]): void;
  /** What the export that was asked for would be. */
  onPlan(request: ExportRequest, plan: ExportPlan): void;
  /** Something else is asked for: what went wrong before is of no interest. */
  onStart(): void;
  onWorking(working: Progress | null): void;
  say(text: string): void;
  onError(error: unknown): void;
}

export interface ExportController {
  /** Works out the size of what is asked for. */
  plan(request: ExportRequest): void;
  run(request: ExportRequest): Promise<void>;
  /** What a page says to show it. */
  snippet(): Promise<string>;
  cancel(): void;
}

/** Loaded when the dialog opens for the first time. */
const exporting = () => import('./export-job.ts');

export function createExportController(parts: ExportParts): ExportController {
  const { store, scene, sequence } = parts;
  const { viewer } = scene;
  const planning = createPlanning(parts);
  let abort: AbortController | null = null;

  const runJob = async (request: ExportRequest, of: Motion, before: AppState, signal: AbortSignal): Promise<void> => {
    const { doc, time, source } = before;
    const { runExport } = await exporting();
    return runExport(request, {
      sequence: of,
      signal,
      doc,
      time,
      name: fileStem(source),
      playing: playingOf(parts),
      scene,
      async show(t) {
        store.set({ time: t });
        await parts.drawExactly(t);
      },
      turn: turning(viewer),
      async analyseAt(times, report, stop) {
        const what = parts.analysis.input();
        return what && analyseAt(what, times, report, stop);
      },
      onProgress: (working) => {
        if (!signal.aborted) parts.onWorking(working);
      },
    });
  };

  return {
    plan: planning.plan,
    async run(request) {
      const of = sequence();
      if (!of || abort) return;
      abort = new AbortController();
      const { signal } = abort;
      const before = store.get();
      const camera = viewer.cameraPose();
      store.set({ play: { ...before.play, playing: false } });
      parts.onStart();
      planning.stop();
      try {
        // What moved or played until now may be on the screen as a preview.
        await parts.idle();
        await runJob(request, of, before, signal);
        parts.say('Saved to your downloads.');
      } catch (error) {
        if (!isCancelled(error) && !signal.aborted) parts.onError(error);
      } finally {
        abort = null;
        parts.onWorking(null);
        viewer.setCameraPose(camera);
        store.set({ time: before.time, view: { ...store.get().view, camera: before.view.camera } });
      }
    },
    async snippet() {
      const state = store.get();
      const name = fileStem(state.source);
      return embedSnippet(state, `${name}.glb`, parts.title(state));
    },
    cancel: () => abort?.abort(),
  };
}

/** A plan evaluates the motion, which nobody waits for once another is asked for. */
function createPlanning(parts: ExportParts): { plan: ExportController['plan']; stop(): void } {
  let working: AbortController | null = null;
  let formats: Promise<VideoFormat[]> | null = null;
  return {
    plan(request) {
      if (!formats) {
        formats = videoFormats();
        void formats.then(parts.onVideoFormats);
      }
      working?.abort();
      const sequence = parts.sequence();
      if (!sequence) return;
      const tell = (plan: ExportPlan): void => parts.onPlan(request, plan);
      working = new AbortController();
      const { signal } = working;
      const { time } = parts.store.get();
      const asked = { sequence, time, playing: playingOf(parts), window: parts.scene.viewer.canvas, signal };
      exporting()
        .then(({ describeExport }) => describeExport(request, asked))
        .then(tell, (error: unknown) => {
          if (!signal.aborted) tell({ text: error instanceof Error ? error.message : '', warnings: [] });
        });
    },
    stop: () => working?.abort(),
  };
}

function playingOf({ store, range }: Pick<ExportParts, 'store' | 'range'>): Playing {
  const { doc, play } = store.get();
  const { between, fps, speed, loop } = play;
  return { range: playRange(between, range()), fps, speed, bounces: bounces(loop, doc.motion.boundary) };
}

/** Turns the camera to shares of a whole turn. */
function turning(viewer: ExportParts['scene']['viewer']): (share: number) => Promise<void> {
  let before = 0;
  return async (share) => {
    viewer.orbit((share - before) * 2 * Math.PI, 0);
    before = share;
    await viewer.drawn();
  };
}

function fileStem(source: AppState['source']): string {
  if (source.kind === 'sample') return source.id;
  const first = source.kind === 'files' ? leadingName(source.names) : '';
  return modelName(first) || 'shapespline';
}
