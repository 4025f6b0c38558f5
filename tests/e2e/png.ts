/** PNG files: decoded screenshots, and images for textures, made without any of the tested code. */
import { crc32, deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';

export type Colour = readonly [red: number, green: number, blue: number];

/** A decoded image, four bytes per pixel. */
export interface Picture {
  width: number;
  height: number;
  data: Uint8Array;
}

export function decode(file: Buffer): Picture {
  return PNG.sync.read(file);
}

export function encode({ width, height, data }: Picture): Buffer {
  const picture = new PNG({ width, height });
  picture.data.set(data);
  return PNG.sync.write(picture);
}

export function colourAt({ width, data }: Picture, x: number, y: number): Colour {
  const at = 4 * (y * width + x);
  return [data[at]!, data[at + 1]!, data[at + 2]!];
}

/** The colours of all pixels, row by row. */
export function* colours({ data }: Picture): Generator<Colour> {
  for (let at = 0; at < data.length; at += 4) yield [data[at]!, data[at + 1]!, data[at + 2]!];
}

/** Distance of a colour from grey. */
export function saturation(colour: Colour): number {
  return Math.max(...colour) - Math.min(...colour);
}

/** Number and share of pixels that satisfy a test. */
export function matching(file: Buffer, test: (colour: Colour) => boolean): { count: number; share: number } {
  const picture = decode(file);
  let count = 0;
  for (const colour of colours(picture)) if (test(colour)) count += 1;
  return { count, share: count / (picture.width * picture.height) };
}

/** Share of pixels that differ by more than some levels of 255 in a channel; 1 if the sizes differ. */
export function changedShare(before: Buffer, after: Buffer, levels = 6): number {
  const [a, b] = [decode(before), decode(after)];
  if (a.width !== b.width || a.height !== b.height) return 1;
  let changed = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(a.data[at + channel]! - b.data[at + channel]!) > levels)) changed += 1;
  }
  return changed / (a.width * a.height);
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The pixels of a box, clipped to the image. */
export function crop(picture: Picture, { x, y, width, height }: Box): Picture {
  const [right, bottom] = [Math.min(x + width, picture.width), Math.min(y + height, picture.height)];
  const rows = Array.from({ length: Math.max(bottom - y, 0) }, (_, row) => 4 * ((y + row) * picture.width + x));
  const across = 4 * Math.max(right - x, 0);
  return {
    width: across / 4,
    height: rows.length,
    data: Uint8Array.from(rows.flatMap((start) => [...picture.data.subarray(start, start + across)])),
  };
}

/** `list` from left to right, each as a column of 16 x 64 pixels. */
export function columns(list: readonly Colour[]): Buffer {
  const row = list.flatMap((colour) => Array.from({ length: 16 }, () => [...colour, 255]).flat());
  const data = Uint8Array.from(Array.from({ length: 64 }, () => row).flat());
  return encode({ width: 16 * list.length, height: 64, data });
}

/** All black with one bit per pixel, which pngjs cannot write: a small file for a large image. */
export function blank(side: number): Buffer {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(side);
  header.writeUInt32BE(side, 4);
  header.set([1, 0], 8);
  const rows = Buffer.alloc(side * (1 + Math.ceil(side / 8)));
  const signature = Buffer.from('\x89PNG\r\n\x1a\n', 'latin1');
  return Buffer.concat([signature, chunk('IHDR', header), chunk('IDAT', deflateSync(rows)), chunk('IEND')]);
}

function chunk(type: string, data = Buffer.alloc(0)): Buffer {
  const body = Buffer.concat([Buffer.from(type), data]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

/**
 * Scales down by a factor. Each pixel is the mean of a square. Squares at the right and lower edges may be
 * incomplete.
 */
export function shrink(file: Buffer, times: number): Buffer {
  const full = decode(file);
  const [width, height] = [Math.ceil(full.width / times), Math.ceil(full.height / times)];
  const data = Array.from({ length: width * height }, (_, i) => {
    const square = squareOf(full, times, times * (i % width), times * Math.floor(i / width));
    return [0, 1, 2].map((channel) => square.reduce((sum, colour) => sum + colour[channel]!, 0) / square.length);
  });
  return encode({ width, height, data: Uint8Array.from(data.flatMap((colour) => [...colour.map(Math.round), 255])) });
}

function squareOf(picture: Picture, side: number, left: number, top: number): Colour[] {
  const columns = Array.from({ length: Math.min(side, picture.width - left) }, (_, x) => left + x);
  const rows = Array.from({ length: Math.min(side, picture.height - top) }, (_, y) => top + y);
  return rows.flatMap((y) => columns.map((x) => colourAt(picture, x, y)));
}
