import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { describe, expect, it, onTestFinished } from 'vitest';
import { isBelow, libraryNames, namedIn, readInputs, withoutOptions } from '../../../web/cli/input.ts';

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

describe('files named by an OBJ and its materials', () => {
  it('are the rest of a line after its keyword, each once', () => {
    const text = 'mtllib a.mtl\r\n# mtllib no.mtl\nmtllibs no.mtl\n\tmtllib\tb c.mtl  \nmtllib a.mtl\nmtllib\nmtllib  ';
    expect(namedIn(bytes(text), 'mtllib')).toEqual(['a.mtl', 'b c.mtl']);
    expect(namedIn(bytes('\ufeffMTLLIB a.mtl\rv 0 0 0\r\tMtlLib b.mtl'), 'mtllib')).toEqual(['a.mtl', 'b.mtl']);
  });

  it.each([
    ['a.obj', 'mtllib C:\\mats\\my a.mtl', 'my a.mtl', 'Map_Kd -s 1 1 1 D:\\tex\\skin.png'],
    ['a.OBJ', 'MTLLIB ./my a.mtl', 'my a.mtl', 'map_kd /home/me/skin.png'],
    ['a', 'mtllib ../my a.mtl', 'my a.mtl', 'map_Kd ..\\..\\skin.png'],
    ['a.obj.txt', 'mtllib a.mtl', 'a.mtl', 'map_Kd skin.png'],
  ])('are read beside %s, also from its end: %s', async (name, library, file, image) => {
    const folder = await mkdtemp(path.join(tmpdir(), 'input-'));
    onTestFinished(() => rm(folder, { recursive: true }));
    await writeFile(path.join(folder, name), `${'v 0 0 0\n'.repeat(20_000)}f 1 2 3\n${library}`);
    await writeFile(path.join(folder, file), `newmtl a\n${image}\n`);
    await writeFile(path.join(folder, 'skin.png'), '');
    const read = await readInputs([path.join(folder, name)]);
    expect(read.map((one) => path.basename(one.name))).toEqual([name, file, 'skin.png']);
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
    expect(namedIn(bytes(`map_Kd${' '.repeat(long)}`), 'map_kd')).toEqual([]);
    expect(namedIn(bytes(`${' '.repeat(long)}map_Kd`), 'map_kd')).toEqual([]);
    expect(namedIn(bytes('mtllib \\\n'.repeat(long)), 'mtllib').length).toBeGreaterThan(0);
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
