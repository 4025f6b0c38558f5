/** The floor: a fading grid, the shape's shadow, and a ring in the phase colour. */
import { Color, Group, Mesh, PlaneGeometry, SRGBColorSpace, ShaderMaterial, Vector2, Vector3 } from 'three';
import type { Camera, Scene, WebGLRenderer } from 'three';
import { makePrograms } from './programs.ts';
import { ContactShadow, REACH } from './contact-shadow.ts';

/** Bounds of the shape on the floor: the box around all keys. */
export interface Bounds {
  min: [number, number, number];
  max: [number, number, number];
  /** Circle on the floor around the points that touch it. */
  foot: { x: number; z: number; radius: number };
}

/** Side of the floor in radii of the shape. */
const SIDE = 10;
/** Radius of the ring on the floor: at most this share of half the box's diagonal on the floor. */
const MAX_RING = 0.94;
/** Radius of the ring in radii of the foot, and its least value in radii of the shape. */
const [FOOT_RING, MIN_RING] = [1.15, 0.15];

export class Floor {
  readonly object = new Group();
  private readonly shadow = new ContactShadow();
  private readonly material = floorMaterial();
  private readonly mesh: Mesh;

  constructor() {
    const plane = new PlaneGeometry(1, 1);
    plane.rotateX(-Math.PI / 2);
    this.mesh = new Mesh(plane, this.material);
    this.mesh.renderOrder = -1;
    this.object.add(this.mesh);
    this.set('shadow', this.shadow.texture);
  }

  /** Puts the floor under the shape and scales it with the shape. */
  setBounds({ min, max, foot }: Bounds): void {
    const size = new Vector3(...max).sub(new Vector3(...min));
    const centre = new Vector3(...min).addScaledVector(size, 0.5);
    const radius = Math.max(size.length() / 2, 1e-6);
    const level = min[1] - 0.002 * radius;
    this.shadow.setBounds(centre, level, radius);
    this.mesh.position.set(centre.x, level, centre.z);
    this.mesh.scale.setScalar(SIDE * radius);
    this.mesh.updateMatrixWorld();
    this.set('cell', gridCell(radius) / (SIDE * radius));
    const around = Math.max(FOOT_RING * foot.radius, MIN_RING * radius);
    this.set('ring', Math.min(around, (MAX_RING * Math.hypot(size.x, size.z)) / 2) / (SIDE * radius));
    this.set('ringCentre', new Vector2(foot.x - centre.x, foot.z - centre.z).divideScalar(SIDE * radius));
  }

  /** The phase colour; null if several phases are shown. */
  setPhase(colour: string | null): void {
    if (colour !== null) this.set('ringColour', raw(colour));
    this.set('ringStrength', colour === null ? 0 : 1);
  }

  /** Call after the graphics context was restored. */
  restore(): void {
    this.shadow.forget();
  }

  /** Compiles the programs of floor and shadow; see makePrograms. */
  async compile(renderer: WebGLRenderer, camera: Camera): Promise<void> {
    await Promise.all([makePrograms(renderer, this.mesh, camera), this.shadow.compile(renderer)]);
  }

  /** Call before each drawn frame; see ContactShadow.render. */
  prepare(renderer: WebGLRenderer, scene: Scene, layers: number, version: number): void {
    if (this.mesh.visible) this.shadow.render(renderer, scene, layers, version);
  }

  setLook(floor: boolean, dark: boolean): void {
    this.mesh.visible = floor;
    this.set('darkness', dark ? 0.62 : 0.4);
    this.set('gridColour', raw(dark ? '#ffffff' : '#0a0f16'));
    this.set('gridStrength', dark ? 0.09 : 0.1);
  }

  dispose(): void {
    this.shadow.dispose();
    this.mesh.geometry.dispose();
    this.material.dispose();
  }

  private set(name: string, value: unknown): void {
    this.material.uniforms[name]!.value = value;
  }
}

/** Colour values as in a style sheet: the floor mixes such colours and draws them without conversion. */
function raw(colour: string): Vector3 {
  const { r, g, b } = new Color(colour).getRGB({ r: 0, g: 0, b: 0 }, SRGBColorSpace);
  return new Vector3(r, g, b);
}

/** Grid spacing: 1, 2 or 5 times a power of ten, about a quarter of the shape. */
function gridCell(radius: number): number {
  const wanted = radius / 2;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = wanted / power;
  return power * (digit < 2 ? 1 : digit < 5 ? 2 : 5);
}

/** Draws everything on the floor in one pass. */
function floorMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    premultipliedAlpha: true,
    uniforms: {
      cell: { value: 0.1 },
      gridColour: { value: new Vector3() },
      gridStrength: { value: 0.1 },
      shadow: { value: null },
      darkness: { value: 0.4 },
      ring: { value: 0.1 },
      ringCentre: { value: new Vector2() },
      ringColour: { value: new Vector3() },
      ringStrength: { value: 0 },
    },
    vertexShader: `
      varying vec2 place;
      void main() {
        place = position.xz;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform float cell;
      uniform float gridStrength;
      uniform vec3 gridColour;
      uniform sampler2D shadow;
      uniform float darkness;
      uniform float ring;
      uniform vec2 ringCentre;
      uniform vec3 ringColour;
      uniform float ringStrength;
      varying vec2 place;

      vec4 over(vec4 below, vec3 colour, float alpha) {
        return vec4(colour * alpha, alpha) + (1.0 - alpha) * below;
      }

      void main() {
        float away = length(place);
        vec2 at = place / cell;
        vec2 width = fwidth(at);
        vec2 distance = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
        float line = 1.0 - min(min(distance.x, distance.y), 1.0);
        // Far lines are closer than a pixel: fade before they turn into a moire pattern.
        float dense = 1.0 - smoothstep(0.15, 0.6, max(width.x, width.y));
        float fade = 1.0 - smoothstep(0.05, 0.48, away);
        vec4 colour = over(vec4(0.0), gridColour, line * dense * fade * gridStrength);

        float outside = length(place - ringCentre) - ring;
        float pixel = fwidth(outside);
        float band = 0.0009 + pixel;
        float solid = 1.0 - smoothstep(band - pixel, band, abs(outside));
        float glow = outside < 0.0 ? 0.07 * exp(outside * 40.0) : 0.0;
        colour = over(colour, ringColour, max(0.9 * solid, glow) * ringStrength);

        vec2 under = place * ${(SIDE / (2 * REACH)).toFixed(4)} + 0.5;
        float inside = step(max(abs(under.x - 0.5), abs(under.y - 0.5)), 0.5);
        gl_FragColor = over(colour, vec3(0.0), darkness * inside * texture2D(shadow, under).r);
      }`,
  });
}
