/**
 * Light and ground: a soft three-point light without image files, a floor that only shows shadow, a grid that fades.
 */
import {
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
  Vector3,
} from 'three';
import type { PerspectiveCamera } from 'three';

/** What the stage is made for: the box around all keys. */
export interface Bounds {
  min: [number, number, number];
  max: [number, number, number];
}

export class Stage {
  readonly object = new Group();
  private readonly sky = new HemisphereLight(0xffffff, 0xb9b4ac, 1.15);
  private readonly key = new DirectionalLight(0xfff6ea, 1.9);
  private readonly fill = new DirectionalLight(0xdfe9ff, 0.55);
  private readonly rim = new DirectionalLight(0xffffff, 0.9);
  private readonly shadow = new ShadowMaterial({ opacity: 0.2, depthWrite: false });
  private readonly grid = gridMaterial();
  private readonly floor = new Group();

  constructor() {
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(1024, 1024);
    this.key.shadow.radius = 6;
    const plane = new PlaneGeometry(1, 1);
    plane.rotateX(-Math.PI / 2);
    const ground = new Mesh(plane, this.shadow);
    ground.receiveShadow = true;
    const lines = new Mesh(plane, this.grid);
    lines.renderOrder = -2;
    ground.renderOrder = -1;
    this.floor.add(lines, ground);
    this.object.add(
      this.sky,
      this.key,
      this.key.target,
      this.fill,
      this.fill.target,
      this.rim,
      this.rim.target,
      this.floor,
    );
  }

  /** Puts lights and floor around the shape; everything scales with it. */
  setBounds({ min, max }: Bounds): void {
    const size = new Vector3(...max).sub(new Vector3(...min));
    const centre = new Vector3(...min).addScaledVector(size, 0.5);
    const radius = Math.max(size.length() / 2, 1e-6);
    this.key.position.copy(centre).add(new Vector3(0.55, 1.25, 0.8).multiplyScalar(2.4 * radius));
    this.key.target.position.copy(centre);
    const camera = this.key.shadow.camera;
    camera.left = camera.bottom = -1.9 * radius;
    camera.right = camera.top = 1.9 * radius;
    camera.near = 0.2 * radius;
    camera.far = 9 * radius;
    camera.updateProjectionMatrix();
    this.key.shadow.normalBias = 0.01 * radius;
    this.floor.position.set(centre.x, min[1] - 0.002 * radius, centre.z);
    this.floor.scale.setScalar(10 * radius);
    this.grid.uniforms['cell']!.value = gridCell(radius) / (10 * radius);
  }

  /** Fill and rim follow the eye, so that no side of the shape is ever dark. */
  follow(camera: PerspectiveCamera, target: Vector3): void {
    const toEye = camera.position.clone().sub(target);
    const side = new Vector3().crossVectors(camera.up, toEye);
    this.fill.position.copy(target).add(toEye).addScaledVector(side, -0.9);
    this.fill.target.position.copy(target);
    this.rim.position
      .copy(target)
      .addScaledVector(toEye, -0.8)
      .addScaledVector(camera.up, toEye.length() * 0.9)
      .addScaledVector(side, 0.4);
    this.rim.target.position.copy(target);
  }

  setLook(floor: boolean, dark: boolean): void {
    this.floor.visible = floor;
    // Only the floor shows shadow.
    this.key.castShadow = floor;
    this.shadow.opacity = dark ? 0.42 : 0.17;
    (this.grid.uniforms['colour']!.value as Color).set(dark ? 0xffffff : 0x27313c);
    this.grid.uniforms['strength']!.value = dark ? 0.09 : 0.1;
    this.sky.intensity = dark ? 0.95 : 1.15;
  }
}

/** 1, 2 or 5 times a power of ten, about a quarter of the shape. */
function gridCell(radius: number): number {
  const wanted = radius / 2;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = wanted / power;
  return power * (digit < 2 ? 1 : digit < 5 ? 2 : 5);
}

function gridMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: { cell: { value: 0.1 }, colour: { value: new Color(0) }, strength: { value: 0.12 } },
    vertexShader: `
      varying vec2 place;
      void main() {
        place = position.xz;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform float cell;
      uniform float strength;
      uniform vec3 colour;
      varying vec2 place;
      void main() {
        vec2 at = place / cell;
        vec2 width = fwidth(at);
        vec2 distance = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
        float line = 1.0 - min(min(distance.x, distance.y), 1.0);
        // Far lines are closer than a pixel: fade before they turn into a moire pattern.
        float dense = 1.0 - smoothstep(0.15, 0.6, max(width.x, width.y));
        float fade = 1.0 - smoothstep(0.05, 0.48, length(place));
        gl_FragColor = vec4(colour, line * dense * fade * strength);
      }`,
  });
}
