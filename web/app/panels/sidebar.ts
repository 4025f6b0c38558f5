/** The area beside the shape: the panels, and the dialog for choosing keys of an animation. */
import { tightness } from '../../model/edits.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION } from '../../model/state.ts';
import { panelSection } from '../../ui/controls.ts';
import { h } from '../../ui/dom.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LazyComponent } from '../../ui/lazy.ts';
import { createMotionPanel } from '../../ui/motion-panel.ts';
import type { Sampling, SamplingProps } from '../../ui/sampling.ts';
import type { Context } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';
import type { AnalysisPanel, AnalysisPanelProps } from './analysis-panel.ts';
import type { Connect, Shown } from './connect.ts';
import { endSpeeds } from './timeline-area.ts';

export type MotionPanel = ReturnType<typeof createMotionPanel>;

export interface SidebarParts {
  context: Context;
  commands: Commands;
  connect: Connect;
  /** Called when the figures exist and a presentation can show them. */
  onFilled(): void;
}

type Analysis = LazyComponent<AnalysisPanelProps, AnalysisPanel>;

export interface Sidebar {
  motionPanel: MotionPanel;
  panels: HTMLElement[];
  analysis: Analysis;
  sampling: LazyComponent<SamplingProps, Sampling>;
}

export function createSidebar({ context, commands, connect, onFilled }: SidebarParts): Sidebar {
  const { onError } = context.feedback;
  const sampling = lazyComponent<SamplingProps, Sampling>(async () => {
    const { createSampling } = await import('../../ui/sampling.ts');
    return createSampling({
      onTake: (of, times) => void commands.takeKeys(of, times),
      onFewest: commands.takeFewest,
      onOriginal: (shown) => void commands.original(shown),
      onFit: commands.fitTiming,
      onPlain: () => void commands.plainTiming(),
    });
  }, onError);
  const splineOptions = lazyComponent(async () => {
    const { createSplineOptions } = await import('../../ui/spline-options.ts');
    return createSplineOptions(commands.motion);
  }, onError);
  const regions = lazyComponent(async () => {
    const { createRegionList } = await import('../../ui/region-list.ts');
    return createRegionList((on) => commands.view({ colouring: on ? 'regions' : 'texture' }));
  }, onError);
  const motionPanel = createMotionPanel(
    {
      onMotion: commands.motion,
      onSpeed: commands.endSpeed,
      onEncoding: commands.encoding,
      onTangentFile: commands.pickTangent,
      onCompare: commands.compare,
      onPlacing: commands.placing,
      onTightness: commands.tightness,
      onAutoTightness: () => void commands.autoTightness(),
      onSpacing: (spacing) => void commands.spaceKeys(spacing),
      onReverse: commands.reverse,
      onReset: commands.resetMotion,
    },
    sampling.element,
    h('div', { class: 'group' }, regions.element, splineOptions.element),
  );
  connect(sampling, samplingProps(sampling));
  connect(regions, ({ state: { doc, view }, opened: { info } }) => {
    if (doc.motion.regions.length > 0) void regions.need();
    return { doc, colouring: view.colouring, faces: info?.report.faces ?? 0 };
  });
  connect(splineOptions, ({ state: { doc }, opened, disabled }) => {
    // The options are loaded after the first shape, which does not need them.
    if (opened.ms !== null) void splineOptions.need();
    return { ...doc, disabled };
  });
  const analysis = createAnalysis(context, commands, onFilled);
  const panels = [
    connect(motionPanel, motionProps(context)),
    createShape(context, commands, connect),
    connect(analysis, (shown) => {
      const { doc, time, view } = shown.state;
      const { ms, blend, maxSpeeds } = shown.opened;
      const { charts } = shown.page;
      if (ms !== null) void analysis.need();
      return { time, colouring: view.colouring, blend, keys: doc.keys, speeds: endSpeeds(shown), maxSpeeds, charts };
    }),
  ];
  return { motionPanel, panels, analysis, sampling };
}

function motionProps({ session }: Context) {
  const { workspace } = session;
  const poseName = (pose: number): string => workspace.pool?.keys.info.names[pose] ?? '';
  return ({ state: { doc, view }, opened, range, disabled }: Shown) => ({
    ...doc,
    compare: view.compare,
    fitted: session.sequence()?.fitted ?? null,
    maxSpeeds: opened.maxSpeeds,
    poseName,
    placing: opened.placing,
    tightness: tightness(doc),
    period: range[1] - range[0],
    disabled,
    defaults: opened.initial?.motion ?? DEFAULT_MOTION,
  });
}

function samplingProps({ need }: Sidebar['sampling']) {
  return ({ state: { source, doc }, opened: { info, fewest, original, timing } }: Shown): SamplingProps => {
    const own = source.kind === 'files' ? info : null;
    if (own?.animations.some(({ moves }) => moves)) void need();
    return { info: own, fewest, original, timing, doc };
  };
}

function createShape(context: Context, commands: Commands, connect: Connect): HTMLElement {
  const { session, feedback, viewState } = context;
  const { engine, store, range, workspace } = session;
  const { onError } = feedback;
  const panel = panelSection('Shape');
  const shape = lazyComponent(
    async () => {
      const [{ createShapePanel }, { createGhostStudyPanel }] = await Promise.all([
        import('../../ui/shape-panel.ts'),
        import('./ghost-study-panel.ts'),
      ]);
      const study = createGhostStudyPanel({
        engine,
        store,
        range,
        pool: () => workspace.pool,
        samples: () => viewState.page.samples,
        onEnlarge: commands.enlarge,
        onError,
      });
      const events = {
        onEncoding: commands.encoding,
        onView: commands.view,
        onReset: commands.resetShape,
        onOrient: commands.orient,
        onObjects: commands.objects,
      };
      return createShapePanel(panel, events, study);
    },
    onError,
    panel,
  );
  return connect(shape, ({ state: { doc, source, view }, opened: { info, stats, threads, ...shown }, disabled }) => {
    // The panel is loaded after the first shape, which does not need it.
    if (shown.ms !== null) void shape.need();
    return {
      ...doc,
      view,
      info,
      stats,
      threads,
      canSample: source.kind === 'files',
      orientation: shown.orientation,
      objects: shown.objects,
      disabled,
      defaults: shown.initial?.encoding ?? DEFAULT_ENCODING,
    };
  });
}

/** The figures are made once the first shape is on the screen. */
function createAnalysis(context: Context, commands: Commands, onFilled: () => void): Analysis {
  const { session, display, animation, analysis, viewState } = context;
  const place = panelSection('Analysis');
  const fill = async (): Promise<AnalysisPanel> => {
    const { createAnalysisPanel } = await import('./analysis-panel.ts');
    const panel = createAnalysisPanel(place, analysis, {
      onSeek: commands.seek,
      onSpeed: commands.endSpeed,
      onEnlarge: commands.enlarge,
      onBlend: commands.blend,
      compared() {
        const diagonal = session.workspace.info?.report.diagonal;
        if (diagonal === undefined) return null;
        return { original: display.scene.shownOriginal, referenceName: animation.now?.referenceName ?? null, diagonal };
      },
      onPickReference: commands.pickReference,
      onLeaveReference: () => void commands.compareWith(null),
      onColouring: (colouring) => commands.view({ colouring }),
      onMark: commands.mark,
      onCharts: (part) => viewState.change({ charts: { ...viewState.page.charts, ...part } }),
      onError: analysis.onError,
    });
    onFilled();
    return panel;
  };
  return lazyComponent(fill, analysis.onError, place);
}
