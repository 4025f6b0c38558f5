/** Runs scripts in the real Blender and checks their reports. */
import { expect, it } from 'vitest';
import { describeBlender, runInBlender } from './blender.ts';

describeBlender('a script in Blender', () => {
  it('receives its arguments and returns a value, in an empty scene', async () => {
    const { version, ...rest } = await runInBlender<{ version: string }>('blender_version.py', {
      text: 'ä',
      list: [1],
    });
    expect(version).toMatch(/^4\.5/);
    expect(rest).toEqual({ objects: 0, asked: { text: 'ä', list: [1] } });
  });
});
