/** One frame going over into another on the graphics card: positions and normals blended in the vertex shader. */
import type { BufferGeometry, Material } from 'three';
import { extend } from './studio.ts';

const ATTRIBUTES = 'uniform float easing;\nattribute vec3 fromPosition;\nattribute vec3 fromNormal;\n';

export class Easing {
  private readonly uniform = { value: 1 };

  /** How much of the new frame is drawn, in [0, 1]. Without the attributes fromPosition and fromNormal it must be 1. */
  set share(share: number) {
    this.uniform.value = share;
  }

  /** Lets a material draw the blend; call before it is first drawn. */
  install(material: Material): void {
    extend(material, 'easing', (shader) => {
      shader.uniforms['easing'] = this.uniform;
      shader.vertexShader =
        ATTRIBUTES +
        shader.vertexShader
          .replace(
            '#include <beginnormal_vertex>',
            '#include <beginnormal_vertex>\nobjectNormal = mix(fromNormal, objectNormal, easing);',
          )
          .replace(
            '#include <begin_vertex>',
            '#include <begin_vertex>\ntransformed = mix(fromPosition, transformed, easing);',
          );
    });
  }
}

/** Lets another geometry be drawn from a shape's buffers, while it goes over into another frame, too. */
export function shareBuffers(shape: BufferGeometry, other: BufferGeometry): void {
  for (const name of ['position', 'normal', 'fromPosition', 'fromNormal']) {
    const attribute = shape.getAttribute(name);
    if (attribute) other.setAttribute(name, attribute);
  }
}

/** Gives back what another geometry has of its own; the shape's buffers stay on the graphics card. */
export function disposeShared(other: BufferGeometry): void {
  for (const name of Object.keys(other.attributes)) other.deleteAttribute(name);
  other.dispose();
}
