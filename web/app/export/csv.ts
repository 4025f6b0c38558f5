/** The plotted numbers as a table: comment lines with version, options and units, then one row per frame or face. */
import type { Doc, KeyRef } from '../../model/state.ts';
import { MEASURE_UNITS, SHELL_UNITS, columnsOf, tableJson, tableOf } from '../../study/motion-measures.ts';
import type { Analysis } from '../analysis/analysis.ts';

/** `speed`: playback speed of the export relative to the timeline. */
export function measuresCsv({ times, motions }: Analysis, doc: Doc, version: string, speed: number): string {
  const table = tableOf(times, speed, motions.flatMap(columnsOf));
  const units = motions.some(({ shell }) => shell) ? [MEASURE_UNITS, SHELL_UNITS] : [MEASURE_UNITS];
  return [...preamble(doc, version), ...units, ...table, ''].join('\n');
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
    `# keys [${keys.map(keyText).join(',')}]`,
    `# options ${JSON.stringify({ ...motion, ...encoding })}`,
  ];
}

function keyText({ name, time, shaping }: KeyRef): string {
  // Numbers have 12 digits, as in the table.
  const numbers = JSON.stringify({ time: Number(time.toPrecision(12)), ...shaping });
  return `{"name":${tableJson(name)},${numbers.slice(1)}`;
}
