/**
 * Light and surface finish of the studio. The environment is a formula instead of an image: a soft sky over a warm
 * ground, and three soft boxes. Each box is a spherical Gaussian, wider and dimmer on rough surfaces. It costs nothing
 * before the first image, and less per pixel than lamps.
 */
import { Color, Vector3 } from 'three';
import type { Material, PerspectiveCamera, WebGLProgramParametersWithUniforms } from 'three';

interface Box {
  /** Direction of the light: in the world, or relative to the eye (right, up, back). */
  from: readonly [number, number, number];
  seenFromEye: boolean;
  /** Larger values make a smaller box. */
  sharpness: number;
  colour: number;
  light: number;
  dark: number;
}

/** Key light from above, fill light beside the eye, and strip light behind the shape, so no side is dark. */
const BOXES: readonly Box[] = [
  { from: [0.5, 1.2, 0.7], seenFromEye: false, sharpness: 7, colour: 0xfff3e4, light: 3.3, dark: 3.3 },
  { from: [-1, 0.25, 0.55], seenFromEye: true, sharpness: 5, colour: 0xe4edff, light: 1, dark: 0.9 },
  { from: [0.45, 0.75, -0.8], seenFromEye: true, sharpness: 16, colour: 0xffffff, light: 2, dark: 2.4 },
];
const SKY = { colour: 0xf4f7ff, light: 0.76, dark: 0.62 };
const GROUND = { colour: 0xcfc4b8, light: 0.34, dark: 0.24 };
/** Sharpness of the lobe over which a matt surface gathers light. */
const MATT = 2.1;

export class Studio {
  private readonly towards = BOXES.map(() => new Vector3());
  private readonly uniforms = {
    studioUp: { value: new Vector3(0, 1, 0) },
    studioSky: { value: new Color() },
    studioGround: { value: new Color() },
    studioTowards: { value: this.towards },
    studioColour: { value: BOXES.map(() => new Color()) },
    studioSharpness: { value: BOXES.map(({ sharpness }) => sharpness) },
  };

  constructor() {
    this.setDark(false);
  }

  setDark(dark: boolean): void {
    const lit = (into: Color, { colour, light, dark: dim }: { colour: number; light: number; dark: number }): Color =>
      into.set(colour).multiplyScalar(dark ? dim : light);
    lit(this.uniforms.studioSky.value, SKY);
    lit(this.uniforms.studioGround.value, GROUND);
    BOXES.forEach((box, index) => {
      lit(this.uniforms.studioColour.value[index]!, box);
    });
  }

  /** Call before each drawn frame, because light directions are in eye coordinates. */
  follow(camera: PerspectiveCamera): void {
    camera.updateMatrixWorld();
    this.uniforms.studioUp.value.set(0, 1, 0).transformDirection(camera.matrixWorldInverse);
    BOXES.forEach(({ from, seenFromEye }, index) => {
      const towards = this.towards[index]!.set(...from).normalize();
      if (!seenFromEye) towards.transformDirection(camera.matrixWorldInverse);
    });
  }

  /** Lights a MeshStandardMaterial; `rim` is the colour of its outline. Call before it is first drawn. */
  install(material: Material, rim: Rim): void {
    extend(material, 'studio', (shader) => {
      Object.assign(shader.uniforms, this.uniforms, rim.uniforms);
      shader.fragmentShader = DECLARED + shader.fragmentShader;
      for (const [after, code] of INSERTED)
        shader.fragmentShader = shader.fragmentShader.replace(`#include <${after}>`, code);
    });
  }
}

/** Colour and strength of the outline, which shows the phase. */
export class Rim {
  readonly uniforms = { rimColour: { value: new Color() }, rimStrength: { value: 0 } };

  set(colour: string, strength: number): void {
    this.uniforms.rimColour.value.set(colour);
    this.uniforms.rimStrength.value = strength;
  }
}

/** Adds a change to a material's shader, after earlier changes; `name` distinguishes programs. */
export function extend(
  material: Material,
  name: string,
  change: (shader: WebGLProgramParametersWithUniforms) => void,
): void {
  const before = material.onBeforeCompile;
  const key = Object.hasOwn(material, 'customProgramCacheKey') ? material.customProgramCacheKey() : '';
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    change(shader);
  };
  material.customProgramCacheKey = () => `${key} ${name}`;
}

const DECLARED = `
uniform vec3 studioUp;
uniform vec3 studioSky;
uniform vec3 studioGround;
uniform vec3 studioTowards[${BOXES.length}];
uniform vec3 studioColour[${BOXES.length}];
uniform float studioSharpness[${BOXES.length}];
uniform vec3 rimColour;
uniform float rimStrength;

/* Light that a lobe about a direction gathers; 'lobe' is its sharpness. */
vec3 studioLight(vec3 direction, float lobe) {
  vec3 light = mix(studioGround, studioSky, 0.5 + 0.5 * dot(direction, studioUp));
  for (int i = 0; i < ${BOXES.length}; i ++) {
    float both = studioSharpness[i] * lobe / (studioSharpness[i] + lobe);
    light += studioColour[i] * (both / studioSharpness[i]) * exp(both * (dot(direction, studioTowards[i]) - 1.0));
  }
  return light;
}

/* The tone mapping Khronos PBR Neutral, which keeps base colours and compresses highlights. */
vec3 filmic(vec3 colour) {
  float least = min(colour.r, min(colour.g, colour.b));
  colour -= least < 0.08 ? least - 6.25 * least * least : 0.04;
  float peak = max(colour.r, max(colour.g, colour.b));
  if (peak < 0.76) return colour;
  float rolled = 1.0 - 0.0576 / (peak - 0.52);
  colour *= rolled / peak;
  return mix(colour, vec3(rolled), 1.0 - 1.0 / (0.15 * (peak - rolled) + 1.0));
}
`;

const INSERTED: readonly (readonly [string, string])[] = [
  [
    'normal_fragment_maps',
    // Along the outline, an interpolated normal can face away from the eye and make a dark pixel.
    `#include <normal_fragment_maps>
    {
      vec3 toEye = normalize(vViewPosition);
      normal = normalize(normal - min(dot(normal, toEye) - 0.02, 0.0) * toEye);
    }`,
  ],
  [
    'lights_fragment_maps',
    `#include <lights_fragment_maps>
    iblIrradiance += PI * studioLight(geometryNormal, ${MATT.toFixed(1)});
    radiance += studioLight(reflect(-geometryViewDir, geometryNormal), 2.0 / pow4(max(material.roughness, 0.1)));`,
  ],
  [
    'opaque_fragment',
    `outgoingLight = filmic(outgoingLight);
    {
      float edge = 1.0 - saturate(dot(normal, normalize(vViewPosition)));
      outgoingLight = mix(outgoingLight, rimColour, rimStrength * pow4(edge));
    }
    #include <opaque_fragment>`,
  ],
];
