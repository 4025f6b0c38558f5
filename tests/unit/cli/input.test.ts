import { describe, expect, it } from 'vitest';
import { isBelow, libraryNames, namedIn, withoutOptions } from '../../../web/cli/input.ts';

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

describe('files named by an OBJ and its materials', () => {
  it('are the rest of a line after its keyword, each once', () => {
    const text = 'mtllib a.mtl\r\n# mtllib no.mtl\nmtllibs no.mtl\n\tmtllib\tb c.mtl  \nmtllib a.mtl\nmtllib\nmtllib  ';
    expect(namedIn(bytes(text), 'mtllib')).toEqual(['a.mtl', 'b c.mtl']);
  });

  it.each([
    ['a.mtl b.mtl', [], ['a.mtl', 'b.mtl']],
    ['my paint.mtl\tother.MTL', [], ['my paint.mtl', 'other.MTL']],
    ['my paint.mtl', ['my paint.mtl'], ['my paint.mtl']],
    ['paint library', ['paint', 'library'], ['paint', 'library']],
    ['not there', [], ['not there']],
  ])('of a line of libraries %j, where %j are files, are %j', async (text, files, names) => {
    expect(await libraryNames(text, (name) => Promise.resolve(files.includes(name)))).toEqual(names);
  });

  it('can continue on the next lines', async () => {
    const [line = ''] = namedIn(bytes('mtllib a.mtl \\ \r\n b.mtl\\\nc.mtl\nv 0 0 0\n'), 'mtllib');
    expect(await libraryNames(line, () => Promise.resolve(false))).toEqual(['a.mtl', 'b.mtl', 'c.mtl']);
  });

  it.each([
    ['a.png', 'a.png'],
    ['dark red.png', 'dark red.png'],
    ['-s 1 1 1 -clamp on dark red.png', 'dark red.png'],
    ['-o -0.5 .5 +1 a.png', 'a.png'],
    ['-bm 1 2.png', '2.png'],
    ['-clamp off on.png', 'on.png'],
    ['-a.png', '-a.png'],
    ['-s 1', '1'],
  ])('of an image %j is %j', (text, name) => {
    expect(withoutOptions(text)).toBe(name);
  });

  it('are found quickly, also in long lines of spaces, options and numbers', () => {
    const long = 300_000;
    expect(namedIn(bytes(`mtllib ${' '.repeat(long)}x`), 'mtllib')).toEqual(['x']);
    expect(namedIn(bytes(`map_Kd${' '.repeat(long)}`), 'map_Kd')).toEqual([]);
    expect(namedIn(bytes(`${' '.repeat(long)}map_Kd`), 'map_Kd')).toEqual([]);
    expect(withoutOptions(`-s ${'1 '.repeat(long)}x`)).toBe('x');
    expect(withoutOptions(`-s ${'1 '.repeat(long)}-`)).toBe('-');
    expect(withoutOptions(`${'-s '.repeat(long)}`)).toBe('');
    expect(withoutOptions(`-s${' '.repeat(long)}`)).toBe('');
  });
});

describe('a file', () => {
  it.each([
    ['/', '/a.bin', true],
    ['/', '/b/a.bin', true],
    ['/b', '/b/a.bin', true],
    ['/b', '/b', false],
    ['/b', '/bc/a.bin', false],
    ['/b', '/a.bin', false],
  ])('of the folder %s is %s: %s', (folder, file, below) => {
    expect(isBelow(folder, file)).toBe(below);
  });
});
