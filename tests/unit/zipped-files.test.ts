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

it('reports errors in a zip', async () => {
  await expect(unzipped([picked('x.zip', ['no zip'])])).rejects.toThrow('x.zip is not a readable zip.');
  await expect(unzipped([picked('x.zip', [await deflated({ 'a.txt': '' })])])).rejects.toThrow('no model in x.zip');
  const secret = await deflated({ 'a.obj': 'v 0 0 0' }, 'word');
  await expect(unzipped([picked('x.zip', [secret])])).rejects.toThrow('a.obj in x.zip is encrypted.');
  const broken = new Uint8Array(await (await deflated({ 'a.obj': 'v 0 0 0\n'.repeat(99) })).arrayBuffer());
  broken.fill(255, 45, 60);
  await expect(unzipped([picked('x.zip', [broken])])).rejects.toThrow('a.obj in x.zip cannot be unpacked.');
});
