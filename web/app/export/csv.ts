/**
 * The plotted numbers as a table: comment lines with version, options and units first, then one row per frame or face.
 */
import type { Doc } from '../../model/state.ts';
import type { Analysis } from '../analysis/analysis.ts';

/** Digits that mean something: the engine computes in single precision. */
const DIGITS = 7;
/** Of times, which are told apart by more. */
const TIME_DIGITS = 12;

const UNITS =
  '# units: time s on the timeline; seconds s from the start as exported; volume m^3; area m^2; ' +
  'bending energy 1/s^4, relative to the mean deformation energy between keys; plane relative to the distance of keys';

/** `speed`: how many times faster than on the timeline what is exported plays. */
export function measuresCsv(analysis: Analysis, doc: Doc, version: string, speed: number): string {
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
  const [first = 0] = analysis.times;
  const rows = analysis.times.map((t, index) =>
    [
      rounded(t, TIME_DIGITS),
      rounded((t - first) / speed, TIME_DIGITS),
      ...columns.map(({ values }) => rounded(values[index] ?? NaN, DIGITS)),
    ].join(','),
  );
  const header = ['time', 'seconds', ...columns.map(({ name }) => name)].join(',');
  return [...preamble(doc, version), UNITS, header, ...rows, ''].join('\n');
}

function rounded(value: number, digits: number): number {
  return Number(value.toPrecision(digits));
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
