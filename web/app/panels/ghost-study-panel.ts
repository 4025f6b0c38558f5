/** "Compare sizes": error and time over sizes of the ghost mesh, worked out when asked for, in workers of its own. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Engine } from '../../engine/api/api.ts';
import type { Progress } from '../../engine/api/types.ts';
import type { Range } from '../../model/time-scale.ts';
import type { GhostStudy } from '../../study/ghost-study.ts';
import { button } from '../../ui/controls.ts';
import { h, setHidden, setStyle, setText } from '../../ui/dom.ts';
import { encodingFor, motionFor, sequencePlan } from '../session/sequence-plan.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Store } from '../session/store.ts';
import type { FigureEvents } from './figure-tools.ts';

const FRAMES = 24;

export interface GhostStudyParts extends FigureEvents {
  engine: Engine;
  store: Store;
  pool(): PosePool | null;
  range(): Range;
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
    icon: 'chart',
    text: 'Compare sizes',
    onClick: () => void run(),
  });
  const working = createWorking(() => abort?.abort());
  const result = h('div', { class: 'group', 'data-testid': 'study', hidden: true });
  const element = h('div', { class: 'group' }, start, working.element, result);
  let abort: AbortController | null = null;
  /** What the study is of; null without one. */
  let of: { pool: PosePool; subject: string } | null = null;

  const run = async (): Promise<void> => {
    const poses = pool();
    if (!poses || abort) return;
    const own = new AbortController();
    abort = own;
    of = { pool: poses, subject: subjectOf(store) };
    show(null);
    try {
      const study = await studyOf(parts, poses, own.signal, working.update);
      const { ghostStudyResult } = await import('./ghost-study-result.ts');
      if (!own.signal.aborted) result.replaceChildren(...ghostStudyResult(study, parts));
    } catch (error) {
      if (!isCancelled(error)) parts.onError(error);
    } finally {
      abort = null;
      show(result.childElementCount > 0);
    }
  };

  /** null while it is being worked out. */
  const show = (done: boolean | null): void => {
    if (done === null) result.replaceChildren();
    setHidden(working.element, done !== null);
    setHidden(start, done === null);
    setHidden(result, !done);
  };

  return {
    element,
    update() {
      start.disabled = pool() === null;
      if (!of || (of.pool === pool() && of.subject === subjectOf(store))) return;
      of = null;
      abort?.abort();
      result.replaceChildren();
      if (!abort) show(false);
    },
  };
}

/** How far the comparison is, and the button that ends it. */
function createWorking(onCancel: () => void) {
  const stage = h('span', { class: 'muted stage', role: 'status' });
  const bar = h('div', { class: 'bar' });
  const cancel = button({
    label: 'Cancel the comparison',
    testId: 'study-cancel',
    text: 'Cancel',
    onClick: onCancel,
  });
  const element = h(
    'div',
    { class: 'field row', hidden: true, 'data-testid': 'study-working' },
    h('div', { class: 'progress-text' }, stage, h('div', { class: 'meter' }, bar)),
    cancel,
  );
  return {
    element,
    update(progress: Progress): void {
      setText(stage, progress.stage);
      setStyle(bar, 'width', `${(100 * progress.fraction).toFixed(1)}%`);
    },
  };
}

async function studyOf(
  { engine, store, range }: GhostStudyParts,
  poses: PosePool,
  signal: AbortSignal,
  onProgress: (progress: Progress) => void,
): Promise<GhostStudy> {
  const plan = sequencePlan(store.get().doc);
  const [variant] = plan.variants;
  const keys = poses.keys.arrange(plan.order, plan.times, plan.names);
  try {
    const { studyGhosts } = await import('../../study/ghost-study.ts');
    const [start, end] = range();
    const times = Array.from({ length: FRAMES }, (_, i) => start + ((i + 0.5) / FRAMES) * (end - start));
    const options = {
      ...encodingFor(plan, variant!, poses.keys),
      ...motionFor(plan, variant!),
      placement: plan.encoding.placement,
    };
    return await studyGhosts(engine, keys, options, { times, signal, onProgress });
  } finally {
    keys.dispose();
  }
}

/** What a study depends on: the motion as it is without a ghost. */
function subjectOf(store: Store): string {
  const { doc, source } = store.get();
  const {
    encoding: { ghostFaces, transfer, ...encoding },
    variants,
    ...rest
  } = sequencePlan(doc);
  return JSON.stringify([source, doc.motion.method, encoding, rest]);
}
