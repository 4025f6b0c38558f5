/** "Compare sizes": error and time over sizes of the ghost mesh, worked out when asked for, in workers of its own. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Engine } from '../../engine/api/api.ts';
import type { GhostStudy } from '../../study/ghost-study.ts';
import type { Transfer } from '../../engine/api/types.ts';
import { button } from '../../ui/controls.ts';
import type { Range } from '../../model/time-scale.ts';
import { h, setHidden, setStyle, setText, svg } from '../../ui/dom.ts';
import { encodingFor, motionFor, sequencePlan } from '../session/sequence-plan.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';
import type { Plot } from '../../model/state.ts';
import type { GhostChartData } from '../../plots/ghost-chart.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Store } from '../session/store.ts';

const FRAMES = 24;
const NAMES: Record<Transfer, string> = { exact: 'Exact', paper: 'As published' };

export interface GhostStudyParts extends FigureEvents {
  engine: Engine;
  store: Store;
  pool(): PosePool | null;
  range(): Range;
}

export interface GhostStudyPanel {
  element: HTMLElement;
  /** The document may have changed: what was measured for another one goes. */
  update(): void;
}

export function createGhostStudyPanel({
  engine,
  store,
  pool,
  range,
  onEnlarge,
  onError,
}: GhostStudyParts): GhostStudyPanel {
  const start = button({
    label: 'Compare sizes of the ghost mesh',
    testId: 'study-start',
    icon: 'chart',
    text: 'Compare sizes',
    kind: 'plain',
    onClick: () => void run(),
  });
  const stage = h('span', { class: 'muted stage', role: 'status' });
  const bar = h('div', { class: 'bar' });
  const cancel = button({
    label: 'Cancel the comparison',
    testId: 'study-cancel',
    text: 'Cancel',
    kind: 'plain',
    onClick: () => abort?.abort(),
  });
  const working = h(
    'div',
    { class: 'field row', hidden: true, 'data-testid': 'study-working' },
    h('div', { class: 'progress-text' }, stage, h('div', { class: 'meter' }, bar)),
    cancel,
  );
  const result = h('div', { class: 'group', 'data-testid': 'study', hidden: true });
  const element = h('div', { class: 'group' }, start, working, result);
  let abort: AbortController | null = null;
  /** What the study is of; null without one. */
  let of: { pool: PosePool; subject: string } | null = null;

  const run = async (): Promise<void> => {
    const poses = pool();
    if (!poses || abort) return;
    const plan = sequencePlan(store.get().doc);
    const [variant] = plan.variants;
    const own = new AbortController();
    abort = own;
    of = { pool: poses, subject: subject() };
    show(null);
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
      const study = await studyGhosts(engine, keys, options, {
        times,
        signal: own.signal,
        onProgress: (progress) => {
          setText(stage, progress.stage);
          setStyle(bar, 'width', `${(100 * progress.fraction).toFixed(1)}%`);
        },
      });
      if (!own.signal.aborted) await draw(study);
    } catch (error) {
      if (!isCancelled(error)) onError(error);
    } finally {
      keys.dispose();
      abort = null;
      show(result.childElementCount > 0);
    }
  };

  /** null while it is being worked out. */
  const show = (done: boolean | null): void => {
    if (done === null) result.replaceChildren();
    setHidden(working, done !== null);
    setHidden(start, done === null);
    setHidden(result, !done);
  };

  const draw = async (study: GhostStudy): Promise<void> => {
    const [{ verdictOf, msText, percentText }, { drawGhostChart }] = await Promise.all([
      import('../../study/ghost-study.ts'),
      import('../../plots/ghost-chart.ts'),
    ]);
    const sizes = [...new Set(study.rows.map(({ wanted }) => wanted))];
    const row = (size: number, transfer: Transfer): GhostStudy['rows'][number] =>
      study.rows.find((one) => one.wanted === size && one.transfer === transfer)!;
    const names = [...sizes.map(short), 'none'];
    const series = (last: number, pick: (one: GhostStudy['rows'][number]) => number) =>
      (['exact', 'paper'] as const).map((transfer) => ({
        label: NAMES[transfer],
        style: `transfer-${transfer}`,
        values: [...sizes.map((size) => pick(row(size, transfer))), last],
      }));
    const figure = (name: Plot, data: GhostChartData): HTMLElement => {
      const { title, unit } = data;
      const element = h(
        'figure',
        { class: 'figure', 'data-testid': `plot-${name}` },
        h('figcaption', {}, h('strong', {}, title), h('span', { class: 'unit' }, unit)),
        drawGhostChart(data),
      );
      const numbers = {
        names: ['Faces, empty without a ghost mesh', ...data.series.map(({ label }) => label)],
        rows: [...sizes, NaN].map((size, i) => [size, ...data.series.map(({ values }) => values[i]!)]),
      };
      addFigureTools(element, { plot: name, title, numbers: () => numbers, onEnlarge, onError });
      return element;
    };
    const kg = {
      title: 'Error',
      unit: 'KG error against the full solve, %',
      sizes: names,
      series: series(0, (one) => one.kg),
      level: null,
    };
    const ms = {
      title: 'Time',
      unit: 'median of a frame, ms',
      sizes: names,
      series: series(study.ms, (one) => one.ms),
      level: { label: 'No ghost mesh', value: study.ms },
    };
    const cells = (name: string, one: { kg: number; ms: number }): HTMLElement[] => [
      h('td', { 'data-testid': `study-${name}-kg` }, percentText(one.kg)),
      h('td', { 'data-testid': `study-${name}-ms` }, msText(one.ms)),
    ];
    const rows = sizes.map((size) =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, size.toLocaleString('en')),
        ...(['exact', 'paper'] as const).flatMap((transfer) => cells(`${size}-${transfer}`, row(size, transfer))),
      ),
    );
    rows.push(
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, 'none'),
        ...cells('none-exact', { kg: 0, ms: study.ms }),
        ...cells('none-paper', { kg: 0, ms: study.ms }),
      ),
    );
    result.replaceChildren(
      h('p', { class: 'verdict', 'data-testid': 'study-verdict' }, verdictOf(study)),
      ...(sizes.length > 0
        ? [
            h('div', { class: 'legend' }, legend('exact'), legend('paper')),
            figure('ghost-error', kg),
            figure('ghost-time', ms),
            h(
              'details',
              { class: 'details' },
              h('summary', {}, 'Numbers'),
              h(
                'table',
                { class: 'numbers' },
                h(
                  'thead',
                  {},
                  h(
                    'tr',
                    {},
                    h('th', { scope: 'col' }, 'Faces'),
                    h('th', { scope: 'colgroup', colspan: 2 }, NAMES.exact),
                    h('th', { scope: 'colgroup', colspan: 2 }, NAMES.paper),
                  ),
                ),
                h('tbody', {}, ...rows),
              ),
            ),
          ]
        : []),
    );
  };

  /** What a study depends on: the motion as it is without a ghost. */
  const subject = (): string => {
    const { doc, source } = store.get();
    const {
      encoding: { ghostFaces, transfer, ...encoding },
      variants,
      ...rest
    } = sequencePlan(doc);
    return JSON.stringify([source, doc.motion.method, encoding, rest]);
  };

  return {
    element,
    update() {
      start.disabled = pool() === null;
      if (!of || (of.pool === pool() && of.subject === subject())) return;
      of = null;
      abort?.abort();
      result.replaceChildren();
      if (!abort) show(false);
    },
  };
}

function legend(transfer: Transfer): HTMLElement {
  const line = svg('line', { class: `transfer-${transfer}`, x1: 0, x2: 22, y1: 4, y2: 4 });
  return h('span', {}, svg('svg', { viewBox: '0 0 22 8', 'aria-hidden': 'true' }, line), NAMES[transfer]);
}

const short = (size: number): string => (size < 1000 ? String(size) : `${size / 1000}K`);
