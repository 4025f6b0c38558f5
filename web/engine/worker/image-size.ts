/**
 * Image sizes, read from the first bytes before a browser decodes the image. A small file may declare any size, and a
 * decoder uses 4 bytes per declared pixel.
 */
import { NO_PLACE } from '../api/types.ts';
import type { Material, TextureImage, Warning } from '../api/types.ts';

export interface Size {
  width: number;
  height: number;
}

/** Largest number of pixels of one decoded image: 8,192 x 8,192, 256 MB. */
export const MAX_PIXELS = 2 ** 26;
/** Larger sides are scaled down, which is invisible on a screen. */
export const LARGEST_SIDE = 4096;
/** Largest total number of pixels kept for drawing. */
export const MAX_PIXELS_KEPT = 2 ** 27;

export function imageSize(bytes: Uint8Array): Size | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    const size = pngSize(view) ?? jpegSize(view) ?? webpSize(view);
    return size && size.width > 0 && size.height > 0 ? size : null;
  } catch {
    return null; // the image is truncated in its header
  }
}

/** Signature, then the chunk IHDR, which comes first (PNG 1.2, section 4.1.1). */
function pngSize(view: DataView): Size | null {
  if (view.getUint32(0) !== 0x89504e47) return null;
  return { width: view.getUint32(16), height: view.getUint32(20) };
}

/** The first frame header, after any other segments (ITU T.81, annex B). */
function jpegSize(view: DataView): Size | null {
  if (view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; ; ) {
    const marker = view.getUint16(at);
    const isFrame = marker >= 0xffc0 && marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker);
    if (isFrame) return { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    if (marker < 0xff00 || marker === 0xffda) return null;
    at += marker === 0xffff ? 1 : 2 + view.getUint16(at + 2); // 0xff may be repeated before a marker
  }
}

/** Lossy, lossless or extended, by the first chunk (RFC 9649). */
function webpSize(view: DataView): Size | null {
  if (view.getUint32(0) !== 0x52494646 || view.getUint32(8) !== 0x57454250) return null;
  const uint24 = (at: number): number => view.getUint16(at, true) + 65536 * view.getUint8(at + 2);
  switch (view.getUint32(12)) {
    case 0x56503858:
      return { width: uint24(24) + 1, height: uint24(27) + 1 };
    case 0x56503820:
      return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
    case 0x5650384c: {
      const bits = view.getUint32(21, true);
      return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
    }
    default:
      return null;
  }
}

type Encoded = Pick<TextureImage, 'mimeType' | 'bytes'>;

/** Selects the colour images of materials that can be drawn, with their sizes. The other images give warnings. */
export function drawnImages(
  images: readonly Encoded[],
  materials: readonly Material[],
): { images: TextureImage[]; warnings: Warning[] } {
  const used = new Set(materials.map(({ baseColorImage }) => baseColorImage));
  const refused = { 'large-texture': 0, 'unknown-texture': 0 };
  let left = MAX_PIXELS_KEPT;
  const planned = images.map((image, index) => {
    if (!used.has(index)) return { ...image, scale: 0 };
    const size = imageSize(image.bytes);
    if (!size) refused['unknown-texture'] += 1;
    const scale = size ? scaleOf(size) : 0;
    const pixels = size ? size.width * size.height * scale * scale : 0;
    if (size && (scale === 0 || pixels > left)) {
      refused['large-texture'] += 1;
      return { ...image, scale: 0 };
    }
    left -= pixels;
    return { ...image, scale };
  });
  return {
    images: planned,
    warnings: Object.entries(refused).flatMap(([code, count]) => (count > 0 ? [warning(code, count)] : [])),
  };
}

function scaleOf({ width, height }: Size): number {
  return width * height > MAX_PIXELS ? 0 : Math.min(1, LARGEST_SIDE / Math.max(width, height));
}

function warning(code: string, count: number): Warning {
  const what =
    code === 'large-texture'
      ? `textures of more than ${Math.round(MAX_PIXELS / 1e6)} million pixels, and those that exceed ${Math.round(MAX_PIXELS_KEPT / 1e6)} million in total,`
      : 'textures that are cut off, or in a format that browsers cannot read,';
  return {
    ...NO_PLACE,
    code,
    count,
    message: `The shape is drawn without some of its textures: ${what} are not shown. The exported file keeps them.`,
  };
}
