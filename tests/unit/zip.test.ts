import { describe, expect, it } from 'vitest';
import { unzip } from '../unzip.ts';
import { zip } from '../../web/app/export/zip.ts';

const files = [
  { name: '0000.obj', bytes: new TextEncoder().encode('v 0 0 0\n') },
  { name: 'frames/größe.obj', bytes: new Uint8Array(70_000).map((_, index) => index * 31) },
  { name: 'empty.obj', bytes: new Uint8Array() },
];

const bytesOf = async (blob: Blob): Promise<Uint8Array> => new Uint8Array(await blob.arrayBuffer());

describe('zip', () => {
  it('another program extracts every file, byte for byte and in order', async () => {
    const blob = await zip(files);
    expect(blob.type).toBe('application/zip');
    const entries = await unzip(blob);
    expect(entries.map(({ name }) => name)).toEqual(files.map(({ name }) => name));
    for (const [index, { bytes }] of entries.entries()) expect(Buffer.compare(bytes, files[index]!.bytes)).toBe(0);
  });

  it('is the same for the same files', async () => {
    const [one, other] = [await bytesOf(await zip(files)), await bytesOf(await zip(files))];
    expect(Buffer.compare(one, other)).toBe(0);
  });

  it('accepts files while they are made, and fails if making one fails', async () => {
    const asked: number[] = [];
    async function* failing() {
      for (const index of files.keys()) {
        asked.push(index);
        if (index === 2) throw new Error('There is no third file.');
        yield files[index]!;
      }
    }
    await expect(zip(failing())).rejects.toThrow('There is no third file.');
    expect(asked).toEqual([0, 1, 2]);
  });
});
