/**
 * The shadow of a shape on the floor: a blurred view from below, darker for closer parts. It is one small image,
 * redrawn only when the casters change.
 */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Mesh,
  NoBlending,
  OrthographicCamera,
  Scene,
  ShaderMaterial,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import type { Texture, Vector3, WebGLRenderer } from 'three';

import { makePrograms } from './programs.ts';

/** Casters of a layer are also on the layer with this offset. */
export const CASTER_LAYERS = 16;
const PIXELS = 192;
/** Half the side of the shadow's area, and the height up to which parts cast it, in radii of the shape. */
export const REACH = 2;
const HEIGHT = 1.5;

export class ContactShadow {
  private readonly camera = new OrthographicCamera();
  private readonly depth = depthMaterial();
  private readonly blur = blurMaterial();
  private readonly targets = [0, 1].map(() => new WebGLRenderTarget(PIXELS, PIXELS));
  private readonly screen = new Scene();
  private readonly triangle = new BufferGeometry();
  private shown = '';

  constructor() {
    this.triangle.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const mesh = new Mesh(this.triangle, this.blur);
    mesh.frustumCulled = false;
    mesh.layers.enableAll();
    this.screen.add(mesh);
  }

  get texture(): Texture {
    return this.targets[0]!.texture;
  }

  setBounds(centre: Vector3, floor: number, radius: number): void {
    const { camera } = this;
    camera.left = camera.bottom = -REACH * radius;
    camera.right = camera.top = REACH * radius;
    camera.near = -0.02 * radius;
    camera.far = HEIGHT * radius;
    camera.position.set(centre.x, floor, centre.z);
    camera.up.set(0, 0, 1);
    camera.lookAt(centre.x, floor + 1, centre.z);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.depth.uniforms['height']!.value = camera.far;
    this.shown = '';
  }

  /** Draws the shadow again at the next `render`. Call after the graphics context was restored. */
  forget(): void {
    this.shown = '';
  }

  /** Compiles the programs before the first shadow; see makePrograms. */
  async compile(renderer: WebGLRenderer): Promise<void> {
    const caster = new Mesh(this.triangle, this.depth);
    renderer.setRenderTarget(this.targets[0]!);
    const both = [this.screen, caster].map((object) => makePrograms(renderer, object, this.camera));
    renderer.setRenderTarget(null);
    await Promise.all(both);
  }

  /** `layers`: the layers of the view; `version`: changes with the casters. */
  render(renderer: WebGLRenderer, scene: Scene, layers: number, version: number): void {
    const wanted = `${layers} ${version}`;
    if (wanted === this.shown) return;
    this.shown = wanted;
    const [seen, other] = this.targets as [WebGLRenderTarget, WebGLRenderTarget];
    const ground = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setClearColor(0x000000, 0);
    this.camera.layers.mask = layers << CASTER_LAYERS;
    scene.overrideMaterial = this.depth;
    renderer.setRenderTarget(seen);
    renderer.clear();
    renderer.render(scene, this.camera);
    scene.overrideMaterial = null;
    this.blurInto(renderer, seen, other, new Vector2(1 / PIXELS, 0));
    this.blurInto(renderer, other, seen, new Vector2(0, 1 / PIXELS));
    renderer.setRenderTarget(null);
    renderer.setClearColor(ground, alpha);
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
    this.triangle.dispose();
    for (const material of [this.depth, this.blur]) material.dispose();
  }

  private blurInto(renderer: WebGLRenderer, from: WebGLRenderTarget, to: WebGLRenderTarget, step: Vector2): void {
    this.blur.uniforms['picture']!.value = from.texture;
    this.blur.uniforms['step']!.value = step;
    renderer.setRenderTarget(to);
    renderer.render(this.screen, this.camera);
  }
}

function depthMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    side: DoubleSide,
    blending: NoBlending,
    uniforms: { height: { value: 1 } },
    vertexShader: `
      uniform float height;
      varying float above;
      void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        above = -place.z / height;
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: `
      varying float above;
      void main() {
        float near = 1.0 - clamp(above, 0.0, 1.0);
        gl_FragColor = vec4(near * near * near);
      }`,
  });
}

/** Nine samples along a line with Gaussian weights. */
function blurMaterial(): ShaderMaterial {
  const weights = Array.from({ length: 5 }, (_, i) => Math.exp(-((i / 2.4) ** 2)));
  const sum = 2 * weights.reduce((total, weight) => total + weight, 0) - 1;
  const taps = weights.slice(1).map((weight, i) => {
    const away = `${(1.5 * (i + 1)).toFixed(1)} * step`;
    return `sum += ${(weight / sum).toFixed(6)} * (texture2D(picture, at + ${away}).r + texture2D(picture, at - ${away}).r);`;
  });
  return new ShaderMaterial({
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
    uniforms: { picture: { value: null }, step: { value: new Vector2() } },
    vertexShader: `
      varying vec2 at;
      void main() {
        at = 0.5 * position.xy + 0.5;
        gl_Position = vec4(position.xy, 0.0, 1.0);
      }`,
    fragmentShader: `
      uniform sampler2D picture;
      uniform vec2 step;
      varying vec2 at;
      void main() {
        float sum = ${(1 / sum).toFixed(6)} * texture2D(picture, at).r;
        ${taps.join('\n        ')}
        gl_FragColor = vec4(sum);
      }`,
  });
}
