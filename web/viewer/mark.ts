/** Highlights faces of a shape in a distinct colour, faintly where the shape hides them. */
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
} from 'three';
import { disposeShared, shareBuffers } from './shared-buffers.ts';
import { Rim } from './studio.ts';
import type { Studio } from './studio.ts';

/**
 * The colour of --mark in the style sheet. It contrasts with blue, green, yellow and grey on light and dark
 * backgrounds, and in lightness with blue.
 */
const COLOUR = 0xd6217e;

export class Mark {
  readonly object = new Group();
  private readonly geometry = new BufferGeometry();
  private readonly seen = new MeshStandardMaterial({
    color: COLOUR,
    emissive: COLOUR,
    emissiveIntensity: 0.3,
    roughness: 0.62,
    side: DoubleSide,
  });
  private readonly hidden = new MeshBasicMaterial({
    color: COLOUR,
    side: DoubleSide,
    transparent: true,
    opacity: 0.55,
    depthFunc: GreaterDepth,
    depthWrite: false,
  });

  /** index: 3 drawn vertices per marked face. */
  constructor(index: Uint32Array, shape: BufferGeometry, studio: Studio, layer: number) {
    this.geometry.setIndex(new BufferAttribute(index, 1));
    shareBuffers(shape, this.geometry);
    studio.install(this.seen, new Rim());
    for (const material of [this.seen, this.hidden]) {
      const mesh = new Mesh(this.geometry, material);
      mesh.frustumCulled = false;
      mesh.layers.set(layer);
      this.object.add(mesh);
    }
  }

  dispose(): void {
    this.object.removeFromParent();
    disposeShared(this.geometry);
    for (const material of [this.seen, this.hidden]) material.dispose();
  }
}
