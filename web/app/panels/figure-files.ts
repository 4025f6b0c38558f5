/** A figure's values as a table, and the figure as SVG, PNG and CSV. */
import type { Plot } from '../../model/state.ts';
import { csvOf, pngOf, svgOf } from '../../plots/plot-files.ts';
import type { Axes, Heading } from '../../plots/plot-files.ts';
import { written } from '../../plots/scale.ts';
import { h } from '../../ui/dom.ts';
import { saveButtons, valuesFrame, valuesTable } from '../../ui/values.ts';

/** Axis labels in files. */
const AXES: Readonly<Record<Plot, Axes>> = {
  plane: { x: 'First component, relative to the mean distance between keys', y: 'Second component' },
  ...overTime({ volume: 'Volume (%)', area: 'Area (%)', bending: 'Bending (1/s⁴)', sliding: 'Sliding (%)' }),
  ...overTime({ distance: 'Distance (%)', 'face-rotation': 'Rotation (°)', 'face-stretch': 'Stretch' }),
  ...overTime({ 'patch-angles': 'Angle (°)', 'patch-rotation': 'Rotation (°)', 'patch-stretch': 'Stretch' }),
  'ghost-error': { x: 'Faces of the ghost mesh', y: 'KG error (%)' },
  'ghost-time': { x: 'Faces of the ghost mesh', y: 'Time (ms)' },
};

function overTime<Name extends Plot>(names: Record<Name, string>): Record<Name, Axes> {
  const axes = Object.entries<string>(names).map(([name, y]) => [name, { x: 'Time (s)', y }]);
  return Object.fromEntries(axes) as Record<Name, Axes>;
}

/** Approximate number of rows shown. */
const READ = 24;

/** The values of a figure. A file contains all rows; the table shows rows at the keys and a selection in between. */
export interface FigureNumbers {
  names: readonly string[];
  rows: readonly (readonly number[])[];
  /** The rows that the table always shows, by their value in the first column. */
  keep?: readonly number[];
}

export interface FigureFilesOptions {
  plot: Plot;
  title: string;
  /** The figure's values; null before the figure is first drawn. */
  numbers(): FigureNumbers | null;
  onError(error: unknown): void;
}

export interface FigureFiles {
  element: HTMLElement;
  fill(): void;
}

export function createFigureFiles(
  figure: HTMLElement,
  { plot, title, numbers, onError }: FigureFilesOptions,
): FigureFiles {
  const frame = valuesFrame(title);
  const picture = (): SVGSVGElement => figure.querySelector<SVGSVGElement>('svg.plot')!;
  const captioned = (part: string): string => figure.querySelector(`figcaption ${part}`)?.textContent ?? '';
  const heading = (): Heading => ({
    title: captioned('strong'),
    unit: captioned('.unit'),
    ...AXES[plot],
  });
  const known = (): FigureNumbers => numbers() ?? { names: [], rows: [] };
  const files = saveButtons(
    plot,
    title,
    {
      svg: () => new Blob([svgOf(picture(), heading())], { type: 'image/svg+xml' }),
      png: () => pngOf(picture(), heading()),
      csv: () => new Blob([csvOf(known().names.map(cell), known().rows)], { type: 'text/csv' }),
    },
    onError,
  );
  return {
    element: h('div', { class: 'group' }, files, frame),
    fill() {
      const all = known();
      const table = { names: [...all.names], rows: [], brief: thinnedRows(all) };
      frame.replaceChildren(valuesTable(title, table, word));
    },
  };
}

/** Evenly chosen rows, and those that are always shown. */
export function thinnedRows({ rows, keep = [] }: FigureNumbers): number[][] {
  const step = Math.max(Math.ceil(rows.length / READ), 1);
  return rows.filter((row, index) => index % step === 0 || keep.includes(row[0]!)).map((row) => [...row]);
}

function word(value: number): string {
  if (!Number.isFinite(value)) return '–';
  return written(String(Number(value.toPrecision(4))));
}

/** Quotes names that contain a separator. */
function cell(name: string): string {
  return name.includes(',') ? `"${name}"` : name;
}
