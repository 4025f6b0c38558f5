/** Input and output of the viewer: plain data, so other code does not need three.js. */
import type { KeysInfo } from '../engine/api/types.ts';

export interface Look {
  /** `texture`: the file's own materials, or clay without any. */
  /** Heat maps have separate colours. A shape without them, such as a thumbnail, is drawn as `texture`. */
  colouring: 'texture' | 'phase' | 'patches' | 'rotation' | 'stretch' | 'distance';
  shading: 'smooth' | 'flat';
  wireframe: boolean;
  floor: boolean;
  dark: boolean;
}

/** An additional shape: an onion skin, or one of a film strip. */
export interface Extra {
  /** Positions and normals, 3 x vertices each; copied. */
  positions: Float32Array;
  normals: Float32Array;
  colour: string;
  /** Opacity from 0 to 1. */
  opacity: number;
  /** Displacement of the shape along x. */
  offset: number;
}

/** The first key of an import whose motion is still being made. */
export interface FirstKey {
  info: KeysInfo;
  /** Positions and normals, 3 x vertices each; copied. */
  positions: Float32Array;
  normals: Float32Array;
  colour: string;
}

/** The ghost mesh at a time. */
export interface GhostPicture {
  /** Vertex indices, 3 x ghost faces; the same array while the mesh stays the same. */
  faces: Uint32Array;
  /** Vertex of the shape for each ghost vertex. */
  vertexOf: Int32Array;
  /** Positions, 3 x ghost vertices; copied. */
  positions: Float32Array;
  /** Show its wireframe over the shape. */
  overlay: boolean;
  /** Displacement along x beside the shape, with lines between both; null: hidden. */
  offset: number | null;
}

/** A ray in the shapes' coordinates. */
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
