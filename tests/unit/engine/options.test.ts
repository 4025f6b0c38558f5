import { describe, expect, it } from 'vitest';
import { EngineError } from '../../../web/engine/api/errors.ts';
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, optionsIn } from '../../../web/engine/api/option-table.ts';
import {
  checkCall,
  checkExportOptions,
  checkImportOptions,
  checkSequenceOptions,
  checkTime,
  checkTimes,
  checkUpdate,
  validationError,
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

const NAMELESS = { name: '', nodeName: '', meshName: '', path: '' };

/** Changes every number and text inside. */
function spoil(value: object): void {
  for (const [key, one] of Object.entries(value))
    if (typeof one === 'object') spoil(one);
    else (value as Record<string, unknown>)[key] = typeof one === 'number' ? one + 1 : 'spoilt';
}

describe('options', () => {
  it('are the defaults if not given', () => {
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

  it('with unknown names are refused, with the name', () => {
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
    [{ startSpeed: 1e308 }, 'startSpeed'],
    [{ endSpeed: -1e6 }, 'endSpeed'],
    [{ period: 1e308 }, 'period'],
    [{ tension: [1e308, 0] }, 'tension'],
    [{ turns: [{ key: 1, turns: 101 }] }, 'turns'],
    [{ patches: 1e6 }, 'patches'],
    [{ ghostFaces: 2e9 }, 'ghostFaces'],
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
    [{ pose: 1e300 }, 'pose'],
    [{ frames: 1e9 }, 'frames'],
    [{ times: [1e308] }, 'times'],
    [{ range: [1e308, 1.7e308] }, 'range'],
    [{ duration: 1e308 }, 'duration'],
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
    [{ unit: 1e300 }, 'unit'],
    [{ sample: 1e6 }, 'sample'],
    [{ sample: [0, 1e300] }, 'sample'],
    [{ keyTimes: [0, 1e10] }, 'keyTimes'],
  ])('of an import refuse %j', (options, name) => {
    expect(refusal(() => checkImportOptions(options))).toContain(`'${name}'`);
  });

  it('of many times are refused, with their number', () => {
    const many = (count: number): number[] => Array.from({ length: count }, (_, i) => i);
    expect(refusal(() => checkExportOptions({ times: many(100_001) }))).toContain("'times' must be at most 100,000");
    expect(refusal(() => checkImportOptions({ sample: many(10_001) }))).toContain("'sample' must be at most 10,000");
    expect(refusal(() => checkImportOptions({ keyTimes: many(10_001) }))).toContain('not 10,001');
  });

  it('that are whole numbers are refused with the violated bound', () => {
    const sentence = "The sequence option 'patches' must be a whole number from 0 to 100,000.";
    expect(refusal(() => checkSequenceOptions({ patches: -1 }))).toBe(sentence);
    expect(refusal(() => checkSequenceOptions({ patches: 2 ** 31 }))).toBe(sentence);
    // The core adds 1 to an index in its message.
    expect(refusal(() => checkSequenceOptions({ reference: 2 ** 31 - 1 }))).toContain('at most 2,147,483,646.');
  });

  it('that are numbers have a minimum and a maximum', () => {
    for (const [name, option] of [ENCODING, MOTION, PER_KEY, IMPORT, EXPORT].flatMap(optionsIn)) {
      if (option.kind !== 'number') continue;
      for (const value of [-1e300, 1e300]) expect(validationError(option, value), name).not.toBeNull();
    }
  });

  it('are distinguishable times', () => {
    expect(refusal(() => checkTime(1e300))).toContain('from -1,000,000,000 to 1,000,000,000');
    expect(refusal(() => checkTimes([0, -1e300]))).toContain('from -1,000,000,000 to 1,000,000,000');
    expect([checkTime(-1e9), checkTimes([1e9])]).toEqual([-1e9, [1e9]]);
  });

  it.each([
    [checkSequenceOptions, { tension: [0, 1], bias: [0, 1], turns: [{ key: 1, turns: 1 }] }],
    [checkSequenceOptions, { pins: [{ vertex: 1, radius: 0.1, stay: 1, path: [{ time: 0, move: [1, 2, 3] }] }] }],
    [checkSequenceOptions, { startTangent: Float32Array.of(1, 2, 3), endTangent: Float32Array.of(1, 2, 3) }],
    [checkImportOptions, { keyTimes: [0, 1], sample: [0, 1], objects: ['a'], offset: [1, 2, 3] }],
    [checkImportOptions, { like: Uint32Array.of(0, 1, 2), likePose: Float32Array.of(1, 2, 3) }],
    [checkImportOptions, { likeObjects: [{ ...NAMELESS, start: 0, count: 1, isGroup: false }] }],
    [checkExportOptions, { times: [0, 1], range: [0, 1], blend: [0, 1] }],
    [(given: object) => checkUpdate(MOTION_DEFAULTS, given), { keyTimes: [0, 1] }],
  ])('stay as they were when they were checked: %s %j', (check, given) => {
    const before = structuredClone(check(given));
    const checked = check(given);
    spoil(given);
    expect(checked).toEqual(before);
  });

  it('of an update keep the other options, and refuse those that need a new encoding', () => {
    const present = { ...MOTION_DEFAULTS, boundary: 'hermite' as const };
    expect(checkUpdate(present, { startSpeed: 0, keyTimes: [0, 2] })).toEqual({
      motion: { ...present, startSpeed: 0 },
      keyTimes: [0, 2],
    });
    expect(refusal(() => checkUpdate(present, { stretch: 'log' }))).toContain("'stretch'");
    expect(refusal(() => checkUpdate(present, { keyTimes: [0, NaN] }))).toContain("'keyTimes'");
  });
});
