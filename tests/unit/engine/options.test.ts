import { describe, expect, it } from 'vitest';
import { EngineError } from '../../../web/engine/api/errors.ts';
import {
  checkCall,
  checkExportOptions,
  checkImportOptions,
  checkSequenceOptions,
  checkUpdate,
} from '../../../web/engine/api/options.ts';
import { EXPORT_DEFAULTS, IMPORT_DEFAULTS, MOTION_DEFAULTS, SEQUENCE_DEFAULTS } from '../../../web/engine/api/types.ts';

function refusal(check: () => unknown): string {
  try {
    check();
  } catch (error) {
    expect(error).toBeInstanceOf(EngineError);
    expect((error as EngineError).code).toBe('invalid-option');
    return (error as EngineError).message;
  }
  throw new Error('it was accepted');
}

describe('options', () => {
  it('are the defaults where nothing is given', () => {
    expect(checkSequenceOptions()).toEqual(SEQUENCE_DEFAULTS);
    expect(checkSequenceOptions({ method: undefined })).toEqual(SEQUENCE_DEFAULTS);
    expect(checkImportOptions()).toEqual(IMPORT_DEFAULTS);
    expect(checkExportOptions({})).toEqual(EXPORT_DEFAULTS);
  });

  it('pass every default through their own checks', () => {
    expect(checkSequenceOptions(SEQUENCE_DEFAULTS)).toEqual(SEQUENCE_DEFAULTS);
    expect(checkExportOptions(EXPORT_DEFAULTS)).toEqual(EXPORT_DEFAULTS);
    expect(checkImportOptions(IMPORT_DEFAULTS)).toEqual(IMPORT_DEFAULTS);
  });

  it('with unknown names are refused by that name', () => {
    expect(refusal(() => checkSequenceOptions({ boundry: 'natural' }))).toContain("'boundry'");
    expect(refusal(() => checkImportOptions({ toString: 1 }))).toContain("'toString'");
    expect(refusal(() => checkExportOptions({ frame: 3 }))).toContain("'frame'");
    expect(refusal(() => checkCall({ signals: 1 }))).toContain("'signals'");
  });

  it.each<[object, string]>([
    [{ method: 'cubic' }, 'method'],
    [{ boundary: null }, 'boundary'],
    [{ startSpeed: '1' }, 'startSpeed'],
    [{ endSpeed: NaN }, 'endSpeed'],
    [{ period: 0 }, 'period'],
    [{ period: Infinity }, 'period'],
    [{ tension: [0, 'x'] }, 'tension'],
    [{ bias: [0, 1.01] }, 'bias'],
    [{ bias: 0.5 }, 'bias'],
    [{ turns: [{ key: 0, turns: 1 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: 0.5 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: 1, more: 1 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: 1, component: -1 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: 1, component: 0.5 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: 1, component: null }] }, 'turns'],
    [{ turns: [{ key: 2 ** 32 + 1, turns: 1 }] }, 'turns'],
    [{ turns: [{ key: 1, turns: -(2 ** 32) }] }, 'turns'],
    [{ inPlace: 1 }, 'inPlace'],
    [{ reference: -1 }, 'reference'],
    [{ reference: 1.5 }, 'reference'],
    [{ patches: 1e10 }, 'patches'],
    [{ stretch: 'cubic' }, 'stretch'],
    [{ precision: 32 }, 'precision'],
    [{ startTangent: [1, 2, 3] }, 'startTangent'],
  ])('of a sequence refuse %j', (options, name) => {
    expect(refusal(() => checkSequenceOptions(options))).toContain(`'${name}'`);
  });

  it.each<[object, string]>([
    [{ frames: 1 }, 'frames'],
    [{ range: [1, 1] }, 'range'],
    [{ range: [0, 1, 2] }, 'range'],
    [{ times: [] }, 'times'],
    [{ duration: -1 }, 'duration'],
    [{ format: 'fbx' }, 'format'],
    [{ pose: 'now' }, 'pose'],
  ])('of an export refuse %j', (options, name) => {
    expect(refusal(() => checkExportOptions(options))).toContain(`'${name}'`);
  });

  it.each<[object, string]>([
    [{ animation: -1 }, 'animation'],
    [{ animation: 2 ** 32 }, 'animation'],
    [{ sample: 1 }, 'sample'],
    [{ sample: 2 ** 32 + 2 }, 'sample'],
    [{ sample: [0, 0] }, 'sample'],
    [{ keyTimes: [0, Infinity] }, 'keyTimes'],
    [{ up: 'x' }, 'up'],
    [{ unit: 0 }, 'unit'],
  ])('of an import refuse %j', (options, name) => {
    expect(refusal(() => checkImportOptions(options))).toContain(`'${name}'`);
  });

  it('that are whole numbers say which of their bounds was missed', () => {
    expect(refusal(() => checkSequenceOptions({ patches: -1 }))).toContain('at least 0.');
    expect(refusal(() => checkSequenceOptions({ patches: 2 ** 31 }))).toContain('at most 2147483647.');
  });

  it('of an update keep what is not changed, and refuse what needs a new encoding', () => {
    const present = { ...MOTION_DEFAULTS, boundary: 'hermite' as const };
    expect(checkUpdate(present, { startSpeed: 0, keyTimes: [0, 2] })).toEqual({
      motion: { ...present, startSpeed: 0 },
      keyTimes: [0, 2],
    });
    expect(refusal(() => checkUpdate(present, { stretch: 'log' }))).toContain("'stretch'");
    expect(refusal(() => checkUpdate(present, { keyTimes: [0, NaN] }))).toContain("'keyTimes'");
  });
});
