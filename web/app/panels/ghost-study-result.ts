/** What a comparison of sizes of the ghost mesh has found: a sentence, two charts, and their numbers. */
import type { Transfer } from '../../engine/api/types.ts';
import type { Plot } from '../../model/state.ts';
import { drawGhostChart } from '../../plots/ghost-chart.ts';
import type { GhostChartData } from '../../plots/ghost-chart.ts';
import { TRANSFERS, msText, percentText, verdictOf } from '../../study/ghost-study.ts';
import type { GhostRow, GhostStudy } from '../../study/ghost-study.ts';
import { h } from '../../ui/dom.ts';
import { legendEntry } from './chart-figure.ts';
import { addFigureTools } from './figure-tools.ts';
import type { FigureEvents } from './figure-tools.ts';

const NAMES: Record<Transfer, string> = { exact: 'Exact', paper: 'As published' };

type Measured = Pick<GhostRow, 'kg' | 'ms'>;

export interface SizeRow {
  /** null: without a ghost mesh. */
  size: number | null;
  measured: Record<Transfer, Measured>;
}

export function ghostStudyResult(study: GhostStudy, events: FigureEvents): HTMLElement[] {
  const verdict = h('p', { class: 'verdict', 'data-testid': 'study-verdict' }, verdictOf(study));
  if (study.rows.length === 0) return [verdict];
  const rows = sizeRows(study);
  const level = { label: 'No ghost mesh', value: study.ms };
  const error = { title: 'Error', unit: 'KG error against the full solve, %', level: null };
  const time = { title: 'Time', unit: 'median of a frame, ms', level };
  return [
    verdict,
    h('div', { class: 'legend' }, ...TRANSFERS.map((transfer) => legendEntry(`transfer-${transfer}`, NAMES[transfer]))),
    figure('ghost-error', { ...error, ...chartSeries(rows, 'kg') }, rows, events),
    figure('ghost-time', { ...time, ...chartSeries(rows, 'ms') }, rows, events),
    h('details', { class: 'details' }, h('summary', {}, 'Numbers'), table(rows)),
  ];
}

/** Those of the study by their sizes; the last is without a ghost mesh. */
export function sizeRows({ rows, ms }: GhostStudy): SizeRow[] {
  const sizes = [...new Set(rows.map(({ wanted }) => wanted))];
  const at = (size: number, transfer: Transfer): Measured =>
    rows.find((one) => one.wanted === size && one.transfer === transfer)!;
  const none = { kg: 0, ms };
  return [
    ...sizes.map((size) => ({ size, measured: { exact: at(size, 'exact'), paper: at(size, 'paper') } })),
    { size: null, measured: { exact: none, paper: none } },
  ];
}

function chartSeries(rows: readonly SizeRow[], what: keyof Measured): Pick<GhostChartData, 'sizes' | 'series'> {
  return {
    sizes: rows.map(({ size }) => (size === null ? 'none' : short(size))),
    series: TRANSFERS.map((transfer) => ({
      label: NAMES[transfer],
      style: `transfer-${transfer}`,
      values: rows.map(({ measured }) => measured[transfer][what]),
    })),
  };
}

function figure(plot: Plot, data: GhostChartData, rows: readonly SizeRow[], events: FigureEvents): HTMLElement {
  const { title, unit, series } = data;
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': `plot-${plot}` },
    h('figcaption', {}, h('strong', {}, title), h('span', { class: 'unit' }, unit)),
    drawGhostChart(data),
  );
  const numbers = {
    names: ['Faces, empty without a ghost mesh', ...series.map(({ label }) => label)],
    rows: rows.map(({ size }, i) => [size ?? NaN, ...series.map(({ values }) => values[i]!)]),
  };
  addFigureTools(element, { ...events, plot, title, numbers: () => numbers });
  return element;
}

function table(rows: readonly SizeRow[]): HTMLElement {
  const names = TRANSFERS.map((transfer) => h('th', { scope: 'colgroup', colspan: 2 }, NAMES[transfer]));
  const cells = (name: string, { kg, ms }: Measured): HTMLElement[] => [
    h('td', { 'data-testid': `study-${name}-kg` }, percentText(kg)),
    h('td', { 'data-testid': `study-${name}-ms` }, msText(ms)),
  ];
  const row = ({ size, measured }: SizeRow): HTMLElement =>
    h(
      'tr',
      {},
      h('th', { scope: 'row' }, size === null ? 'none' : size.toLocaleString('en')),
      ...TRANSFERS.flatMap((transfer) => cells(`${size ?? 'none'}-${transfer}`, measured[transfer])),
    );
  return h(
    'table',
    { class: 'numbers' },
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Faces'), ...names)),
    h('tbody', {}, ...rows.map(row)),
  );
}

const short = (size: number): string => (size < 1000 ? String(size) : `${size / 1000}K`);
