/** Sources of the element's keys, from reading them to the imported keys. A web of files replaces `fetch`. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { withEngine } from '../../web/engine/node.ts';
import { readSources } from '../../web/embed/sources.ts';
import type { KeySource } from '../../web/embed/sources.ts';

const INDICES = Uint16Array.from([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
const obj = (z: number): string => `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 ${z}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n`;

function bin(z: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(72);
  bytes.set(new Uint8Array(Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, z]).buffer));
  bytes.set(new Uint8Array(INDICES.buffer), 48);
  return bytes;
}

const gltf = (uri: string): string =>
  JSON.stringify({
    asset: { version: '2.0' },
    buffers: [{ uri, byteLength: 72 }],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 9] },
      { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });

const dataUrl = (bytes: Uint8Array | string, type = 'application/octet-stream'): string =>
  `data:${type};base64,${Buffer.from(bytes).toString('base64')}`;

type Web = Record<string, BodyInit>;

/** Serves the files by path and query; other URLs are fetched as usual. */
function serve(web: Web): void {
  const { fetch } = globalThis;
  vi.stubGlobal('fetch', async (url: URL) => {
    if (url.hostname !== 'example.org') return fetch(url);
    const body = web[url.pathname + url.search] ?? web[url.pathname];
    return body === undefined ? new Response('', { status: 404 }) : new Response(body);
  });
}
afterEach(() => vi.unstubAllGlobals());

const making = { signal: new AbortController().signal, report: () => undefined };
const read = (sources: readonly KeySource[]) => readSources(sources, 'https://example.org/', making);

/** The height of each key's tip, and the keys' names. */
async function keysOf(sources: readonly KeySource[]): Promise<{ tips: number[]; names: readonly string[] }> {
  const files = await read(sources);
  return withEngine(async (engine) => {
    const keys = await engine.importKeyframes(files);
    const { names } = keys.info;
    return { tips: names.map((_, key) => keys.positions(key)[11]!), names };
  });
}

async function failureOf(sources: readonly KeySource[]): Promise<string> {
  return keysOf(sources).then(
    () => 'no failure',
    (error: Error) => error.message,
  );
}

describe('keys of equal names read their own companions', () => {
  const scene = gltf('scene.bin');
  const inFolders = {
    '/a/scene.gltf': scene,
    '/b/scene.gltf': scene,
    '/a/scene.bin': bin(1),
    '/b/scene.bin': bin(2),
  };

  it('in two folders', async () => {
    serve(inFolders);
    expect(await keysOf(['a/scene.gltf', 'b/scene.gltf'])).toEqual({ tips: [1, 2], names: ['scene', 'scene'] });
  });

  it('in subfolders of two folders, with spaces', async () => {
    const nested = gltf('my%20data/scene.bin');
    serve({
      '/a/x.gltf': nested,
      '/b/y.gltf': nested,
      '/a/my%20data/scene.bin': bin(1),
      '/b/my%20data/scene.bin': bin(2),
    });
    expect(await keysOf(['a/x.gltf', 'b/y.gltf'])).toEqual({ tips: [1, 2], names: ['x', 'y'] });
  });

  it('by query, without extension, and with embedded buffers', async () => {
    serve({ '/get?id=1': gltf('of?id=1'), '/get?id=2': gltf('of?id=2'), '/of?id=1': bin(1), '/of?id=2': bin(2) });
    expect((await keysOf(['get?id=1', 'get?id=2'])).tips).toEqual([1, 2]);
    serve({ '/get?id=1': gltf(dataUrl(bin(1))), '/get?id=2': gltf(dataUrl(bin(2))) });
    expect((await keysOf(['get?id=1', 'get?id=2'])).tips).toEqual([1, 2]);
  });

  it('as files that a script gives', async () => {
    const files = [1, 2].flatMap((z) => [new File([scene], 'scene.gltf'), new File([bin(z)], 'scene.bin')]);
    expect(await keysOf(files)).toEqual({ tips: [1, 2], names: ['scene', 'scene'] });
  });

  it('as files of a folder', async () => {
    const files = ['a/scene.gltf', 'b/scene.gltf', 'a/scene.bin', 'b/scene.bin'].map((path) =>
      Object.assign(new File([inFolders[`/${path}` as keyof typeof inFolders]], path.slice(2)), {
        webkitRelativePath: path,
      }),
    );
    expect((await keysOf(files)).tips).toEqual([1, 2]);
  });

  it('OBJ files with materials of equal names', async () => {
    const material = (name: string) => `mtllib look.mtl\nusemtl skin\n${obj(name === 'a' ? 1 : 2)}`;
    serve({
      '/a/x.obj': material('a'),
      '/a/look.mtl': 'newmtl skin\nKd 1 0 0\n',
      '/b/x.obj': material('b'),
      '/b/look.mtl': 'newmtl skin\nKd 0 1 0\n',
    });
    const colourOf = async (sources: string[]) => {
      const files = await read(sources);
      return withEngine(async (engine) => (await engine.importKeyframes(files)).info.scene.materials[0]?.baseColor);
    };
    const [a, b] = [
      ['a/x.obj', 'a/look.mtl'],
      ['b/x.obj', 'b/look.mtl'],
    ] as const;
    expect(await colourOf([...a, ...b])).toEqual(await colourOf([...a, 'b/x.obj']));
    expect(await colourOf([...b, ...a])).not.toEqual(await colourOf([...a, ...b]));
  });

  it('numbered files stay one sequence', async () => {
    const names = ['a/w1.obj', 'a/w2.obj', 'a/w5.obj', 'a/look.mtl', 'b/look.mtl'];
    serve(Object.fromEntries(names.map((name, i) => [`/${name}`, name.endsWith('obj') ? obj(i + 1) : 'newmtl a'])));
    const files = await read(names);
    await withEngine(async (engine) => {
      const { times } = (await engine.importKeyframes(files, { sample: 2 })).info;
      expect(times.at(-1)).toBeCloseTo(4 / 24);
    });
  });

  it('a source that is given twice is read once, under its own name', async () => {
    serve({ '/w1.obj': obj(1), '/w2.obj': obj(2) });
    const files = await read(['w1.obj', 'w2.obj', 'w1.obj']);
    expect(files.map(({ name }) => name)).toEqual(['w1.obj', 'w2.obj', 'w1.obj']);
    expect(files[2]!.bytes).toBe(files[0]!.bytes);
  });
});

describe('the kind of a source comes from its content or MIME type', () => {
  const commented = (z: number) => `# Made by hand\r\n#\r\n\r\n${obj(z)}`;
  const ply = (z: number) =>
    'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n' +
    `element face 4\nproperty list uchar int vertex_indices\nend_header\n` +
    `0 0 0\n1 0 0\n0 1 0\n0 0 ${z}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n`;
  const off = (z: number) =>
    `# four faces\nOFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 ${z}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n`;
  const embedded = (z: number) => gltf(dataUrl(bin(z)));
  const facesFirst = (z: number) => `l 1 2\n${obj(z)}`;

  it.each([
    ['OBJ', obj, 'model/obj'],
    ['OBJ without a type', commented, ''],
    ['OBJ by its type only', facesFirst, 'model/obj'],
    ['PLY', ply, 'text/plain'],
    ['OFF', off, ''],
    ['glTF', embedded, 'application/json'],
  ])('%s', async (_, of, type) => {
    const blobs = [1, 2].map((z) => new Blob([of(z)], { type }));
    const urls = [1, 2].map((z) => dataUrl(of(z), type || undefined));
    const made = blobs.map((blob) => URL.createObjectURL(blob));
    const files = [1, 2].map((z) => new File([of(z)], `walk ${z}.txt`, { type }));
    for (const sources of [blobs, urls, made, files]) expect((await keysOf(sources)).tips).toEqual([1, 2]);
    if (type !== 'model/obj') expect((await keysOf([1, 2].map((z) => Buffer.from(of(z))))).tips).toEqual([1, 2]);
    for (const url of made) URL.revokeObjectURL(url);
  });

  it('OBJ from a URL without extension', async () => {
    serve({ '/get?id=1': obj(1), '/get?id=2': obj(2) });
    expect((await keysOf(['get?id=1', 'get?id=2'])).tips).toEqual([1, 2]);
  });

  it('reports other files under their names', async () => {
    serve({ '/walk.fbx': 'Kaydara FBX Binary', '/notes': 'Buy milk.' });
    expect(await failureOf(['walk.fbx', 'walk.fbx'])).toMatch(/^walk\.fbx .*an FBX file/);
    expect(await failureOf(['notes', 'notes'])).toMatch(/^notes .*is not a supported 3D file/);
    expect(await failureOf([new Blob(['Buy milk.'])])).toMatch(/^key-1 .*is not a supported 3D file/);
  });
});

describe('messages shorten URLs', () => {
  const long = 'A'.repeat(1_000_000);
  it.each([
    ['a data URL of another content', `data:text/plain,${long}`],
    ['a data URL that cannot be decoded', `data:model/obj;base64,${long}!`],
    ['a data URL of a web page', `data:text/html,<html>${long}`],
    ['a missing file', `https://example.org/${long}.glb?${long}`],
    ['an invalid URL', `https://[${long}`],
    ['a glTF with such a URL', dataUrl(gltf(`data:${long}`))],
  ])('%s', async (_, url) => {
    serve({});
    const message = await failureOf([url, url]);
    expect(message.length).toBeLessThan(400);
    expect(message).not.toMatch(/A{130}/);
  });
});
