import { describe, expect, it } from 'vitest';
import {
  checkBytes,
  choicesOf,
  exportWarnings,
  frameWarnings,
  framesOf,
  isThinned,
} from '../../../web/engine/caller/export-plan.ts';
import { EXPORT_DEFAULTS } from '../../../web/engine/api/types.ts';

const keys = [0, 0.4, 1];
const plan = (options: object) => framesOf({ ...EXPORT_DEFAULTS, ...options }, keys, [0, 1]);

describe('the times of an export', () => {
  it('are the union of the grid and the keys, shifted to start at 0', () => {
    const { times, seconds, stills } = plan({ frames: 4, range: [-0.5, 1] });
    expect(times).toEqual([-0.5, 0, 0.4, 0.5, 1]);
    expect(seconds).toEqual([0, 0.5, 0.9, 1, 1.5].map(Math.fround));
    expect(stills).toEqual([]);
  });

  it('are scaled to the duration', () => {
    const { seconds } = plan({ frames: 3, duration: 10 });
    expect(seconds).toEqual([0, 4, 5, 10]);
  });

  it('include each key once, with its exact time, also where the grid rounds', () => {
    const third = 1 / 3;
    const { times } = framesOf({ ...EXPORT_DEFAULTS, frames: 4 }, [0, third + 1e-16, 1], [0, 1]);
    expect(times).toHaveLength(4);
    expect(times).toContain(third + 1e-16);
  });

  it('store keys outside the range as stills', () => {
    expect(plan({ frames: 2, range: [0.2, 0.6] })).toEqual({
      times: [0.2, 0.4, 0.6],
      seconds: [0, 0.2, 0.4].map(Math.fround),
      stills: [0, 1],
    });
  });

  it('are stored in an MDD, without added keys', () => {
    expect(plan({ frames: 3, format: 'mdd' }).seconds).toEqual([0, 0.5, 1]);
    expect(plan({ frames: 3, format: 'mdd', duration: 4, range: [1, 2] }).seconds).toEqual([0, 2, 4]);
    expect(plan({ frames: 3, format: 'pc2' }).seconds).toEqual([0, 0, 0]);
  });

  it('given as a list are sorted for a GLB and unchanged for OBJ files', () => {
    expect(plan({ times: [1.3, -0.3] }).times).toEqual([-0.3, 0, 0.4, 1, 1.3]);
    expect(plan({ times: [1.3, -0.3], format: 'obj' }).times).toEqual([1.3, -0.3]);
    expect(plan({ frames: 3, format: 'obj' }).times).toEqual([0, 0.5, 1]);
  });

  it('of one pose are its time', () => {
    expect(plan({ pose: 0.3 }).times).toEqual([0.3]);
    expect(plan({ times: [0.3] }).times).toEqual([0.3]);
  });

  it('are refused if they are equal in float32', () => {
    expect(() => plan({ frames: 3, range: [0, 1e9], duration: 1e-40 })).toThrow(/too close together/);
  });

  it('are refused if the file would not open again', () => {
    expect(plan({ frames: 3999, range: [1, 2] }).times).toHaveLength(3999); // the plan also has two stills
    expect(() => plan({ frames: 4000, range: [1, 2] })).toThrow(
      'its 4,001 morph targets need more than 16,000,000 weights',
    );
    expect(plan({ frames: 9000, format: 'obj' }).times).toHaveLength(9000);
    expect(() => checkBytes(EXPORT_DEFAULTS, 2 ** 31 - 1)).not.toThrow();
    expect(() => checkBytes(EXPORT_DEFAULTS, 2.6e9)).toThrow(
      'The file would be 2.6 GB, but a GLB can have at most 2.1 GB',
    );
    expect(() => checkBytes({ ...EXPORT_DEFAULTS, format: 'obj' }, 1e10)).not.toThrow();
  });

  it('are whole frames of the motion, or of an exported animation with its own duration', () => {
    expect(plan({ fps: 4, format: 'obj' }).times).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(plan({ fps: 4, range: [0.1, 0.8], format: 'obj' }).times).toEqual([0.1, 0.25, 0.5, 0.75, 0.8]);
    const { times, seconds } = plan({ fps: 2, duration: 2, range: [0.5, 1], tolerance: 0 });
    expect(times).toEqual([0.5, 0.625, 0.75, 0.875, 1]);
    expect(seconds).toEqual([0, 0.5, 1, 1.5, 2]);
    expect(plan({ fps: 4 }).times).toEqual([0, 0.25, 0.4, 0.5, 0.75, 1]); // the key at 0.4 is not on the grid
    expect(plan({ fps: 0.5, format: 'pc2' }).times).toEqual([0, 1]);
    expect(plan({ fps: 3, duration: 0.7, tolerance: 0 }).seconds.at(-1)).toBe(Math.fround(0.7));
    expect(() => plan({ fps: 4, range: [1, 1] })).toThrow('The range has no length');
    expect(() => plan({ fps: 1000, range: [0, 1e6] })).toThrow('1,000,000,001 frames');
  });
});

describe('what an export leaves out', () => {
  const isThin = (options: object): boolean => isThinned({ ...EXPORT_DEFAULTS, ...options });

  it('is limited by the tolerance, in a GLB without requested times', () => {
    expect(isThin({})).toBe(true);
    expect(isThin({ fps: 24 })).toBe(true);
    expect([{ tolerance: 0 }, { frames: 60 }, { times: [0, 1] }, { pose: 0.5 }, { format: 'pc2' }].map(isThin)).toEqual(
      Array(5).fill(false),
    );
    expect(isThin({ tolerance: 0, targets: 'principal' })).toBe(true);
    expect(isThin({ frames: 60, targets: 'principal' })).toBe(false);
  });

  it('is never a key or an end of the range', () => {
    const choices = (options: object) => choicesOf({ ...EXPORT_DEFAULTS, ...options }, keys, [0, 1]);
    expect(choices({})).toEqual({ corners: [0, 0.4, 1], grid: null });
    expect(choices({ range: [0.2, 1.5] })).toEqual({ corners: [0.2, 0.4, 1, 1.5], grid: null });
    expect(choices({ fps: 4 })).toEqual({ corners: [0, 0.4, 1], grid: [0, 0.25, 0.5, 0.75, 1] });
  });
});

describe('the warning about the size', () => {
  const warned = (targets: number, vertices: number) => exportWarnings(EXPORT_DEFAULTS, targets, vertices);

  it('counts the memory of players, not the targets', () => {
    expect(warned(1000, 5000)).toEqual([]);
    const [warning] = warned(240, 84_000);
    expect(warning?.code).toBe('heavy-animation');
    expect(warning?.message).toContain('645 MB of graphics memory in three.js and Babylon.js');
    expect(warning?.message).toContain('242 MB in Blender');
    expect(exportWarnings({ ...EXPORT_DEFAULTS, format: 'obj' }, 1000, 1e6)).toEqual([]);
  });

  it('gives the number of targets if a texture has fewer layers', () => {
    expect(warned(2048, 8)).toEqual([]);
    expect(warned(2049, 8).map(({ code }) => code)).toEqual(['many-targets']);
  });
});

describe('keys between whole frames', () => {
  const warned = (options: object, keyTimes: number[]): string[] =>
    frameWarnings({ ...EXPORT_DEFAULTS, fps: 10, ...options }, keyTimes, [0, keyTimes.at(-1)!]).map(
      ({ message }) => message,
    );

  it('are reported', () => {
    expect(warned({}, [0, 0.33, 1.07])).toEqual([
      expect.stringMatching(/keys 2, 3 are between whole frames, as extra/),
    ]);
    expect(warned({}, [0, 0.33, 1])).toEqual([expect.stringMatching(/key 2 is between whole frames, as extra/)]);
  });

  it('are not reported for keys on frames, also of the exported animation, or without whole frames', () => {
    expect(warned({}, [0, 0.3, 1])).toEqual([]);
    expect(warned({ duration: 2 }, [0, 0.25, 0.5])).toEqual([]);
    for (const other of [{ fps: null }, { frames: 5 }, { times: [0, 1] }, { pose: 0 }, { format: 'obj' }])
      expect(warned(other, [0, 0.33, 1.07])).toEqual([]);
  });
});
