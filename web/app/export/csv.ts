/** The plotted numbers as a table: comment lines with version and options first, then one row per time or face. */
import type { Doc } from '../../model/state.ts';
import type { Analysis } from '../analysis/analysis.ts';

export function measuresCsv(analysis: Analysis, doc: Doc, version: string): string {
  const columns = analysis.motions.flatMap(({ method, volume, area, bending, plane }) => [
    { name: `${method} volume`, values: volume },
    { name: `${method} area`, values: area },
    ...(bending ? [{ name: `${method} bending energy`, values: bending }] : []),
    ...(plane
      ? [
          { name: `${method} plane x`, values: every(plane, 0) },
          { name: `${method} plane y`, values: every(plane, 1) },
        ]
      : []),
  ]);
  const rows = analysis.times.map((t, index) => [t, ...columns.map(({ values }) => values[index] ?? NaN)].join(','));
  return [...preamble(doc, version), ['time', ...columns.map(({ name }) => name)].join(','), ...rows, ''].join('\n');
}

export function patchesCsv(patches: Int32Array, doc: Doc, version: string): string {
  return [
    ...preamble(doc, version),
    'face,patch',
    ...Array.from(patches, (patch, face) => `${face},${patch}`),
    '',
  ].join('\n');
}

function preamble(doc: Doc, version: string): string[] {
  const { keys, motion, encoding } = doc;
  return [
    `# shapespline ${version}`,
    `# keys [${keys.map(({ name, time, shaping }) => `{"name":${quoted(name)},${JSON.stringify({ time, ...shaping }).slice(1)}`).join(',')}]`,
    `# options ${JSON.stringify({ ...motion, ...encoding })}`,
  ];
}

/** A JSON string without separators: no spreadsheet takes what follows one for a formula. */
function quoted(name: string): string {
  return JSON.stringify(name).replace(/[,;]/g, (mark) => `\\u00${mark.charCodeAt(0).toString(16)}`);
}

function every(points: readonly number[], part: 0 | 1): number[] {
  return points.filter((_, index) => index % 2 === part);
}
