import { execFileSync, spawnSync } from 'node:child_process';
import { closeSync, existsSync, openSync } from 'node:fs';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { beforeAll, describe, expect, it } from 'vitest';
import packageJson from '../../package.json';
import { folderOf, listed, program, runCli, runNode } from './support/cli.ts';
import { meshGlb, poseFiles } from './support/glb.ts';
import { bar, bent, diagonal, largestDistance } from './support/shapes.ts';
import { threePlayer } from './support/three-player.ts';

const mesh = bar();
const poses = [0, 60, 120].map((degrees) => bent(mesh, degrees));
const files = poseFiles(mesh, poses);
const names = files.map(({ name }) => name);
let folder: string;

beforeAll(async () => {
  folder = await folderOf(files);
});

async function json(place: string): Promise<Record<string, never>> {
  return JSON.parse(await readFile(path.join(folder, place), 'utf8')) as Record<string, never>;
}

async function objOf(place: string): Promise<{ positions: Float32Array; faces: number[] }> {
  const lines = (await readFile(path.join(folder, place), 'utf8')).split('\n').map((line) => line.split(' '));
  const numbers = (kind: string): number[] =>
    lines.filter(([first]) => first === kind).flatMap(([, ...rest]) => rest.map((word) => Number.parseFloat(word)));
  return { positions: Float32Array.from(numbers('v')), faces: numbers('f').map((v) => v - 1) };
}

/** A .gltf of a pose, with its buffer in the same folder. */
function gltfPair(name: string, positions: Float32Array, uri = `${name}.bin`): { name: string; bytes: Uint8Array }[] {
  const bytes = meshGlb(mesh, positions);
  const view = new DataView(bytes.buffer);
  const length = view.getUint32(12, true);
  const document = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as { buffers: object[] };
  document.buffers[0] = { ...document.buffers[0], uri };
  return [
    { name: `${name}.gltf`, bytes: new TextEncoder().encode(JSON.stringify(document)) },
    { name: `${name}.bin`, bytes: bytes.slice(28 + length) },
  ];
}

describe('inspect', () => {
  it('prints the content of the files', async () => {
    const { code, stdout, stderr } = await runCli(folder, 'inspect', ...names);
    expect([code, stderr]).toEqual([0, '']);
    expect(JSON.parse(stdout)).toMatchObject({
      keys: [
        { name: 'pose-1', time: 0 },
        { name: 'pose-2', time: 1 },
        { name: 'pose-3', time: 2 },
      ],
      vertices: { raw: mesh.positions.length / 3, welded: mesh.positions.length / 3 },
      faces: mesh.indices.length / 3,
      components: 1,
      boundaryEdges: 0,
      warnings: [],
    });
  });

  it('reads the files that a .gltf names from its own folder', async () => {
    const where = await folderOf([...gltfPair('a', poses[0]!), ...gltfPair('b', poses[1]!)]);
    const { code, stdout } = await runCli(where, 'inspect', 'a.gltf', 'b.gltf');
    expect(code).toBe(0);
    expect((JSON.parse(stdout) as { keys: object[] }).keys).toHaveLength(2);
    const outside = await runCli(
      path.dirname(where),
      'inspect',
      `${path.basename(where)}/a.gltf`,
      path.join(where, 'b.gltf'),
    );
    expect(outside.code).toBe(0);
  });

  it('reads the materials that an OBJ names, and their images', async () => {
    const text = (content: string): Uint8Array => new TextEncoder().encode(content);
    const faces = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\n';
    const png = Uint8Array.from(
      atob('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=='),
      (c) => c.charCodeAt(0),
    );
    const where = await folderOf([
      { name: 'a.obj', bytes: text(`mtllib a.mtl\r\n${faces}`) },
      { name: 'b.obj', bytes: text(faces.replace('v 0 1 0', 'v 0 2 0')) },
      { name: 'a.mtl', bytes: text('newmtl red\nKd 1 0 0\nmap_Kd -s 1 1 1 -clamp on dark red.png\r\n') },
      { name: 'dark red.png', bytes: png },
    ]);
    const { code, stdout } = await runCli(where, 'inspect', 'a.obj', 'b.obj');
    expect([code, (JSON.parse(stdout) as { warnings: object[] }).warnings]).toEqual([0, []]);
  });

  it('reads nothing outside that folder', async () => {
    const where = await folderOf([...gltfPair('a', poses[0]!), ...gltfPair('b', poses[1]!)]);
    await mkdir(path.join(where, 'inner'));
    for (const uri of ['../a.bin', '%2e%2e/a.bin', path.join(where, 'a.bin')]) {
      await writeFile(path.join(where, 'inner/c.gltf'), gltfPair('c', poses[2]!, uri)[0]!.bytes);
      const { code, stderr } = await runCli(where, 'inspect', 'inner/c.gltf', 'inner/c.gltf');
      expect([code, stderr]).toEqual([1, expect.stringMatching(/^shapespline: .*c\.gltf.*\n$/)]);
    }
  });
});

describe('special files', () => {
  it.each(['/dev/zero', 'pipe'])('are refused before they are read: %s', async (name) => {
    const where = await folderOf(files);
    execFileSync('mkfifo', [path.join(where, 'pipe')]);
    const { code, stderr } = await runCli(where, 'inspect', names[0]!, name);
    expect([code, stderr]).toEqual([1, `shapespline: ${name}: it is a device, a pipe or a socket, not a file.\n`]);
  });

  it('are not read if a .gltf names them, either', async () => {
    const where = await folderOf([...gltfPair('a', poses[0]!), ...gltfPair('b', poses[1]!, 'pipe')]);
    execFileSync('mkfifo', [path.join(where, 'pipe')]);
    const { code, stderr } = await runCli(where, 'inspect', 'a.gltf', 'b.gltf');
    expect([code, stderr]).toEqual([1, expect.stringMatching(/^shapespline: b\.gltf.*pipe.*\n$/)]);
  });
});

describe('the terminal', () => {
  it('gets no control sequences from names', async () => {
    const { code, stderr } = await runCli(folder, 'inspect', 'a\u001b]0;title\u0007\u009b2J.glb');
    expect([code, stderr]).toEqual([1, 'shapespline: a\\u001b]0;title\\u0007\\u009b2J.glb: there is no such file.\n']);
    const glb = meshGlb(mesh, poses[0]!);
    const where = await folderOf([{ name: 'a\u009b2J.glb', bytes: glb }, ...files.slice(1)]);
    const { stdout } = await runCli(where, 'inspect', 'a\u009b2J.glb', names[1]!);
    expect(stdout).not.toContain('\u009b');
    expect((JSON.parse(stdout) as { files: string[] }).files[0]).toBe('a\u009b2J.glb');
  });

  it.skipIf(!existsSync('/dev/full'))('that is full gives one line', () => {
    const full = openSync('/dev/full', 'w');
    try {
      const { status, stderr } = spawnSync(process.execPath, [program, 'inspect', ...names], {
        cwd: folder,
        stdio: ['ignore', full, 'pipe'],
        encoding: 'utf8',
      });
      expect([status, stderr]).toEqual([
        1,
        expect.stringMatching(/^shapespline: Cannot write the output.*ENOSPC.*\n$/),
      ]);
    } finally {
      closeSync(full);
    }
  });
});

describe('complete', () => {
  it('writes an animation with the keys and the requested range', async () => {
    const { code, stdout, stderr } = await runCli(
      folder,
      'complete',
      ...names,
      '--output',
      'out.glb',
      '--report',
      'r.json',
      '--key-times',
      '0,0.4,1',
      '--frames',
      '9',
      '--range=-0.3:1.3',
      '--duration',
      '2',
      '--boundary',
      'hermite',
      '--start-speed',
      '0',
    );
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(
      /^out\.glb: \d+ shapes, largest error between frames [\d.]+ % of the model's size, \d+ bytes\n$/,
    );
    const player = await threePlayer(await readFile(path.join(folder, 'out.glb')));
    expect(player.duration).toBeCloseTo(2, 6);
    const seconds = (t: number): number => player.times.find((s) => Math.abs(s - ((t + 0.3) / 1.6) * 2) < 1e-6) ?? NaN;
    for (const [key, t] of [0, 0.4, 1].entries()) {
      expect(largestDistance(player.positionsAt(seconds(t)), poses[key]!)).toBeLessThan(1e-4 * diagonal(poses[key]!));
    }
    const report = await json('r.json');
    expect(report).toMatchObject({
      version: packageJson.version,
      files: names,
      output: { path: 'out.glb', files: 1 },
      options: {
        sequence: { boundary: 'hermite', startSpeed: 0, endSpeed: 1, method: 'lri', keyTimes: [0, 0.4, 1] },
        export: { duration: 2 },
      },
      counts: { encodings: expect.any(Number), factorisations: expect.any(Number) },
      range: [0, 1],
      warnings: [],
    });
    for (const stage of [
      'read',
      'import',
      'build',
      'weld',
      'encode',
      'order',
      'factor',
      'export',
      'measure',
      'total',
    ]) {
      expect(report.timings[stage]).toBeGreaterThanOrEqual(0);
    }
    const { times, volume, area } = report.measures as { times: number[]; volume: number[]; area: number[] };
    expect(times).toEqual(report.frames);
    expect([volume.length, area.length]).toEqual([times.length, times.length]);
    expect(volume[times.indexOf(0)]).toBeCloseTo(10, 4);
  });

  it("writes a folder of OBJ files with the input's vertex order, one for each requested time", async () => {
    const { code } = await runCli(folder, 'complete', ...names, '--output', 'frames/', '--at', '-0.3,1,2.3');
    expect(code).toBe(0);
    expect(await listed(path.join(folder, 'frames'))).toEqual([
      '.shapespline.json',
      '0000.obj',
      '0001.obj',
      '0002.obj',
    ]);
    const { positions, faces } = await objOf('frames/0001.obj');
    expect(largestDistance(positions, poses[1]!)).toBeLessThan(1e-5 * diagonal(poses[1]!));
    expect(faces).toEqual([...mesh.indices]);
    const again = await runCli(folder, 'complete', ...names, '--output=frames/', '--at=-0.3,1,2.3');
    expect(again.code).toBe(0);
    expect(await listed(path.join(folder, 'frames'))).toHaveLength(4);
    expect((await runCli(folder, 'complete', ...names, '--output=frames/', '--at=0,1')).code).toBe(0);
    const { keys } = JSON.parse((await runCli(folder, 'inspect', 'frames')).stdout);
    expect(keys).toHaveLength(2);
  });

  it('writes one shape', async () => {
    expect((await runCli(folder, 'complete', ...names, '--output', 'one.obj', '--at', '2')).code).toBe(0);
    expect(largestDistance((await objOf('one.obj')).positions, poses[2]!)).toBeLessThan(1e-5 * diagonal(poses[2]!));
  });

  it('writes a point cache with its OBJ', async () => {
    const { code, stderr } = await runCli(folder, 'complete', ...names, '--output', 'walk.pc2', '--fps', '4');
    expect([code, stderr]).toEqual([0, '']);
    const inspected = await runCli(folder, 'inspect', 'walk.obj', 'walk.pc2');
    expect((JSON.parse(inspected.stdout) as { animations: object[] }).animations).toMatchObject([{ start: 0, end: 2 }]);
    const cache = await readFile(path.join(folder, 'walk.pc2'));
    // The cache covers two seconds, one from pose to pose.
    expect(cache.readInt32LE(28)).toBe(9);
    const { positions } = await objOf('walk.obj');
    expect(cache.readInt32LE(16)).toBe(positions.length / 3);
  });

  it('writes the fewest targets for the tolerance, and the extra files of in-betweens', async () => {
    const report = async (...words: string[]) => {
      const { code } = await runCli(
        folder,
        'complete',
        ...names,
        '--output',
        'rig.glb',
        '--report',
        'rig.json',
        ...words,
      );
      expect(code).toBe(0);
      return JSON.parse(await readFile(path.join(folder, 'rig.json'), 'utf8')) as {
        targets: number;
        frames: number[];
        playbackError: number;
      };
    };
    const usual = await report();
    const rough = await report('--tolerance', '2');
    const all = await report('--tolerance', 'off');
    expect([usual.playbackError, rough.playbackError].map((error, i) => error < [0.001, 0.02][i]!)).toEqual([
      true,
      true,
    ]);
    expect(rough.targets).toBeLessThan(usual.targets);
    expect(all.targets).toBeGreaterThan(58);
    const mixed = await report('--targets', 'principal');
    const mixedAt = await report('--targets', 'principal', '--frames', '9');
    expect(mixedAt.frames).toHaveLength(9);
    expect(mixedAt.frames.length).toBeLessThan(mixed.frames.length);
    expect(await listed(folder)).toEqual(expect.arrayContaining(['rig.csv', 'rig.glb', 'rig.py']));
  });

  it('does not replace its inputs, the OBJ of a point cache among them, unless --overwrite allows it', async () => {
    const input = await folderOf([]);
    const run = (...words: string[]) => runCli(input, ...words);
    const poses = names.map((name) => path.join(folder, name));
    expect((await run('complete', ...poses, '--output', 'arm.pc2', '--frames', '5')).code).toBe(0);
    const content = () => Promise.all(['arm.obj', 'arm.pc2'].map((name) => readFile(path.join(input, name))));
    const before = await content();
    const arm = ['arm.obj', 'arm.pc2', '--sample', '3'];
    for (const [words, why] of [
      [['complete', ...arm, '--output', 'arm.mdd'], 'arm.obj is one of the inputs'],
      [['complete', ...arm, '--output', 'arm.mdd', '--overwrite'], 'arm.obj is one of the inputs'],
      [['complete', ...arm, '--output', 'm.glb', '--report', 'arm.pc2'], 'arm.pc2 is one of the inputs'],
      [['complete', '.', '--sample', '3', '--at', '0', '--output', './arm.obj'], 'arm.obj is one of the inputs'],
      [['measure', ...arm, '--output', 'arm.obj'], 'arm.obj is one of the inputs'],
      [['study', 'tables', ...arm, '--output', 'arm.pc2'], 'arm.pc2 is one of the inputs'],
      [
        ['measure', poses[0]!, poses[1]!, '--against', 'arm.obj', '--against', 'arm.pc2', '--output', 'arm.pc2'],
        'is one of',
      ],
    ] as const) {
      const { code, stderr } = await run(...words);
      expect([code, stderr]).toEqual([1, expect.stringContaining(why)]);
    }
    expect(await content()).toEqual(before);
    for (let time = 0; time < 2; time += 1)
      expect((await run('complete', ...arm, '--output', 'other.mdd')).code).toBe(0);
    expect((await run('complete', ...arm, '--at', '1', '--output', 'arm.obj', '--overwrite')).code).toBe(0);
    expect((await content())[0]).not.toEqual(before[0]);
  });

  it('makes 60 frames over the keys by default', async () => {
    expect((await runCli(folder, 'complete', ...names, '--output', 'all/')).code).toBe(0);
    expect((await listed(path.join(folder, 'all'))).filter((name) => name.endsWith('.obj'))).toHaveLength(60);
    expect((await objOf('all/0059.obj')).positions).toEqual((await objOf('one.obj')).positions);
  });

  it('states the size of a large export before writing, and only of a large one', async () => {
    const fine = bar(8, 120);
    const where = await folderOf(
      poseFiles(
        fine,
        [0, 60].map((degrees) => bent(fine, degrees)),
      ),
    );
    const { code, stderr } = await runCli(
      where,
      'complete',
      'pose-1.glb',
      'pose-2.glb',
      '--output',
      'large.glb',
      '--frames',
      '1300',
    );
    expect([code, stderr]).toEqual([0, expect.stringMatching(/^writing large\.glb, about \d{3} MB\n/)]);
    const written = (await readFile(path.join(where, 'large.glb'))).length;
    expect(Math.abs(Number(/about (\d+)/.exec(stderr)![1]) * 1e6 - written)).toBeLessThan(0.1 * written);
  });

  it('takes tangent poses', async () => {
    const shape = async (...words: string[]): Promise<Float32Array> => {
      const { code } = await runCli(
        folder,
        'complete',
        ...names,
        '--output',
        't.obj',
        '--at=0.2',
        '--boundary=hermite',
        ...words,
      );
      expect(code).toBe(0);
      return (await objOf('t.obj')).positions;
    };
    const plain = await shape();
    expect(largestDistance(await shape('--start-tangent', 'pose-3.glb'), plain)).toBeGreaterThan(0.1);
    // Without the option, the tangent is taken from the neighbouring key.
    expect(largestDistance(await shape('--start-tangent', 'pose-2.glb'), plain)).toBeLessThan(1e-5 * diagonal(plain));
    const other = await folderOf([{ name: 'other.glb', bytes: meshGlb(bar(2, 10)) }]);
    const { code, stderr } = await runCli(
      folder,
      'complete',
      ...names,
      '--output',
      'x.glb',
      '--end-tangent',
      path.join(other, 'other.glb'),
    );
    expect([code, stderr]).toEqual([1, expect.stringMatching(/other\.glb has \d+ vertices, but key 1 has \d+/)]);
  });

  it('opens what it wrote, with its options', async () => {
    expect(
      (await runCli(folder, 'complete', ...names, '--output', 'p.glb', '--boundary=periodic', '--period=3')).code,
    ).toBe(0);
    expect((await runCli(folder, 'complete', 'p.glb', '--output', 'p2.glb', '--report', 'p2.json')).code).toBe(0);
    expect(await json('p2.json')).toMatchObject({
      options: { sequence: { boundary: 'periodic', period: 3, keyTimes: [0, 1, 2] } },
      isProject: true,
    });
  });
});

describe('a project that commit 4f00d434 wrote', () => {
  const project = fileURLToPath(new URL('../saved/project.glb', import.meta.url));

  it('opens with its keys and options, and says which option is gone', async () => {
    const { code, stderr } = await runCli(
      folder,
      'complete',
      project,
      '--output',
      'saved.glb',
      '--report',
      'saved.json',
    );
    expect([code, stderr]).toEqual([0, expect.stringContaining('own paths of faces. The option is gone')]);
    expect(await json('saved.json')).toMatchObject({
      keys: [
        { name: 'a', time: 0 },
        { name: 'b', time: 1 },
        { name: 'c', time: 2 },
      ],
      options: { sequence: { boundary: 'hermite', endSpeed: 2, tension: [0, 0.5, 0] } },
    });
  });

  it('opens with options that exclude each other, and says which is left out', async () => {
    const text = (await readFile(project)).toString('latin1').replace('"keepLengths":0', '"keepLengths":1');
    await writeFile(path.join(folder, 'excluding.glb'), text, 'latin1');
    const { code, stderr } = await runCli(folder, 'complete', 'excluding.glb', '--output', 'kept.glb');
    expect([code, stderr]).toEqual([
      0,
      expect.stringContaining("The option keepLengths does not support ends other than 'natural'. The motion is made"),
    ]);
  });

  it('has the motion that the keys have with its options', async () => {
    const objs = [0.5, 0.2, -0.1].map((x, i) => ({
      name: `saved-${i}.obj`,
      bytes: new TextEncoder().encode(`v 0 0 0\nv 1 0 0\nv ${1 + x} 0 1\nv ${x} 0 1\nf 1 2 3 4\n`),
    }));
    await Promise.all(objs.map(({ name, bytes }) => writeFile(path.join(folder, name), bytes)));
    const options = ['--boundary=hermite', '--end-speed=2', '--tension=0,0.5,0'];
    const at = ['--at', '1.4'];
    await runCli(folder, 'complete', project, ...at, '--output', 'saved.obj');
    await runCli(folder, 'complete', ...objs.map(({ name }) => name), ...options, ...at, '--output', 'again.obj');
    const [saved, again] = [await objOf('saved.obj'), await objOf('again.obj')];
    expect(largestDistance(saved.positions, again.positions)).toBeLessThan(1e-6);
  });
});

describe('complete with a ghost mesh', () => {
  const report = async (...words: string[]): Promise<Record<string, never>> => {
    const { code, stderr } = await runCli(
      folder,
      'complete',
      ...names,
      '--output',
      'g.glb',
      '--report',
      'g.json',
      '--frames=9',
      ...words,
    );
    expect([code, stderr]).toEqual([0, '']);
    return json('g.json');
  };

  it('reports its size, its error and the times of its stages', async () => {
    const exact = await report('--ghost-faces', '80');
    expect(exact).toMatchObject({
      options: { sequence: { ghostFaces: 80, transfer: 'exact', placement: 'vertices' } },
      ghost: {
        faces: expect.any(Number),
        vertices: expect.any(Number),
        joinedComponents: 0,
        transfer: 'exact',
        placement: 'vertices',
      },
    });
    const { faces, vertices, kg } = exact.ghost as Record<string, number>;
    expect(faces).toBeGreaterThan(40);
    expect(faces).toBeLessThanOrEqual(80);
    expect(faces).toBe(2 * vertices! - 4); // the surface is closed, of genus 0
    expect(kg).toBeGreaterThan(0);
    expect(kg).toBeLessThan(5);
    for (const stage of ['weld', 'simplify', 'encode', 'transfer', 'order', 'factor', 'compare'])
      expect(exact.timings[stage]).toBeGreaterThan(0);
    const paper = await report('--ghost-faces=80', '--transfer=paper', '--placement=optimal');
    expect(paper).toMatchObject({ ghost: { transfer: 'paper', placement: 'optimal' } });
    expect((paper.ghost as Record<string, number>).kg).not.toBe(kg);
  });

  it('is off by default, and can be removed from a project', async () => {
    expect((await report()).ghost).toBeNull();
    await report('--ghost-faces=80');
    const opened = async (...words: string[]): Promise<unknown> => {
      expect(
        (await runCli(folder, 'complete', 'g.glb', '--output', 'h.glb', '--report', 'h.json', ...words)).code,
      ).toBe(0);
      return (await json('h.json')).options;
    };
    expect(await opened()).toMatchObject({ sequence: { ghostFaces: 80 } });
    expect(await opened('--ghost-faces=off')).toMatchObject({ sequence: { ghostFaces: 0 } });
  });
});

describe('flags of Node', () => {
  it.each(['--max-old-space-size=4096', '--expose-gc', '--title=mine', '--stack-trace-limit=50', '--no-warnings'])(
    '%s works',
    async (flag) => {
      const { code, stderr } = await runNode(folder, flag, program, 'inspect', ...names);
      expect([code, stderr]).toEqual([0, '']);
    },
  );
});

describe('wrong use', () => {
  it.each([
    [[]],
    [['explode']],
    [['inspect']],
    [['inspect', 'pose-1.glb', '--frames', '3']],
    [['complete', 'pose-1.glb', 'pose-2.glb']],
    [['complete', '--output', 'x.glb']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.fbx']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--boundery', 'natural']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--boundary', 'open']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--at=0', '--frames=3']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--ghost-faces', '3']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--ghost-faces=no']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--ghost-faces=500', '--transfer=fast']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--reference', '7']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--frames=1000000000']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--range=1e308:1.7e308']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--boundary=periodic', '--period=1e308']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--at=1e300']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.pc2', '--tolerance=1']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x/', '--compression=meshopt']],
    [['complete', 'pose-1.glb', 'pose-2.glb', '--output', 'x.glb', '--boundary=periodic', '--period=0.5']],
  ])('is one line and exit code 2: %j', async (words) => {
    const before = await listed(folder);
    const { code, stdout, stderr } = await runCli(folder, ...words);
    expect([code, stdout]).toEqual([2, '']);
    expect(stderr).toMatch(/^shapespline: [^\n]+\n$/);
    expect(await listed(folder)).toEqual(before);
  });
});

describe('many numbered files', () => {
  it('are an animation with 8 frames as keys; the warning states the number of files and how to choose other frames', async () => {
    const pose = (frame: number): string => `v 0 0 0\nv 1 0 0\nv 0 ${1 + frame / 20} 0\nf 1 2 3\n`;
    const series = Array.from({ length: 40 }, (_, frame) => ({
      name: `walk_${100 + frame}.obj`,
      bytes: new TextEncoder().encode(pose(frame)),
    }));
    const where = await folderOf(series);
    const files = series.map(({ name }) => name);
    const run = async (...words: string[]) => {
      const { code, stderr } = await runCli(
        where,
        'complete',
        ...files,
        '--output',
        'a.glb',
        '--report',
        'a.json',
        ...words,
      );
      expect(code).toBe(0);
      const { keys } = JSON.parse(await readFile(path.join(where, 'a.json'), 'utf8')) as { keys: object[] };
      return { stderr, keys: keys.length };
    };
    const usual = await run();
    expect(usual.keys).toBe(8);
    expect(usual.stderr).toContain('warning: 40 numbered files are used as frames of an animation');
    expect(usual.stderr).toContain('The keys are 8 evenly spaced frames');
    expect(usual.stderr).toContain('--sample');
    const asked = await run('--sample', '12');
    expect(asked.keys).toBe(12);
    expect(asked.stderr).not.toContain('numbered files');
  });
});

describe('bad input', () => {
  it.each([
    [['no-such.glb', 'pose-1.glb'], /no-such\.glb/],
    [['pose-1.glb'], /pose-1\.glb/],
    [['pose-1.glb', 'cut.glb'], /cut\.glb/],
    [['pose-1.glb', 'page.glb'], /page\.glb/],
    [['pose-1.glb', 'pose-2.glb', '--key-times', '1,0'], /time/],
    [['bodies-1.obj', 'bodies-2.obj', '--object', 'Roof'], /bodies-1\.obj.*no object "Roof"; it has "Body", "Floor"/],
    [['pose-1.ply', 'pose-2.ply', '--object', 'Roof'], /pose-1\.ply.*no object "Roof"; named objects: none/],
    [['pose-1.glb', 'pose-2.glb', '--key-times', '0,1,2'], /3 .*2|times/],
  ])('is one line that names it, exit code 1, and no output: %j', async (words, says) => {
    await writeFile(path.join(folder, 'cut.glb'), files[1]!.bytes.slice(0, 3000));
    await writeFile(path.join(folder, 'page.glb'), '<!DOCTYPE html><title>404</title>');
    for (const k of [1, 2]) {
      const bodies = `o Body\nv 0 0 0\nv 1 0 0\nv 0 ${k} 0\nf 1 2 3\no Floor\nv 0 0 9\nv 1 0 9\nv 0 1 9\nf 4 5 6\n`;
      await writeFile(path.join(folder, `bodies-${k}.obj`), bodies);
      const header = 'element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n';
      const ply = `ply\nformat ascii 1.0\n${header}property list uchar int vertex_indices\nend_header\n`;
      await writeFile(path.join(folder, `pose-${k}.ply`), `${ply}0 0 0\n1 0 0\n0 ${k} 0\n3 0 1 2\n`);
    }
    const before = await listed(folder);
    for (const output of ['bad.glb', 'bad/', 'new/folder/bad.glb']) {
      const { code, stdout, stderr } = await runCli(
        folder,
        'complete',
        ...words,
        '--output',
        output,
        '--report',
        'bad.json',
      );
      expect([code, stdout]).toEqual([1, '']);
      expect(stderr).toMatch(/^shapespline: [^\n]+\n$/);
      expect(stderr).toMatch(says);
    }
    expect(await listed(folder)).toEqual(before);
  });

  it('includes an output that cannot be written', async () => {
    const before = await listed(folder);
    const { code, stderr } = await runCli(folder, 'complete', ...names, '--output', 'pose-1.glb/x.glb', '--frames=2');
    expect([code, stderr]).toEqual([1, expect.stringMatching(/^shapespline: [^\n]+\n$/)]);
    expect(await listed(folder)).toEqual(before);
  });
});

describe('a typical folder', () => {
  const pose = (name: string, height: number) => ({
    name,
    bytes: new TextEncoder().encode(`v 0 0 0\nv 1 0 0\nv 0 1 ${height}\nf 1 2 3\n`),
  });
  const keysOf = (stdout: string): string[] =>
    (JSON.parse(stdout) as { keys: { name: string }[] }).keys.map(({ name }) => name);
  const junk = (name: string) => ({ name, bytes: Uint8Array.of(0, 5, 22, 7) });

  it('has frames below zero and files of the operating system', async () => {
    const left = ['._sim.-1.obj', '.DS_Store', 'Thumbs.db', 'desktop.ini'].map(junk);
    const frames = [1, 0, -1, -2].map((number) => pose(`sim.${number}.obj`, number));
    const place = await folderOf([...frames, ...left]);
    for (const given of [
      ['.'],
      ['sim.-2.obj', ...left.map(({ name }) => name), 'sim.-1.obj', 'sim.0.obj', 'sim.1.obj'],
    ]) {
      const { code, stdout } = await runCli(place, 'inspect', ...given);
      expect([code, code === 0 && keysOf(stdout)]).toEqual([0, ['sim.-2', 'sim.-1', 'sim.0', 'sim.1']]);
    }
  });

  it('with two numbered sequences is refused; the message names both and says what to do', async () => {
    const sequence = (name: string, count: number) =>
      Array.from({ length: count }, (_, i) => pose(`${name}_000${i + 1}.obj`, i));
    const place = await folderOf([...sequence('walk', 3), ...sequence('run', 2)]);
    const { code, stderr } = await runCli(place, 'inspect', '.');
    expect(code).toBe(1);
    expect(stderr).toMatch(
      /2 numbered sequences: run_0001\.obj to run_0002\.obj \(2 files\), walk_0001\.obj to walk_0003\.obj/,
    );
    expect(stderr).toMatch(/such as run_0001\.obj to run_0002\.obj/);
    const all = await runCli(place, 'inspect', 'run_0001.obj', 'run_0002.obj', 'walk_0001.obj', 'walk_0002.obj');
    expect(keysOf(all.stdout)).toHaveLength(4);
    expect(all.stdout).toContain('several-sequences');
  });
});

describe('help and version', () => {
  it('go to stdout with exit code 0', async () => {
    expect(await runCli(folder, '--version')).toEqual({ code: 0, stdout: `${packageJson.version}\n`, stderr: '' });
    for (const words of [['--help'], ['complete', '--help'], ['inspect', '--help']]) {
      const { code, stdout } = await runCli(folder, ...words);
      expect([code, stdout.includes('Keys are counted from 1')]).toEqual([0, true]);
    }
  });
});
