import { describe, expect, it } from 'vitest';
import { checkBytes, exportWarnings, framesOf } from '../../../web/engine/caller/export-plan.ts';
import { EXPORT_DEFAULTS } from '../../../web/engine/api/types.ts';

const keys = [0, 0.4, 1];
const plan = (options: object) => framesOf({ ...EXPORT_DEFAULTS, ...options }, keys, [0, 1]);

describe('the times of an export', () => {
  it('are the grid united with the keys, shifted to start at 0', () => {
    const { times, seconds, stills } = plan({ frames: 4, range: [-0.5, 1] });
    expect(times).toEqual([-0.5, 0, 0.4, 0.5, 1]);
    expect(seconds).toEqual([0, 0.5, 0.9, 1, 1.5].map(Math.fround));
    expect(stills).toEqual([]);
  });

  it('are scaled to the duration', () => {
    const { seconds } = plan({ frames: 3, duration: 10 });
    expect(seconds).toEqual([0, 4, 5, 10]);
  });

  it('hold each key once, with its own exact time, even where the grid rounds', () => {
    const third = 1 / 3;
    const { times } = framesOf({ ...EXPORT_DEFAULTS, frames: 4 }, [0, third + 1e-16, 1], [0, 1]);
    expect(times).toHaveLength(4);
    expect(times).toContain(third + 1e-16);
  });

  it('leave keys outside the range to the stills', () => {
    expect(plan({ frames: 2, range: [0.2, 0.6] })).toEqual({
      times: [0.2, 0.4, 0.6],
      seconds: [0, 0.2, 0.4].map(Math.fround),
      stills: [0, 1],
    });
  });

  it('that are asked for one by one are sorted for a GLB and left as they are for OBJ files', () => {
    expect(plan({ times: [1.3, -0.3] }).times).toEqual([-0.3, 0, 0.4, 1, 1.3]);
    expect(plan({ times: [1.3, -0.3], format: 'obj' }).times).toEqual([1.3, -0.3]);
    expect(plan({ frames: 3, format: 'obj' }).times).toEqual([0, 0.5, 1]);
  });

  it('of one pose are that time', () => {
    expect(plan({ pose: 0.3 }).times).toEqual([0.3]);
    expect(plan({ times: [0.3] }).times).toEqual([0.3]);
  });

  it('are refused where float32 cannot tell them apart', () => {
    expect(() => plan({ frames: 3, range: [0, 1e9], duration: 1e-40 })).toThrow(/too close together/);
  });

  it('are refused where the file would not open again', () => {
    expect(plan({ frames: 3999, range: [1, 2] }).times).toHaveLength(3999); // and two stills
    expect(() => plan({ frames: 4000, range: [1, 2] })).toThrow(
      'its 4,001 morph targets need more than 16,000,000 weights',
    );
    expect(plan({ frames: 9000, format: 'obj' }).times).toHaveLength(9000);
    expect(() => checkBytes(EXPORT_DEFAULTS, 2 ** 31 - 1)).not.toThrow();
    expect(() => checkBytes(EXPORT_DEFAULTS, 2.6e9)).toThrow('The file would be 2.6 GB and could not be opened again');
    expect(() => checkBytes({ ...EXPORT_DEFAULTS, format: 'obj' }, 1e10)).not.toThrow();
  });

  it('draw a warning beyond 256 morph targets only', () => {
    const warned = (frames: number) =>
      exportWarnings(EXPORT_DEFAULTS, plan({ frames, range: [1, 2] })).map(({ code }) => code);
    expect(warned(255)).toEqual([]); // 255 frames and 2 stills are a mesh and 256 targets
    expect(warned(256)).toEqual(['many-targets']);
  });
});
