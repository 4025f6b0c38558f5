/** The export dialog's side of things: the plan while it is open, the work and its cancel afterwards. */
import type { AppState } from '../../model/state.ts';
import { playRange } from '../../model/frames.ts';
import { leadingName } from '../../ui/dropped-files.ts';
import type { ExportRequest } from '../../ui/export-dialog.ts';
import type { Context } from '../context.ts';
import { describeExport, runExport } from './export-job.ts';
import type { Stretch } from './export-job.ts';
import type { AnalysisPanel } from '../panels/analysis-panel.ts';
import { isCancelled } from '../session/sequence-set.ts';

export interface ExportController {
  /** Works out the size of what is asked for. */
  plan(request?: ExportRequest): void;
  run(request: ExportRequest): Promise<void>;
  cancel(): void;
}

export function createExportController(context: Context, analysis: AnalysisPanel): ExportController {
  const { store, workspace, picture, frameLoop } = context;
  let abort: AbortController | null = null;
  let planned = 0;

  const stretch = (): Stretch => {
    const { between, fps } = store.get().play;
    return { range: playRange(between, context.range()), fps };
  };

  const show = async (t: number): Promise<void> => {
    store.set({ time: t });
    await frameLoop.request(t);
  };

  const turned = (): ((share: number) => Promise<void>) => {
    let last = 0;
    return async (share) => {
      picture.viewer.orbit((share - last) * 2 * Math.PI, 0);
      last = share;
      await picture.viewer.drawn();
    };
  };

  return {
    plan(request = context.viewState().exporting.request) {
      const sequence = workspace.sequences[0]?.sequence;
      planned += 1;
      const mine = planned;
      context.inform({ exporting: { request, plan: null } });
      if (!sequence) return;
      describeExport(request, sequence, store.get().time, stretch()).then(
        (plan) => { if (mine === planned) context.inform({ exporting: { request, plan } }); },
        (error: unknown) => { if (mine === planned) context.inform({ exporting: { request, plan: { text: error instanceof Error ? error.message : '', warnings: [] } } }); },
      );
    },
    async run(request) {
      const sequence = workspace.sequences[0]?.sequence;
      if (!sequence || abort) return;
      abort = new AbortController();
      const { signal } = abort;
      const before = store.get();
      store.set({ play: { ...before.play, playing: false } });
      context.inform({ problem: null });
      try {
        // What moved or played until now may be on the screen about right only.
        await frameLoop.idle();
        await runExport(request, {
          sequence, signal, show, doc: before.doc, name: fileStem(before), time: before.time, stretch: stretch(),
          canvas: picture.viewer.canvas, analysis: () => analysis.data(), turn: turned(), picture: () => picture.png(), backdrop: (on) => picture.viewer.setBackdrop(on ? stageColour() : null),
          onProgress: (working) => { if (!signal.aborted) context.inform({ working }); },
        });
        context.say('Saved to your downloads.');
      } catch (error) {
        if (!isCancelled(error) && !signal.aborted) context.fail(error);
      } finally {
        abort = null;
        context.inform({ working: null });
        store.set({ time: before.time });
      }
    },
    cancel: () => abort?.abort(),
  };
}

/** What lies behind the shape on the page. */
function stageColour(): string {
  const probe = document.createElement('span');
  probe.style.color = 'var(--stage-centre)';
  document.body.append(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}

function fileStem({ source }: AppState): string {
  if (source.kind === 'sample') return source.id;
  const first = source.kind === 'files' ? leadingName(source.names) : '';
  return first.replace(/^.*[/\\]/, '').replace(/\.[a-z]+$/i, '') || 'shapespline';
}
