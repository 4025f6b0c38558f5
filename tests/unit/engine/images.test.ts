import { describe, expect, it } from 'vitest';
import { drawnImages, imageSize } from '../../../web/engine/worker/image-size.ts';
import type { Material } from '../../../web/engine/api/types.ts';

const bytes = (...parts: (number[] | string)[]): Uint8Array =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...part].map((c) => c.charCodeAt(0)) : part)));
const big = (value: number): number[] => [24, 16, 8, 0].map((shift) => (value >>> shift) & 255);
const png = (width: number, height: number): Uint8Array =>
  bytes([0x89], 'PNG\r\n', [0x1a], '\n', big(13), 'IHDR', big(width), big(height), [8, 6, 0, 0, 0]);
const jpeg = (width: number, height: number): Uint8Array =>
  bytes(
    [0xff, 0xd8, 0xff, 0xe0, 0, 6],
    'JFIF',
    [0xff, 0xff, 0xc4, 0, 4, 1, 2, 0xff, 0xc2, 0, 11, 8],
    big(height).slice(2),
    big(width).slice(2),
    [3, 1, 2, 3],
  );
const webp = (chunk: string, body: number[]): Uint8Array =>
  bytes('RIFF', [0, 0, 0, 0], 'WEBP', chunk, [0, 0, 0, 0], body);

describe('the size of an image', () => {
  it('is recognised from the first bytes of every format that browsers read', () => {
    expect(imageSize(png(60_000, 3))).toEqual({ width: 60_000, height: 3 });
    expect(imageSize(jpeg(640, 481))).toEqual({ width: 640, height: 481 });
    expect(imageSize(webp('VP8X', [0, 0, 0, 0, 0xff, 0x3f, 0, 9, 0, 1]))).toEqual({ width: 16_384, height: 65_546 });
    expect(imageSize(webp('VP8 ', [0, 0, 0, 0x9d, 0x01, 0x2a, 0x80, 0x02, 0xe1, 0x01]))).toEqual({
      width: 640,
      height: 481,
    });
    expect(imageSize(webp('VP8L', [0x2f, 0x7f, 0x02, 0x78, 0x00, 0, 0]))).toEqual({ width: 640, height: 481 });
  });

  it('is unknown for other data', () => {
    const whole = [png(3, 4), jpeg(3, 4), webp('VP8X', [0, 0, 0, 0, 2, 0, 0, 3, 0, 0])];
    for (const image of [
      bytes('GIF89a'),
      bytes(),
      png(0, 4),
      webp('ALPH', [0, 0, 0, 0]),
      bytes([0xff, 0xd8, 0xff, 0xda, 0, 2, 0, 0]),
    ])
      expect(imageSize(image)).toBeNull();
    for (const image of whole) {
      expect(imageSize(image)).not.toBeNull();
      for (let length = 0; length < 16; length += 1) expect(imageSize(image.subarray(0, length))).toBeNull();
    }
  });
});

describe('images are drawn', () => {
  const plan = (...sizes: [number, number][]) => {
    const images = sizes.map(([width, height]) => ({ mimeType: 'image/png', bytes: png(width, height) }));
    return drawnImages(
      images,
      sizes.map((_, baseColorImage) => ({ baseColorImage }) as Material),
    );
  };
  const scales = (...sizes: [number, number][]): number[] => plan(...sizes).images.map(({ scale }) => scale);

  it('unchanged up to 4,096 pixels per side, and reduced above', () => {
    expect(scales([1, 1], [4096, 4096], [8192, 2048], [8192, 8192])).toEqual([1, 1, 0.5, 0.5]);
    expect(plan([8192, 8192]).warnings).toEqual([]);
  });

  it("not at all where decoding them would take the tab's memory", () => {
    const { images, warnings } = plan([60_000, 60_000], [64, 64], [8193, 8192]);
    expect(images.map(({ scale }) => scale)).toEqual([0, 1, 0]);
    expect(warnings).toMatchObject([{ code: 'large-texture', count: 2 }]);
  });

  it('up to a total that a page can hold', () => {
    const { images, warnings } = plan(...Array.from({ length: 20 }, (): [number, number] => [8192, 8192]), [64, 64]);
    expect(images.map(({ scale }) => scale)).toEqual([...Array<number>(8).fill(0.5), ...Array<number>(13).fill(0)]);
    expect(warnings).toMatchObject([{ count: 13 }]);
  });

  it('if they colour a material and browsers can read them', () => {
    const images = [png(4, 4), bytes('\xabKTX 20\xbb')].map((image) => ({ mimeType: '', bytes: image }));
    const painted = (baseColorImage: number) => drawnImages(images, [{ baseColorImage, normalImage: 0 } as Material]);
    expect(painted(-1).images.map(({ scale }) => scale)).toEqual([0, 0]);
    expect(painted(-1).warnings).toEqual([]);
    expect(painted(1).warnings).toMatchObject([{ code: 'unknown-texture', count: 1 }]);
  });
});
