/** The result of a comparison of ghost mesh sizes: a sentence, two charts, and their values. */
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
import { shapeLines } from './ghost-shapes.ts';
import type { ShapeErrors } from './ghost-shapes.ts';

/** The measurements; `shapes`: null for the open shape only. */
export interface Found {
  study: GhostStudy;
  shapes: readonly ShapeErrors[] | null;
}

const NAMES: Record<Transfer, string> = { exact: 'Exact', paper: 'As published' };

/** `faces`: null without a ghost mesh. */
type SizesChart = Omit<GhostChartData, 'sizes'> & { faces: readonly (number | null)[] };

type Measured = Pick<GhostRow, 'kg' | 'ms'>;

export interface SizeRow {
  /** Size of the ghost mesh; null without a ghost mesh. */
  size: number | null;
  measured: Record<Transfer, Measured>;
}

/** With several shapes, the error chart shows all of them. Time and values are always those of the open shape. */
export function ghostStudyResult({ study, shapes }: Found, events: FigureEvents): HTMLElement[] {
  const verdict = h('p', { class: 'verdict', 'data-testid': 'study-verdict' }, verdictOf(study));
  const rows = sizeRows(study);
  const error = shapes ? shapesChart(shapes) : sizesChart(rows);
  const ofOpen = study.rows.length > 0;
  return [
    verdict,
    ...(shapes || ofOpen ? [figure('ghost-error', error, events)] : []),
    ...(ofOpen ? [figure('ghost-time', timeChart(rows, study.ms), events), numbersOf(rows)] : []),
  ];
}

function sizesChart(rows: readonly SizeRow[]): SizesChart {
  return { title: 'Error', unit: 'KG error against the full solve, %', level: null, ...sizeLines(rows, 'kg') };
}

function timeChart(rows: readonly SizeRow[], ms: number): SizesChart {
  const level = { label: 'No ghost mesh', value: ms };
  return { title: 'Time', unit: 'median frame time of the open shape, ms', level, ...sizeLines(rows, 'ms') };
}

function shapesChart(shapes: readonly ShapeErrors[]): SizesChart {
  return { title: 'Error by shape', unit: 'KG error, transfer as published, %', level: null, ...shapeLines(shapes) };
}

/** The study's rows by size; the last row is without a ghost mesh. */
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

function sizeLines(rows: readonly SizeRow[], what: keyof Measured): Pick<SizesChart, 'faces' | 'series'> {
  return {
    faces: rows.map(({ size }) => size),
    series: TRANSFERS.map((transfer) => ({
      label: NAMES[transfer],
      style: `transfer-${transfer}`,
      values: rows.map(({ measured }) => measured[transfer][what]),
    })),
  };
}

function figure(plot: Plot, { faces, ...chart }: SizesChart, events: FigureEvents): HTMLElement {
  const { title, unit, series } = chart;
  const legend = h('span', { class: 'legend' }, ...series.map(({ style, label }) => legendEntry(style, label)));
  const element = h(
    'figure',
    { class: 'figure', 'data-testid': `plot-${plot}` },
    h('figcaption', {}, h('strong', {}, title), h('span', { class: 'unit' }, unit), legend),
    drawGhostChart({ ...chart, sizes: faces.map(sizeName) }),
  );
  const numbers = {
    names: [
      faces.includes(null) ? 'Faces (empty: no ghost mesh)' : 'Faces of the ghost mesh',
      ...series.map(({ label }) => label),
    ],
    rows: faces.map((size, i) => [size ?? NaN, ...series.map(({ values }) => values[i] ?? NaN)]),
  };
  addFigureTools(element, { ...events, plot, title, numbers: () => numbers });
  return element;
}

function numbersOf(rows: readonly SizeRow[]): HTMLElement {
  return h('details', { class: 'details' }, h('summary', {}, 'Numbers'), table(rows));
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

function sizeName(size: number | null): string {
  if (size === null) return 'none';
  return size < 1000 ? String(size) : `${size / 1000}K`;
}
