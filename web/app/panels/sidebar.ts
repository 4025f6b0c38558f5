/** The area beside the shape: the panels, and the dialog for choosing keys of an animation. */
import { METHOD } from '../../engine/api/methods.ts';
import { tightness } from '../../model/edits.ts';
import { DEFAULT_ENCODING, DEFAULT_MOTION, referenceKey } from '../../model/state.ts';
import { createGhostPanel } from '../../ui/ghost-panel.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LazyComponent } from '../../ui/lazy.ts';
import { createMotionPanel } from '../../ui/motion-panel.ts';
import type { Sampling, SamplingProps } from '../../ui/sampling.ts';
import { createShapePanel } from '../../ui/shape-panel.ts';
import type { Context } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';
import { createAnalysisContainer } from './analysis-container.ts';
import type { AnalysisContainer } from './analysis-container.ts';
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

export interface Sidebar {
  motionPanel: MotionPanel;
  panels: HTMLElement[];
  analysis: AnalysisContainer;
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
    });
  }, onError);
  const splineOptions = lazyComponent(async () => {
    const { createSplineOptions } = await import('../../ui/spline-options.ts');
    return createSplineOptions(commands.motion);
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
    splineOptions.element,
  );
  connect(sampling, samplingProps(sampling));
  connect(splineOptions, ({ state: { doc }, opened }) => {
    // The options are loaded after the first shape, which does not need them.
    if (opened.ms !== null) void splineOptions.need();
    return doc;
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
    motion: doc.motion,
    encoding: doc.encoding,
    compare: view.compare,
    fitted: session.sequence()?.fitted ?? null,
    maxSpeeds: opened.maxSpeeds,
    keys: doc.keys,
    poseName,
    placing: opened.placing,
    tightness: tightness(doc),
    period: range[1] - range[0],
    disabled,
    defaults: opened.initial?.motion ?? DEFAULT_MOTION,
  });
}

function samplingProps({ need }: Sidebar['sampling']) {
  return ({ state: { source }, opened: { info, fewest, original } }: Shown): SamplingProps => {
    const own = source.kind === 'files' ? info : null;
    if (own?.animations.some(({ moves }) => moves)) void need();
    return { info: own, fewest, original };
  };
}

function createShape(context: Context, commands: Commands, connect: Connect): HTMLElement {
  const ghostStudy = createGhostStudy(context, commands);
  const ghostPanel = createGhostPanel({ onEncoding: commands.encoding, onView: commands.view }, ghostStudy.element);
  const shapePanel = createShapePanel(ghostPanel.element, {
    onEncoding: commands.encoding,
    onReset: commands.resetShape,
    onOrient: (orientation) => void commands.orient(orientation),
    onObjects: (names) => void commands.objects(names),
  });
  connect(shapePanel, ({ state: { doc, source }, opened, disabled }) => ({
    encoding: doc.encoding,
    keys: doc.keys,
    reference: referenceKey(doc),
    info: opened.info,
    stats: opened.stats,
    threads: opened.threads,
    canSample: source.kind === 'files',
    orientation: opened.orientation,
    objects: opened.objects,
    disabled,
    defaults: opened.initial?.encoding ?? DEFAULT_ENCODING,
    hasStretches: METHOD[doc.motion.method].space !== 'vertices',
  }));
  connect(ghostPanel, ({ state: { doc, view }, opened, disabled }) => ({
    encoding: doc.encoding,
    view,
    faces: opened.info?.report.faces ?? 0,
    stats: opened.stats,
    lriMethod: METHOD[doc.motion.method].space === 'lri',
    disabled,
  }));
  connect(ghostStudy, ({ opened }) => {
    // The study is loaded after the first shape, which does not need it.
    if (opened.ms !== null) void ghostStudy.need();
  });
  return shapePanel.element;
}

function createGhostStudy({ session, feedback, viewState }: Context, commands: Commands) {
  const { engine, store, range, workspace } = session;
  const { onError } = feedback;
  return lazyComponent(async () => {
    const { createGhostStudyPanel } = await import('./ghost-study-panel.ts');
    return createGhostStudyPanel({
      engine,
      store,
      range,
      pool: () => workspace.pool,
      samples: () => viewState.page.samples,
      onEnlarge: commands.enlarge,
      onError,
    });
  }, onError);
}

function createAnalysis(context: Context, commands: Commands, onFilled: () => void): AnalysisContainer {
  const { session, display, animation, viewState } = context;
  return createAnalysisContainer(
    context.analysis,
    {
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
      onError: context.analysis.onError,
    },
    onFilled,
  );
}
