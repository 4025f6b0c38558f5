/** A zip of files as they are, without compression: enough to hand over a folder in one download. */
import type { ExportedFile } from '../../engine/api/types.ts';

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const VERSION = 20;
/** Names are UTF-8. */
const FLAGS = 0x0800;
/** 1 January 1980, the format's first day: the same files give the same bytes. */
const DATE = 0x0021;
/** Above this the 32-bit fields of the plain format do not hold. */
const MAX_BYTES = 0xffffffff;

export function zip(files: readonly ExportedFile[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  let offset = 0;
  for (const { name, bytes } of files) {
    const encoded = new TextEncoder().encode(name);
    const common = [VERSION, FLAGS, 0, 0, DATE] as const;
    const sums = [crc32(bytes), bytes.length, bytes.length] as const;
    const local = record([LOCAL], common, sums, [encoded.length, 0], encoded);
    directory.push(
      record([CENTRAL], [VERSION, ...common], sums, [encoded.length, 0, 0, 0, 0], null, [0, offset], encoded),
    );
    parts.push(local, bytes as Uint8Array<ArrayBuffer>);
    offset += local.length + bytes.length;
    if (offset > MAX_BYTES) throw new Error('These frames need more than 4 GB in one zip. Export fewer of them.');
  }
  const size = directory.reduce((sum, entry) => sum + entry.length, 0);
  const end = record([END], [0, 0, files.length, files.length], [size, offset], [0], null);
  return new Blob([...parts, ...directory, end], { type: 'application/zip' });
}

/** Little-endian fields: one 4-byte signature, 2-byte ones, 4-byte ones, 2-byte ones, perhaps 4-byte ones, bytes. */
function record(
  signature: readonly number[],
  shorts: readonly number[],
  longs: readonly number[],
  more: readonly number[],
  name: Uint8Array | null,
  last: readonly number[] = [],
  tail: Uint8Array | null = null,
): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(
    4 * (signature.length + longs.length + last.length) +
      2 * (shorts.length + more.length) +
      (name?.length ?? 0) +
      (tail?.length ?? 0),
  );
  const view = new DataView(bytes.buffer);
  let at = 0;
  const put4 = (value: number): void => {
    view.setUint32(at, value, true);
    at += 4;
  };
  const put2 = (value: number): void => {
    view.setUint16(at, value, true);
    at += 2;
  };
  const put = (text: Uint8Array | null): void => {
    if (text) {
      bytes.set(text, at);
      at += text.length;
    }
  };
  signature.forEach(put4);
  shorts.forEach(put2);
  longs.forEach(put4);
  more.forEach(put2);
  put(name);
  last.forEach(put4);
  put(tail);
  return bytes;
}

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit += 1) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value;
});

/** The checksum of the zip and PNG formats. */
export function crc32(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (let i = 0; i < bytes.length; i += 1) value = table[(value ^ bytes[i]!) & 0xff]! ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}
