import { execFileSync, spawn } from 'node:child_process';
import {
  existsSync,
  linkSync,
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { build } from 'esbuild';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { addInputs } from '../../web/cli/input.ts';
import { KnownFiles } from '../../web/cli/known-files.ts';
import { checkOutputs, writeOutputs } from '../../web/cli/output.ts';
import { EngineError } from '../../web/engine/api/errors.ts';

let folder = '';
const at = (...names: string[]): string => path.join(folder, ...names);
const file = (place: string, bytes: string) => ({ flag: '--output', path: place, files: [{ name: place, bytes }] });
const frames = (place: string, ...names: string[]) => ({
  flag: '--output',
  path: `${place}/`,
  files: names.map((name) => ({ name, bytes: name })),
});
const listed = (): string[] => readdirSync(folder, { recursive: true, encoding: 'utf8' }).sort();

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'output-'));
});

afterEach(() => {
  rmSync(folder, { recursive: true, force: true });
});

describe('results', () => {
  it('are written into new folders and over files', async () => {
    writeFileSync(at('report.json'), 'old');
    await writeOutputs([frames(at('new/out'), 'a.obj', 'b.obj'), file(at('report.json'), 'new')]);
    expect(listed()).toEqual([
      'new',
      'new/out',
      'new/out/.shapespline.json',
      'new/out/a.obj',
      'new/out/b.obj',
      'report.json',
    ]);
    expect(readFileSync(at('report.json'), 'utf8')).toBe('new');
  });

  it('are written one by one, as they are made', async () => {
    const made = async function* () {
      for (const name of ['a.obj', 'b.obj', 'c.obj']) {
        yield { name, bytes: name };
        await expect.poll(() => listed().some((place) => place.endsWith(name))).toBe(true);
        expect(existsSync(at('out'))).toBe(false);
      }
    };
    await writeOutputs([{ flag: '--output', path: `${at('out')}/`, files: made() }]);
    expect(listed()).toEqual(['out', 'out/.shapespline.json', 'out/a.obj', 'out/b.obj', 'out/c.obj']);
  });

  it('that fail leave nothing behind, and report the failure', async () => {
    const made = async function* () {
      yield { name: 'a.obj', bytes: '' };
      await Promise.reject(new EngineError('out-of-memory', 'There is not enough memory.'));
    };
    await expect(writeOutputs([{ flag: '--output', path: `${at('out')}/`, files: made() }])).rejects.toThrow(
      /^There is not enough memory\.$/,
    );
    expect(listed()).toEqual([]);
  });

  it('are written to the target of a link, and the link stays', async () => {
    writeFileSync(at('real'), 'old');
    symlinkSync('real', at('link'));
    symlinkSync('later', at('dangling'));
    await writeOutputs([file(at('link'), 'new'), file(at('dangling'), 'made')]);
    expect(lstatSync(at('link')).isSymbolicLink()).toBe(true);
    expect(readFileSync(at('real'), 'utf8')).toBe('new');
    expect(lstatSync(at('dangling')).isSymbolicLink()).toBe(true);
    expect(readFileSync(at('later'), 'utf8')).toBe('made');
  });

  it('are written into devices and pipes, which are not replaced', async () => {
    execFileSync('mkfifo', [at('pipe')]);
    const reader = spawn('cat', [at('pipe')]);
    let read = '';
    reader.stdout.on('data', (chunk: Buffer) => {
      read += chunk.toString();
    });
    const ended = new Promise((resolve) => reader.on('close', resolve));
    await writeOutputs([file('/dev/null', 'nothing'), file(at('pipe'), 'through')]);
    await ended;
    expect(read).toBe('through');
    expect(lstatSync(at('pipe')).isFIFO()).toBe(true);
    expect(lstatSync('/dev/null').isCharacterDevice()).toBe(true);
    expect(readdirSync('/dev').filter((name) => name.startsWith('null'))).toEqual(['null']);
  });

  it.each([
    ['a report whose name is a folder', () => [frames(at('out'), 'a.obj'), file(at('taken'), '')], 'is a folder'],
    ['a frame whose name is a folder', () => [frames(folder, 'a.obj', 'taken')], 'is a folder'],
    ['two results in one place', () => [file(at('x.glb'), ''), file(at('x.glb'), '')], 'would be written to'],
    ['a report over a frame', () => [frames(at('out'), 'a.obj'), file(at('out/a.obj'), '')], 'would be written to'],
    ['a link that leads to itself', () => [frames(at('out'), 'a.obj'), file(at('round'), '')], 'is a link to itself'],
    [
      'a place below a file',
      () => [frames(at('out'), 'a.obj'), file(at('file/x.glb'), '')],
      'not a directory|ENOTDIR|EEXIST',
    ],
  ])('of which one cannot be written leave nothing behind: %s', async (_what, outputs, why) => {
    mkdirSync(at('taken'));
    writeFileSync(at('file'), '');
    symlinkSync('round', at('round'));
    const before = listed();
    await expect(writeOutputs(outputs())).rejects.toThrow(new RegExp(`^Cannot write the result \\(.*(${why})`));
    expect(listed()).toEqual(before);
  });

  it.each(['SIGINT', 'SIGTERM', 'SIGHUP'] as const)('interrupted by %s leave nothing behind', async (by) => {
    execFileSync('mkfifo', [at('pipe')]);
    const script = path.join(folder, 'script.mjs');
    await build({ entryPoints: ['web/cli/output.ts'], bundle: true, platform: 'node', format: 'esm', outfile: script });
    const outputs = JSON.stringify([frames(at('new/out'), 'a.obj'), file(at('pipe'), 'waits for a reader')]);
    const code = `const { writeOutputs } = await import(${JSON.stringify(script)}); await writeOutputs(${outputs});`;
    const before = listed();
    const writer = spawn(process.execPath, ['--input-type=module', '-e', code]);
    await expect.poll(() => listed().some((name) => name.endsWith('a.obj')), { timeout: 30_000 }).toBe(true);
    writer.kill(by);
    expect(await new Promise((resolve) => writer.on('close', (_code, signal) => resolve(signal)))).toBe(by);
    expect(listed()).toEqual(before);
  });
});

const put = (name: string, bytes: string): void => {
  mkdirSync(path.dirname(at(name)), { recursive: true });
  writeFileSync(at(name), bytes);
};
const text = (name: string): string => readFileSync(at(name), 'utf8');
const knownOf = async (names: string[], overwrite = false): Promise<KnownFiles> => {
  const known = new KnownFiles(overwrite);
  await addInputs(
    known,
    names.map((name) => at(name)),
  );
  return known;
};
/** Frames of a motion, which differ from those of another motion. */
const motion = (name: string, count: number) => ({
  flag: '--output',
  path: `${at(name)}/`,
  files: Array.from({ length: count }, (_, i) => ({ name: `000${i}.obj`, bytes: `${count} ${i}` })),
});
/** An output with files beside it. */
const group = (name: string, ...files: [name: string, bytes: string][]) => ({
  flag: '--output',
  path: at(name),
  files: [[path.basename(name), 'main'], ...files].map(([name = '', bytes = '']) => ({ name, bytes })),
});

describe('inputs', () => {
  const MTL = 'newmtl a\nmap_Kd -s 1 1 1 red paint.png\rMAP_BUMP ../bumps/b.png\r\nrefl c%20d.png\n';
  beforeEach(() => {
    put('in/a.obj', `# poses\nMTLLIB paint.mtl\nv 0 0 0\n`);
    put('in/paint.mtl', MTL);
    put('in/b.obj', `${'v 0 0 0\n'.repeat(20_000)}mtllib mtl/b.mtl\n`);
    put('in/mtl/b.mtl', 'map_Kd C:\\work\\far.png\nmap_Ks e\u0301.png\n');
    for (const name of ['far.png', 'mtl/\u00e9.png']) put(`in/${name}`, 'x');
    for (const name of ['red paint.png', '../bumps/b.png', 'c d.png', 's.bin', 't.png', 'u.png'])
      put(`in/${name}`, 'x');
    const json = (uri: string) => JSON.stringify({ buffers: [{ uri }], images: [{ uri: '../bumps/../in/t.png' }] });
    put('in/scene.gltf', json('s.bin'));
    const chunk = JSON.stringify({ images: [{ uri: 'u.png' }] });
    const glb = Buffer.alloc(20 + chunk.length);
    glb.write('glTF');
    glb.writeUInt32LE(chunk.length, 12);
    glb.write(chunk, 20);
    writeFileSync(at('in/packed.glb'), glb);
    put(
      'in/scan.ply',
      'ply\r\nformat ascii 1.0\r\ncomment TextureFile the skin.jpg\r\nelement vertex 0\r\nend_header\r\n',
    );
    put('in/the skin.jpg', 'x');
    symlinkSync('a.obj', at('in/link.obj'));
    linkSync(at('in/a.obj'), at('in/second name.obj'));
    mkdirSync(at('poses'));
    put('poses/1.obj', 'v 0 0 0');
  });
  const given = ['in/a.obj', 'in/b.obj', 'in/scene.gltf', 'in/packed.glb', 'in/scan.ply', 'poses'];

  it.each([
    ['in/a.obj', 'is one of the inputs'],
    ['in/link.obj', 'is one of the inputs'],
    ['in/second name.obj', 'is one of the inputs'],
    ['poses/1.obj', 'is one of the inputs'],
    ...['paint.mtl', 'red paint.png', 'c d.png'].map((name) => [`in/${name}`, 'belongs to the input .*a.obj']),
    ...['mtl/b.mtl', 'far.png', 'mtl/\u00e9.png'].map((name) => [`in/${name}`, 'belongs to the input .*b.obj']),
    ['bumps/b.png', 'belongs to the input .*paint.mtl|a.obj'],
    ...['s.bin', 't.png'].map((name) => [`in/${name}`, 'belongs to the input .*scene.gltf']),
    ['in/u.png', 'belongs to the input .*packed.glb'],
    ['in/the skin.jpg', 'belongs to the input .*scan.ply'],
  ])('are not written over: %s', async (name, why) => {
    const outputs = [{ ...file(at(name), 'new'), flag: '--report' }];
    const before = text(name);
    for (const attempt of [checkOutputs, writeOutputs])
      await expect(attempt(outputs, await knownOf(given))).rejects.toThrow(new RegExp(`${why}.*Give --report another`));
    expect(text(name)).toBe(before);
    const named = why.startsWith('is one');
    const overwritten = writeOutputs(outputs, await knownOf(given, true));
    await (named ? overwritten : expect(overwritten).rejects.toThrow(/belongs to/));
    expect(text(name)).toBe(named ? 'new' : before);
  });

  it('are not replaced by a file beside an output, nor by frames, whatever is allowed', async () => {
    const known = await knownOf(given, true);
    await expect(writeOutputs([group('in/a.pc2', ['a.obj', 'new'])], known)).rejects.toThrow(
      /a.obj is one of the inputs/,
    );
    const early = [{ flag: '--output', path: at('in/a.pc2'), beside: ['a.obj'] }];
    await expect(checkOutputs(early, known)).rejects.toThrow(/a.obj is one of the inputs/);
    await writeOutputs([motion('fr', 4)]);
    for (const frame of ['fr/0000.obj', 'fr/0003.obj'])
      await expect(writeOutputs([motion('fr', 2)], await knownOf([frame], true))).rejects.toThrow(/one of the inputs/);
    expect([text('in/a.obj'), text('fr/0003.obj')]).toEqual([expect.stringContaining('# poses'), '4 3']);
  });

  it('are not needed for two outputs that are one file', async () => {
    put('x', '');
    linkSync(at('x'), at('y'));
    for (const [one, two] of [
      ['x', 'y'],
      ['new', 'new'],
      ['new', 'poses/../new'],
    ] as const)
      await expect(
        checkOutputs(
          [
            { flag: '--output', path: at(one) },
            { flag: '--report', path: at(two) },
          ],
          new KnownFiles(),
        ),
      ).rejects.toThrow(/--output and --report are the same file/);
    await checkOutputs(
      [
        { flag: '--output', path: '/dev/null' },
        { flag: '--report', path: '/dev/null' },
      ],
      new KnownFiles(),
    );
  });
});

describe('files beside an output', () => {
  const walk = (paint: string) => group('walk.obj', ['walk.mtl', paint], ['walk-texture-1.png', `${paint} image`]);

  it('are replaced while they are as they were written', async () => {
    for (const paint of ['red', 'red', 'blue']) await writeOutputs([walk(paint)]);
    expect([text('walk.mtl'), text('walk-texture-1.png')]).toEqual(['blue', 'blue image']);
  });

  it.each(['walk.mtl', 'walk-texture-1.png'])(
    'are not replaced if another program made or changed them: %s',
    async (name) => {
      put(name, 'by hand');
      await expect(writeOutputs([walk('red')])).rejects.toThrow(new RegExp(`${name} belongs to the output, but`));
      expect(listed()).toEqual([name]);
      rmSync(at(name));
      await writeOutputs([walk('red')]);
      put(name, 'by hand');
      await expect(writeOutputs([walk('blue')])).rejects.toThrow(/did not write, or that has changed/);
      expect([text(name), text('walk.obj')]).toEqual(['by hand', 'main']);
    },
  );

  it('may be the same file without a list, or the OBJ that a version without lists wrote for the same cache', async () => {
    put('walk.mtl', 'red');
    put('walk-texture-1.png', 'red image');
    await writeOutputs([walk('red')]);
    const ours = '# shapespline: Y up, metres\n# frames 3 from 0 to 1\nv 0 0 0\n';
    put('run.obj', ours);
    await expect(writeOutputs([group('run.pc2', ['run.obj', 'new'])])).rejects.toThrow(/run.obj belongs/);
    put('run.pc2', 'before');
    await writeOutputs([group('run.pc2', ['run.obj', 'new'])]);
    expect([text('run.obj'), text('run.pc2')]).toEqual(['new', 'main']);
  });

  it('are kept when a folder of frames is written there, and frames when files are', async () => {
    await writeOutputs([walk('red')]);
    await writeOutputs([motion('.', 3)]);
    await writeOutputs([walk('blue')]);
    await writeOutputs([motion('.', 2)]);
    expect(listed().filter((name) => !name.startsWith('.'))).toEqual([
      '0000.obj',
      '0001.obj',
      'walk-texture-1.png',
      'walk.mtl',
      'walk.obj',
    ]);
  });

  it('are refused where the list is something else', async () => {
    for (const list of ['{}', 'x', '{"files":[{"name":"../a","size":1,"sha256":"","of":"./"}]}']) {
      put('.shapespline.json', list);
      await expect(writeOutputs([walk('red')])).rejects.toThrow(/is not a list of files/);
      expect(text('.shapespline.json')).toBe(list);
    }
  });
});

describe('a folder that holds an earlier motion', () => {
  it('has only the frames of the new one afterwards, and other files', async () => {
    await writeOutputs([motion('fr', 5)]);
    put('fr/notes.txt', 'mine');
    put('fr/rest.obj', 'mine');
    for (const count of [3, 3, 4]) {
      await writeOutputs([motion('fr', count)]);
      const frames = ['0000.obj', '0001.obj', '0002.obj', '0003.obj'].slice(0, count);
      expect(readdirSync(at('fr'))).toEqual(['.shapespline.json', ...frames, 'notes.txt', 'rest.obj']);
      expect(text('fr/0001.obj')).toBe(`${count} 1`);
    }
  });

  it.each([1, 4])('is refused if frame %i has changed, also one that would be removed', async (frame) => {
    await writeOutputs([motion('fr', 5)]);
    put(`fr/000${frame}.obj`, '5 x');
    const why = new RegExp(`000${frame}.obj belongs to the output.*another folder`);
    for (const attempt of [checkOutputs, writeOutputs])
      await expect(attempt([motion('fr', 3)], new KnownFiles())).rejects.toThrow(why);
    expect([text('fr/0000.obj'), text('fr/0004.obj')]).toEqual(['5 0', frame === 4 ? '5 x' : '5 4']);
  });

  it('without a list is refused if a frame differs or a file would be read with the frames', async () => {
    for (const [name, why] of [
      ['0001.obj', 'belongs to the output'],
      ['0007.obj', 'would be read as a frame'],
    ] as const) {
      put(`fr/${name}`, 'mine');
      await expect(writeOutputs([motion('fr', 3)])).rejects.toThrow(new RegExp(`${name} ${why}.*another folder`));
      expect(readdirSync(at('fr'))).toEqual([name]);
      rmSync(at('fr'), { recursive: true });
    }
    for (const { name, bytes } of motion('fr', 3).files) put(`fr/${name}`, bytes);
    await writeOutputs([motion('fr', 3)]);
    await writeOutputs([motion('fr', 2)]);
    expect(readdirSync(at('fr'))).toEqual(['.shapespline.json', '0000.obj', '0001.obj']);
  });
});
