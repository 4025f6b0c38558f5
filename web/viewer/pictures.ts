/** Small pictures of a shape that is not open: in its own materials, from where it would be seen. */
import type { WebGLRenderer } from 'three';
import type { KeysInfo } from '../engine/api/types.ts';
import type { Extent } from './fit.ts';
import { Shape, topologyOf } from './shape.ts';
import type { Topology } from './shape.ts';
import type { Studio } from './studio.ts';
import { decodeTextures } from './textures.ts';
import { Thumbnails } from './thumbnails.ts';
import type { Look } from './types.ts';

export class Pictures {
  private readonly topology: Topology;
  private readonly shape: Shape;
  private readonly thumbnails: Thumbnails;

  static async of(info: KeysInfo, extent: Extent, renderer: WebGLRenderer, studio: Studio): Promise<Pictures> {
    const topology = topologyOf(info);
    topology.textures = await decodeTextures(info.scene.images, info.scene.materials);
    return new Pictures(topology, extent, renderer, studio);
  }

  private constructor(topology: Topology, extent: Extent, renderer: WebGLRenderer, studio: Studio) {
    this.topology = topology;
    this.shape = new Shape(topology, studio);
    this.thumbnails = new Thumbnails(renderer, studio);
    this.thumbnails.setExtent(extent);
  }

  /** Width and height in CSS pixels; null where the browser gives no canvas. */
  draw(
    positions: Float32Array,
    normals: Float32Array,
    width: number,
    height: number,
    dark: boolean,
  ): HTMLCanvasElement | null {
    const look: Look = { colouring: 'texture', shading: 'smooth', wireframe: false, floor: false, dark };
    this.shape.setFrame(positions, normals);
    this.shape.setLook(look);
    this.shape.setColour(RIM);
    return this.thumbnails.canvas(this.shape, width, height);
  }

  dispose(): void {
    this.shape.dispose();
    for (const texture of this.topology.textures) texture?.dispose();
  }
}

/** The outline of a picture that is of no moment in particular. */
const RIM = '#7d848c';
