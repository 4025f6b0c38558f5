import { describe, expect, it } from 'vitest';
import { readNote, withNote } from '../../../web/engine/api/export-note.ts';

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);
const text = (of: Uint8Array): string => new TextDecoder().decode(of);

const OBJ = 'mtllib a.mtl\nv 0 0 0\n';
const PLY = 'ply\nformat binary_little_endian 1.0\nelement vertex 0\nend_header\n';

describe('the note in an exported file', () => {
  it('is in comments: at the start of an OBJ, in the header of a PLY', () => {
    expect(text(withNote('obj', bytes(OBJ), [0.25]))).toBe(`# shapespline: Y up, metres\n# times 0.25\n${OBJ}`);
    expect(text(withNote('ply', bytes(PLY), []))).toBe(
      PLY.replace('1.0\n', '1.0\ncomment shapespline: Y up, metres\n'),
    );
    expect(withNote('glb', bytes('glTF'), [1])).toEqual(bytes('glTF'));
  });

  it.each([[[0.5]], [[0, 0.1, 0.7]], [[-1, 2]], [[0, 1 / 3, 2 / 3, 1]], [[1, 0.5, 0.25]]])(
    'are the times %j',
    (times) => {
      for (const [format, file] of [
        ['obj', OBJ],
        ['ply', PLY],
      ] as const) {
        const read = readNote(withNote(format, bytes(file), times))?.times;
        expect(read).toHaveLength(times.length);
        times.forEach((t, i) => expect(read![i]).toBeCloseTo(t, 12));
      }
    },
  );

  it('is short, also for many frames', () => {
    const times = Array.from({ length: 90_000 }, (_, i) => 3 + (2 * i) / 89_999);
    const noted = withNote('obj', bytes(OBJ), times);
    expect(noted.length).toBeLessThan(150);
    expect(readNote(noted)!.times).toHaveLength(90_000);
  });

  it('lists any number of uneven times, on lines of less than 64 kB', () => {
    for (const count of [1000, 3500, 4001, 20_000]) {
      const times = Array.from({ length: count }, (_, i) => 2 * (i / (count - 1)) ** 1.3 - 1 / 3);
      for (const [format, file] of [
        ['obj', OBJ],
        ['ply', PLY],
      ] as const) {
        const noted = withNote(format, bytes(file), times);
        expect(readNote(noted)!.times).toEqual(times);
        expect(
          Math.max(
            ...text(noted)
              .split('\n')
              .map((line) => line.length),
          ),
        ).toBeLessThan(16_000);
      }
    }
    const before = `# shapespline: Y up, metres\n# times ${Array.from({ length: 4000 }, (_, i) => i + 1 / 3).join(' ')}\n`;
    expect(readNote(bytes(before + OBJ))!.times).toHaveLength(4000);
  });

  it('is ignored in any other form', () => {
    expect(readNote(bytes(OBJ))).toBeNull();
    expect(readNote(bytes('# shapespline: Y up, metres\n# times 0 x 1\n'))).toEqual({ times: null });
    expect(readNote(bytes('# shapespline: Y up, metres\n# frames 999999999 from 0 to 1\n'))).toEqual({ times: null });
  });
});
