/** A QR code: its modules as one SVG path, with the quiet zone that scanners need. */

export interface Modules {
  /** Length of a side in modules. */
  readonly size: number;
  get(x: number, y: number): boolean;
}

/** Light modules on every side (ISO/IEC 18004). */
export const QUIET = 4;

export function qrPath({ size, get }: Modules): string {
  let path = '';
  for (let y = 0; y < size; y += 1) {
    for (let x = 0; x < size; x += 1) {
      if (!get(x, y)) continue;
      const start = x;
      while (get(x + 1, y)) x += 1;
      const width = x + 1 - start;
      path += `M${start + QUIET} ${y + QUIET}h${width}v1h-${width}z`;
    }
  }
  return path;
}
