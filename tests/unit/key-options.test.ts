/** An option per key passes through all conversions of the TypeScript code; only the table has to know it there. */
import { describe, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments.ts';
import { COMPLETE, sequenceOptions } from '../../web/cli/settings.ts';
import { patchesCsv } from '../../web/app/export/csv.ts';
import { documentFromImport } from '../../web/app/session/document-from-import.ts';
import { sequencePlan } from '../../web/app/session/sequence-plan.ts';
import type { PosePool } from '../../web/app/session/pose-pool.ts';
import { applyPermalink, readPermalink, writePermalink } from '../../web/app/sources/permalink.ts';
import { PER_KEY } from '../../web/engine/api/option-table.ts';
import type { NumberOption } from '../../web/engine/api/option-table.ts';
import { checkSequenceOptions } from '../../web/engine/api/options.ts';
import { readOptions, writeProject } from '../../web/engine/wire/project.ts';
import type { KeysInfo } from '../../web/engine/api/types.ts';
import { setShaping } from '../../web/model/edits.ts';
import { SHAPING_NUMBERS } from '../../web/model/shaping.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const initial = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b/c', 0.5), keyRef(2, 'c', 1));

describe.each(SHAPING_NUMBERS)('%s of a key', (name) => {
  const option: NumberOption & { default: number } = PER_KEY[name];
  const value = (option.min ?? 0) + 0.125;
  const list = [option.default, value, option.default];
  const doc = setShaping(initial, name, 1, value);

  it('is in the link', () => {
    const link = writePermalink({ ...EMPTY_STATE, source: { kind: 'sample', id: 'x' }, doc }, initial)!;
    expect(applyPermalink(initial, readPermalink(link)!)).toEqual(doc);
  });

  it('is in the project', () => {
    const { times, names, motion } = sequencePlan(doc);
    expect(motion[name]).toEqual(list);
    const mesh = { vertices: 3, faces: 1, error: null };
    const project = readOptions(writeProject({ times, names, frames: [0, 1, 2] }, checkSequenceOptions(motion), mesh));
    expect(documentFromImport({ names, times, project } as unknown as KeysInfo, {} as PosePool)).toEqual(doc);
  });

  it('is a command-line option', () => {
    const args = parseArguments([`--${option.flag}=${list.join(',')}`], COMPLETE);
    expect(sequenceOptions(args)).toEqual({ [name]: list });
  });

  it('is in the header of a table', () => {
    expect(patchesCsv(Int32Array.of(0), doc, '1')).toContain(`"${name}":${value}`);
  });

  it('is refused if it is not a number, or out of range', () => {
    expect(() => checkSequenceOptions({ [name]: ['x'] })).toThrow(`'${name}'`);
    if (option.max !== undefined)
      expect(() => checkSequenceOptions({ [name]: [option.max! + 1] })).toThrow(`'${name}'`);
  });
});
