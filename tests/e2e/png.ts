/** PNG files of plain columns of colour, made without any of the code under test but its checksum. */
import { deflateSync } from 'node:zlib';
import { crc32 } from '../../web/app/export/zip.ts';

function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type), data]);
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(data.length);
  frame.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

function file(width: number, height: number, depth: number, colourType: number, rows: Uint8Array): Buffer {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width);
  header.writeUInt32BE(height, 4);
  header.set([depth, colourType], 8);
  const signature = Buffer.from('\x89PNG\r\n\x1a\n', 'latin1');
  return Buffer.concat([
    signature,
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** `colours` from left to right, each a column of 16 x 64 pixels. */
export function columns(colours: readonly (readonly [number, number, number])[]): Buffer {
  const row = [0, ...colours.flatMap((colour) => Array.from({ length: 16 }, () => colour).flat())];
  return file(16 * colours.length, 64, 8, 2, Uint8Array.from(Array.from({ length: 64 }, () => row).flat()));
}

/** All black, one bit a pixel: far smaller as a file than it is once decoded. */
export function blank(side: number): Buffer {
  return file(side, side, 1, 0, new Uint8Array(side * (1 + Math.ceil(side / 8))));
}
