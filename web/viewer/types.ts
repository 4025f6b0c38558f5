/** What the viewer is given and gives back: plain data, so that nobody else needs three.js. */
import type { KeysInfo } from '../engine/api/types.ts';

export interface Look {
  /** `texture`: the file's own materials, or clay where it has none. */
  /** Amounts come as colours of their own; a shape without these, such as a thumbnail, looks like `texture`. */
  colouring: 'texture' | 'phase' | 'patches' | 'rotation' | 'stretch' | 'distance';
  shading: 'smooth' | 'flat';
  wireframe: boolean;
  floor: boolean;
  dark: boolean;
}

/** A further shape in the picture: an onion skin or one of a film strip. */
export interface Extra {
  /** 3 x vertices each; copied. */
  positions: Float32Array;
  normals: Float32Array;
  colour: string;
  /** 1 is solid. */
  opacity: number;
  /** How far along x it stands from where it is. */
  offset: number;
}

/** The first key of an import whose motion is still being made. */
export interface FirstKey {
  info: KeysInfo;
  /** 3 x vertices each; copied. */
  positions: Float32Array;
  normals: Float32Array;
  colour: string;
}

/** The ghost mesh at a moment. */
export interface GhostPicture {
  /** 3 x ghost faces; the same array as long as it is the same mesh. */
  faces: Uint32Array;
  /** Vertex of the shape for each ghost vertex. */
  vertexOf: Int32Array;
  /** 3 x ghost vertices; copied. */
  positions: Float32Array;
  /** Its wireframe over the shape. */
  overlay: boolean;
  /** How far along x it stands beside the shape, with lines between them; null = not there. */
  offset: number | null;
}

/** In the shapes' own space. */
export interface Ray {
  origin: readonly [number, number, number];
  direction: readonly [number, number, number];
}

/** Part of the canvas, in CSS pixels from its top left corner. */
export interface Rect {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface PixelSize {
  width: number;
  height: number;
}
