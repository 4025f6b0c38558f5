/**
 * "Compare sizes" measures error and time of the open shape over ghost mesh sizes. "Compare shapes" also measures the
 * error of several samples. Both run on request, in separate workers.
 */
import { isCancelled } from '../../engine/api/errors.ts';
import { motionFor } from '../../engine/api/method-options.ts';
import type { Engine } from '../../engine/api/api.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { Range } from '../../model/time-scale.ts';
import { button } from '../../ui/controls.ts';
import { h, setHidden } from '../../ui/dom.ts';
import { encodingFor, sequencePlan } from '../session/sequence-plan.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Store } from '../session/store.ts';
import type { Sample } from '../sources/samples.ts';
import type { FigureEvents } from './figure-tools.ts';
import type { Found } from './ghost-study-result.ts';
import { createWorkingLine } from './working-line.ts';

export interface GhostStudyParts extends FigureEvents {
  engine: Engine;
  store: Store;
  pool(): PosePool | null;
  range(): Range;
  samples(): readonly Sample[];
}

export interface GhostStudyPanel {
  element: HTMLElement;
  /** Removes measurements if the document changed. */
  update(): void;
}

export function createGhostStudyPanel(parts: GhostStudyParts): GhostStudyPanel {
  const { store, pool } = parts;
  const start = button({
    label: 'Compare sizes of the ghost mesh',
    testId: 'study-start',
    text: 'Compare sizes',
    onClick: () => void run(studyOf),
  });
  const startShapes = button({
    label: 'Compare shapes: the errors of four samples over sizes of the ghost mesh',
    testId: 'study-shapes',
    text: 'Compare shapes',
    onClick: () => void run(studyWithShapes),
  });
  startShapes.id = 'study-shapes';
  const starts = h('div', { class: 'button-row' }, start, startShapes);
  const working = createWorkingLine('study', 'Cancel the comparison', () => abort?.abort());
  const result = h('div', { class: 'group', 'data-testid': 'study', hidden: true });
  const element = h(
    'div',
    { class: 'group', id: 'study-charts', 'data-testid': 'study-charts' },
    starts,
    working.element,
    result,
  );
  let abort: AbortController | null = null;
  /** The pose pool and document of the study; null without a study. */
  let of: { pool: PosePool; subject: string } | null = null;

  const run = async (measure: Measure): Promise<void> => {
    const poses = pool();
    if (!poses || abort) return;
    const own = new AbortController();
    abort = own;
    of = { pool: poses, subject: subjectOf(store) };
    show(null);
    try {
      const found = await measure(parts, poses, own.signal, working.update);
      const { ghostStudyResult } = await import('./ghost-study-result.ts');
      if (!own.signal.aborted) result.replaceChildren(...ghostStudyResult(found, parts));
    } catch (error) {
      if (!own.signal.aborted && !isCancelled(error)) parts.onError(error);
    } finally {
      abort = null;
      show(result.childElementCount > 0);
    }
  };

  /** Shows the result; `done` is null while the study is running. */
  const show = (done: boolean | null): void => {
    if (done === null) result.replaceChildren();
    working.show(done === null);
    setHidden(starts, done === null);
    setHidden(result, !done);
  };

  return {
    element,
    update() {
      for (const one of [start, startShapes]) one.disabled = pool() === null;
      if (!of || (of.pool === pool() && of.subject === subjectOf(store))) return;
      of = null;
      abort?.abort();
      result.replaceChildren();
      if (!abort) show(false);
    },
  };
}

type Measure = (
  parts: GhostStudyParts,
  poses: PosePool,
  signal: AbortSignal,
  onProgress: (progress: Progress) => void,
) => Promise<Found>;

/** The samples' share of the progress bar. */
const SHAPES_SHARE = 0.8;

const studyWithShapes: Measure = async (parts, poses, signal, onProgress) => {
  const { chosenSamples, studyShapes } = await import('./ghost-shapes.ts');
  const shapes = await studyShapes(parts.engine, chosenSamples(parts.samples()), {
    signal,
    onProgress: ({ stage, fraction }) => onProgress({ stage, fraction: SHAPES_SHARE * fraction }),
  });
  const { study } = await studyOf(parts, poses, signal, ({ stage, fraction }) =>
    onProgress({ stage: `Open shape: ${stage}`, fraction: SHAPES_SHARE + (1 - SHAPES_SHARE) * fraction }),
  );
  return { study, shapes };
};

const studyOf: Measure = async ({ engine, store, range }, poses, signal, onProgress) => {
  const plan = sequencePlan(store.get().doc);
  const [variant] = plan.variants;
  const keys = poses.keys.arrange(plan.order, plan.times, plan.names);
  try {
    const { studyGhosts, studyTimes } = await import('../../study/ghost-study.ts');
    const options = {
      ...encodingFor(plan, variant!, poses.keys),
      ...motionFor(plan.motion, variant!),
      keepLengths: 0,
      placement: plan.encoding.placement,
    };
    const call = { times: studyTimes(...range()), signal, onProgress };
    return { study: await studyGhosts(engine, keys, options, call), shapes: null };
  } finally {
    keys.dispose();
  }
};

/** The study's input: the motion without a ghost. */
function subjectOf(store: Store): string {
  const { doc, source } = store.get();
  const {
    encoding: { ghostFaces, transfer, ...encoding },
    variants,
    ...rest
  } = sequencePlan(doc);
  return JSON.stringify([source, doc.motion.method, encoding, rest]);
}
