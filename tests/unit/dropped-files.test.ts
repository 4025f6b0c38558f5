import { describe, expect, it } from 'vitest';
import { droppedFiles, filesOf, leadingName } from '../../web/ui/dropped-files.ts';

type Tree = { [name: string]: Tree | string | null };

const BATCH = 100;

/** A folder as in browsers: at most a hundred entries per call, with callbacks. null is unreadable. */
function entry(name: string, content: Tree | string | null): FileSystemEntry {
  const later = <T>(value: T | null, resolve: (value: T) => void, reject: (error: Error) => void): void => {
    setTimeout(() => (value === null ? reject(new Error('NotFoundError')) : resolve(value)), 0);
  };
  const isFile = typeof content === 'string' || name.endsWith('.obj');
  if (isFile) {
    const file = content === null ? null : new File([content as string], name);
    return {
      name,
      isFile: true,
      isDirectory: false,
      file: (resolve: (f: File) => void, reject: () => void) => later(file, resolve, reject),
    } as unknown as FileSystemEntry;
  }
  const createReader = (): object => {
    const left = content === null ? null : Object.entries(content).map(([child, inside]) => entry(child, inside));
    return {
      readEntries: (resolve: (e: FileSystemEntry[]) => void, reject: () => void) =>
        later(left?.splice(0, BATCH) ?? null, resolve, reject),
    };
  };
  return { name, isFile: false, isDirectory: true, createReader } as unknown as FileSystemEntry;
}

const entries = (tree: Tree): FileSystemEntry[] => Object.entries(tree).map(([name, content]) => entry(name, content));
const namesIn = async (tree: Tree): Promise<string[]> => (await filesOf(entries(tree))).map(({ name }) => name);

describe('dropped files and folders', () => {
  it('are read with paths from the top folder', async () => {
    const tree = {
      wolf: { 'wolf-1.obj': 'v', parts: { 'wolf.mtl': 'newmtl', deep: { 'skin.png': 'png' } } },
      'wolf-2.obj': 'v',
    };
    const files = await filesOf(entries(tree));
    expect(files.map(({ name }) => name)).toEqual([
      'wolf/wolf-1.obj',
      'wolf/parts/wolf.mtl',
      'wolf/parts/deep/skin.png',
      'wolf-2.obj',
    ]);
    expect(await files[1]!.file.text()).toBe('newmtl');
  });

  it('are read completely, with any number of files in a folder', async () => {
    const poses = Object.fromEntries(Array.from({ length: 350 }, (_, i) => [`pose-${i}.ply`, 'ply']));
    expect(await namesIn({ poses })).toHaveLength(350);
  });

  it('exclude other files of folders, but no single file', async () => {
    const folder = {
      'a.GLB': '',
      '._a.glb': '',
      '.DS_Store': '',
      'notes.docx': '',
      'a.blend': '',
      Makefile: '',
      'b.Ply': '',
    };
    expect(await namesIn({ folder, 'c.blend': '' })).toEqual(['folder/a.GLB', 'folder/b.Ply', 'c.blend']);
  });

  it('are refused with a message if there is no model, too much data, or nothing readable', async () => {
    await expect(namesIn({ photos: { 'readme.pdf': '', more: {} } })).rejects.toThrow('There is no model in photos.');
    const many = Object.fromEntries(Array.from({ length: 20_001 }, (_, i) => [`${i}.txt`, '']));
    await expect(namesIn({ many })).rejects.toThrow('More than 20,000 files');
    await expect(namesIn({ locked: { inside: null } })).rejects.toThrow('locked/inside could not be read.');
    await expect(namesIn({ folder: { 'gone.obj': null } })).rejects.toThrow('folder/gone.obj could not be read.');
  });

  it('are named after the first model', () => {
    expect(leadingName(['a/paint.mtl', 'a/paint.png', 'a/Wolf.OBJ', 'a/wolf-2.obj'])).toBe('a/Wolf.OBJ');
    expect([leadingName(['walk.glb']), leadingName(['odd.xyz']), leadingName([])]).toEqual(['walk.glb', 'odd.xyz', '']);
  });

  it('are plain files if the browser does not support entries, or without a folder', async () => {
    const files = [new File(['a'], 'a.obj'), new File(['b'], 'b.obj')];
    const bare = { items: [{}, {}], files } as unknown as DataTransfer;
    const flat = {
      items: files.map(({ name }) => ({ webkitGetAsEntry: () => entry(name, '') })),
      files,
    } as unknown as DataTransfer;
    for (const transfer of [bare, flat]) expect((await droppedFiles(transfer)).map(({ file }) => file)).toEqual(files);
    const folder = {
      items: [{ webkitGetAsEntry: () => entry('poses', { 'a.ply': '' }) }],
      files,
    } as unknown as DataTransfer;
    expect((await droppedFiles(folder)).map(({ name }) => name)).toEqual(['poses/a.ply']);
  });
});
