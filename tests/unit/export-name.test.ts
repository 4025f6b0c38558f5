/** Names of exported files and of the animation in them. */
import { describe, expect, it } from 'vitest';
import { clipName } from '../../web/engine/api/clip-name.ts';
import type { KeysInfo } from '../../web/engine/api/types.ts';
import { exportName, safeName } from '../../web/ui/export-name.ts';

const clips = (animation: number, names: string[], project: object | null = null, objects: string[] = []) =>
  ({ animation, animations: names.map((name) => ({ name })), project, objects }) as unknown as KeysInfo;
const own = (...names: string[]) => ({ kind: 'files', names }) as const;

describe('names of an export', () => {
  it('the animation keeps the name in its file, also when its export is opened again', () => {
    expect([clipName(clips(1, ['walk', 'run'])), clipName(clips(-1, ['walk']))]).toEqual(['run', null]);
    expect([clipName(clips(0, ['animation 0'])), clipName(clips(0, [''])), clipName(clips(-1, []))]).toEqual([
      ...[null, null, null],
    ]);
    expect(clipName(clips(-1, ['run'], {}, ['Xbot-run']))).toBe('run');
    expect(clipName(clips(-1, ['bar-motion'], {}, ['bar-motion']))).toBeNull();
  });

  it('a file is named after its files and the animation', () => {
    expect(exportName(own('models/Xbot.glb'), clips(1, ['walk', 'run']))).toBe('Xbot-run');
    expect(exportName(own('Xbot.glb'), clips(0, ['Armature|walk: a/b']))).toBe('Xbot-Armature-walk- ab');
    expect(exportName(own('Xbot-run.glb'), clips(-1, ['run'], {}, ['Xbot-run']))).toBe('Xbot-run');
  });

  it('a file of poses, or one named like its animation, gets a suffix and does not replace the original', () => {
    expect(exportName(own('a.obj', 'b.obj'), clips(-1, []))).toBe('a-motion');
    expect(exportName(own('run.glb'), clips(0, ['run']))).toBe('run-motion');
    expect(exportName(own('Xbot-run.glb'), clips(0, ['run']))).toBe('Xbot-run-motion');
    expect(exportName(own('a-motion.glb'), clips(-1, ['a-motion'], {}, ['a-motion']))).toBe('a-motion');
    expect(exportName({ kind: 'sample', id: 'stroll' }, clips(0, ['walk']))).toBe('stroll');
  });

  it('characters that file systems refuse are replaced', () => {
    expect(safeName('a/b\\c:d*e?.\u0085')).toBe('abc-d-e-.');
  });
});
