import { describe, expect, it } from 'vitest';
import { crc32, zip } from '../../web/app/export/zip.ts';

const files = [
  { name: '0000.obj', bytes: new TextEncoder().encode('v 0 0 0\n') },
  { name: 'frames/größe.obj', bytes: new Uint8Array(70_000).map((_, index) => index * 31) },
  { name: 'empty.obj', bytes: new Uint8Array() },
];

interface Entry {
  name: string;
  bytes: Uint8Array;
}

/** Reads a stored zip as unpackers do: from the end record to the directory to the local headers (APPNOTE 4.3). */
function unzip(bytes: Uint8Array): Entry[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = bytes.length - 22;
  expect(view.getUint32(end, true)).toBe(0x06054b50);
  const count = view.getUint16(end + 10, true);
  const size = view.getUint32(end + 12, true);
  let at = view.getUint32(end + 16, true);
  expect(at + size).toBe(end);
  const entries: Entry[] = [];
  for (let index = 0; index < count; index += 1) {
    expect(view.getUint32(at, true)).toBe(0x02014b50);
    expect(view.getUint16(at + 10, true)).toBe(0);
    const [crc, packed, length] = [16, 20, 24].map((field) => view.getUint32(at + field, true)) as [
      number,
      number,
      number,
    ];
    expect(packed).toBe(length);
    const nameLength = view.getUint16(at + 28, true);
    const local = view.getUint32(at + 42, true);
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + nameLength));
    expect(view.getUint32(local, true)).toBe(0x04034b50);
    expect(view.getUint32(local + 14, true)).toBe(crc);
    expect(view.getUint32(local + 22, true)).toBe(length);
    expect(view.getUint16(local + 26, true)).toBe(nameLength);
    const start = local + 30 + nameLength + view.getUint16(local + 28, true);
    const content = bytes.subarray(start, start + length);
    expect(crc32(content)).toBe(crc);
    entries.push({ name, bytes: content });
    at += 46 + nameLength + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
  expect(at).toBe(end);
  return entries;
}

describe('zip', () => {
  it('has the checksum that the format asks for', () => {
    // The check value of CRC-32/ISO-HDLC.
    expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
  });

  it('gives every file back, byte for byte and in order', async () => {
    const entries = unzip(new Uint8Array(await zip(files).arrayBuffer()));
    expect(entries.map(({ name }) => name)).toEqual(files.map(({ name }) => name));
    entries.forEach(({ bytes }, index) => expect(Buffer.compare(bytes, files[index]!.bytes)).toBe(0));
  });
});
