/** Contents of zips, read by the browser's own decompression. */
import { BlobWriter, TextReader, ZipWriter } from '@zip.js/zip.js';
import { expect, it } from 'vitest';
import { zip } from '../../web/app/export/zip.ts';
import { unzipped } from '../../web/ui/zipped-files.ts';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const picked = (name: string, parts: BlobPart[]) => ({ name, file: new File(parts, name) });

async function deflated(files: Record<string, string>, password?: string): Promise<Blob> {
  const writer = new ZipWriter(new BlobWriter(), { useWebWorkers: false, ...(password ? { password } : {}) });
  for (const [name, text] of Object.entries(files)) await writer.add(name, new TextReader(text));
  return writer.close();
}

it('takes the models of a zip and their files, and ignores other files', async () => {
  const own = await zip([
    { name: 'index.html', bytes: bytesOf('<p>') },
    { name: 'lion.glb', bytes: bytesOf('glTF') },
    { name: 'shapespline/cdn.js', bytes: bytesOf('0') },
  ]);
  const other = await deflated({ 'a/1.obj': 'v 0 0 0\n'.repeat(1000), 'a/1.mtl': 'newmtl', '__MACOSX/a/._1.obj': 'x' });
  const found = await unzipped([picked('b.obj', ['v']), picked('lion.zip', [own]), picked('poses.ZIP', [other])]);
  expect(found.map(({ name }) => name)).toEqual([
    'b.obj',
    'lion.zip/lion.glb',
    'poses.ZIP/a/1.obj',
    'poses.ZIP/a/1.mtl',
  ]);
  expect(await found[1]!.file.text()).toBe('glTF');
  expect(found[2]!.file.size).toBe(8000);
});

/** A zip with two files of one name, which zip.js does not write. */
async function twice(name: string): Promise<Uint8Array<ArrayBuffer>> {
  const other = 'x'.repeat(name.length);
  const bytes = new Uint8Array(await (await deflated({ [name]: 'v', [other]: 'w' })).arrayBuffer());
  for (let at = 0; at + name.length <= bytes.length; at += 1)
    if (new TextDecoder().decode(bytes.subarray(at, at + name.length)) === other) bytes.set(bytesOf(name), at);
  return bytes;
}

it('two files of one name are named, with advice', async () => {
  const sentence = (name: string): string =>
    `x.zip contains two files named ${name}. Unpack it, rename one of them, and drop the files.`;
  const same = await twice('walk/a.obj');
  await expect(unzipped([picked('x.zip', [same])])).rejects.toThrow(sentence('a.obj'));
  const [composed, decomposed] = ['\u00e9.obj', 'e\u0301.obj'];
  const spelled = await deflated({ [composed]: 'v', [decomposed]: 'w', 'b/a.obj': '', 'c/a.obj': '' });
  await expect(unzipped([picked('x.zip', [spelled])])).rejects.toThrow(sentence(decomposed));
});

it('small zips of large files are refused, whatever they state', async () => {
  const zeros = await deflated({ 'a.obj': '0'.repeat(40e6), 'b.obj': '0'.repeat(30e6) });
  expect(zeros.size).toBeLessThan(100_000);
  const sentence = 'x.zip has more than 64 MB when unpacked, the limit for a zip of its size. Unpack it';
  await expect(unzipped([picked('x.zip', [zeros])])).rejects.toThrow(sentence);
  const bytes = new Uint8Array(await zeros.arrayBuffer());
  const view = new DataView(bytes.buffer);
  // The central directory states the sizes.
  for (let at = 0; at + 28 < bytes.length; at += 1)
    if (view.getUint32(at, true) === 0x02014b50) view.setUint32(at + 24, 1000, true);
  await expect(unzipped([picked('x.zip', [bytes])])).rejects.toThrow('a.obj in x.zip cannot be unpacked.');
  const [whole] = await unzipped([picked('x.zip', [await deflated({ 'a.obj': '0'.repeat(20e6) })])]);
  expect(whole!.file.size).toBe(20e6);
});

it('reports errors in a zip', async () => {
  await expect(unzipped([picked('x.zip', ['no zip'])])).rejects.toThrow('x.zip is not a readable zip.');
  await expect(unzipped([picked('x.zip', [await deflated({ 'a.txt': '' })])])).rejects.toThrow('no model in x.zip');
  const secret = await deflated({ 'a.obj': 'v 0 0 0' }, 'word');
  await expect(unzipped([picked('x.zip', [secret])])).rejects.toThrow('a.obj in x.zip is encrypted.');
  const broken = new Uint8Array(await (await deflated({ 'a.obj': 'v 0 0 0\n'.repeat(99) })).arrayBuffer());
  broken.fill(255, 45, 60);
  await expect(unzipped([picked('x.zip', [broken])])).rejects.toThrow('a.obj in x.zip cannot be unpacked.');
});
