/** One drawn shape: buffers for the frames, and materials for its colourings. */
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  Mesh,
  MeshStandardMaterial,
} from 'three';
import type { Material as ThreeMaterial, Texture } from 'three';
import type { KeysInfo, Material, Scene } from '../engine/api/types.ts';
import { CASTER_LAYERS } from './contact-shadow.ts';
import { Mark } from './mark.ts';
import { Rim } from './studio.ts';
import type { Studio } from './studio.ts';
import type { Look } from './types.ts';
import { Wire, edgesOf } from './wire.ts';

/** Colour of surfaces without a material. */
const CLAY = '#c9b5a4';
/** Strength of the phase colour in the outline. */
const RIM = 0.95;

/** Data shared by the shapes of an import: everything except vertex positions. */
export interface Topology {
  vertices: number;
  scene: Scene;
  index: BufferAttribute;
  uv: BufferAttribute | null;
  /** The file's own colours without opacity, 3 x vertices. */
  tint: Float32Array | null;
  /** One texture per material; empty while textures are being decoded. */
  textures: (Texture | null)[];
}

/** One triangle without area per material group, drawn with the shape's materials. */
export function triangleOf({ scene, uv, tint, textures }: Topology): Topology {
  return {
    vertices: 3,
    scene: { ...scene, seams: null, groups: scene.groups.map((group) => ({ ...group, start: 0, count: 1 })) },
    index: new BufferAttribute(new Uint32Array([0, 1, 2]), 1),
    uv: uv && new BufferAttribute(new Float32Array(6), 2),
    tint: tint && new Float32Array(9),
    textures,
  };
}

export function topologyOf({ report, faces, scene }: KeysInfo): Topology {
  return {
    vertices: report.vertices,
    scene,
    index: new BufferAttribute(scene.seams?.indices ?? faces, 1),
    uv: scene.uvs && new BufferAttribute(scene.uvs, 2),
    tint: scene.colors && withoutAlpha(scene.colors),
    textures: [],
  };
}

export class Shape {
  readonly object = new Group();
  private readonly geometry = new BufferGeometry();
  private readonly rim = new Rim();
  private clay = false;
  private rimmed = false;
  private readonly position: BufferAttribute;
  private readonly normal: BufferAttribute;
  private readonly plain = new MeshStandardMaterial({
    roughness: 0.6,
    metalness: 0,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  private textured: MeshStandardMaterial[] = [];
  /** The textures in use; textures arrive later than the shape. */
  private texturedBy: Topology['textures'] | null = null;
  private patchColours: Float32Array | null = null;
  private heatColours: Float32Array | null = null;
  private mark: Mark | null = null;
  private readonly mesh: Mesh;
  /** Created on first use. */
  private wire: Wire | null = null;

  /** Visible to cameras with this layer. */
  constructor(
    private readonly topology: Topology,
    private readonly studio: Studio,
    private readonly layer = 0,
  ) {
    const drawn = topology.vertices + (topology.scene.seams?.copyOf.length ?? 0);
    this.position = dynamic(drawn);
    this.normal = dynamic(drawn);
    this.geometry.setIndex(topology.index);
    this.geometry.setAttribute('position', this.position);
    this.geometry.setAttribute('normal', this.normal);
    if (topology.uv) this.geometry.setAttribute('uv', topology.uv);
    topology.scene.groups.forEach(({ start, count }, index) => this.geometry.addGroup(start * 3, count * 3, index));
    this.mesh = new Mesh(this.geometry, this.plain);
    studio.install(this.plain, this.rim);
    this.mesh.frustumCulled = false;
    this.mesh.layers.set(layer);
    this.mesh.layers.enable(layer + CASTER_LAYERS);
    this.object.add(this.mesh);
  }

  /** The mesh without its wireframe. */
  get surface(): Mesh {
    return this.mesh;
  }

  /** The drawn positions, 3 x vertices. A view, valid until the next frame. */
  get positions(): Float32Array {
    return (this.position.array as Float32Array).subarray(0, 3 * this.topology.vertices);
  }

  setFrame(positions: Float32Array, normals: Float32Array): void {
    this.fill(this.position, positions);
    this.fill(this.normal, normals);
  }

  /** Colours by patch: 3 x vertices, linear RGB in [0, 1]; null removes them. */
  setPatchColours(colours: Float32Array | null): void {
    this.patchColours = colours;
  }

  /** Heat map colours, which override every other colouring; same format. */
  setHeatColours(colours: Float32Array | null): void {
    this.heatColours = colours;
  }

  /** Marks faces, 3 drawn vertices each, over every colouring; null removes the mark. */
  setMark(index: Uint32Array | null): void {
    this.mark?.dispose();
    this.mark = index && new Mark(index, this.geometry, this.studio, this.layer);
    if (this.mark) this.object.add(this.mark.object);
  }

  setLook(look: Look): void {
    const own = look.colouring !== 'phase' && look.colouring !== 'patches' && !this.heatColours;
    const textured = own && (this.topology.scene.materials.length > 0 || this.topology.tint !== null);
    this.clay = own && !textured;
    this.rimmed = own;
    const colours = textured
      ? this.topology.tint
      : (this.heatColours ?? (look.colouring === 'patches' ? this.patchColours : null));
    this.setVertexColours(colours);
    this.setShading(this.plain, look.shading, colours !== null);
    if (textured) this.mesh.material = this.texturedMaterials(look);
    else this.mesh.material = this.plain;
    this.showWire(look);
  }

  /** Phase colour of the outline, or of the whole shape. */
  setColour(colour: string): void {
    this.plain.color.set(this.plain.vertexColors ? '#ffffff' : this.clay ? CLAY : colour);
    this.rim.set(colour, this.rimmed ? RIM : 0);
  }

  /** Makes the shape transparent, without writing depth. */
  setOpacity(opacity: number): void {
    this.plain.transparent = opacity < 1;
    this.plain.opacity = opacity;
    this.plain.depthWrite = opacity >= 1;
    if (opacity < 1) this.mesh.layers.disable(this.layer + CASTER_LAYERS);
    else this.mesh.layers.enable(this.layer + CASTER_LAYERS);
  }

  get opacity(): number {
    return this.plain.opacity;
  }

  dispose(): void {
    this.setMark(null);
    this.wire?.dispose();
    this.object.removeFromParent();
    this.geometry.setIndex(null);
    this.geometry.dispose();
    for (const material of [this.plain, ...this.textured]) material.dispose();
  }

  private showWire({ wireframe, dark }: Look): void {
    if (wireframe && !this.wire) {
      const edges = edgesOf(this.topology.index.array, this.topology.scene.polygons);
      this.wire = new Wire(edges, this.geometry, this.layer);
      this.object.add(this.wire.object);
    }
    if (!this.wire) return;
    this.wire.object.visible = wireframe;
    this.wire.setDark(dark);
  }

  private setVertexColours(colours: Float32Array | null): void {
    const present = this.geometry.getAttribute('color') as BufferAttribute | undefined;
    if (!colours) this.geometry.deleteAttribute('color');
    else if (present) this.fill(present, colours);
    else
      this.geometry.setAttribute(
        'color',
        this.fill(new BufferAttribute(new Float32Array(3 * this.position.count), 3), colours),
      );
  }

  /** Copies 3 numbers per vertex into an attribute, including copies of vertices at seams. */
  private fill(attribute: BufferAttribute, values: Float32Array): BufferAttribute {
    const array = attribute.array as Float32Array;
    array.set(values);
    let at = values.length;
    for (const vertex of this.topology.scene.seams?.copyOf ?? []) {
      for (let c = 0; c < 3; c += 1, at += 1) array[at] = values[3 * vertex + c]!;
    }
    attribute.needsUpdate = true;
    return attribute;
  }

  private setShading(material: MeshStandardMaterial, shading: Look['shading'], vertexColors: boolean): void {
    const flat = shading === 'flat';
    if (material.flatShading === flat && material.vertexColors === vertexColors) return;
    material.flatShading = flat;
    material.vertexColors = vertexColors;
    material.needsUpdate = true;
  }

  private texturedMaterials(look: Look): ThreeMaterial[] {
    if (this.texturedBy !== this.topology.textures) {
      for (const material of this.textured) material.dispose();
      this.texturedBy = this.topology.textures;
      this.textured = this.topology.scene.groups.map((group) =>
        texturedMaterial(this.topology.scene.materials[group.material], this.topology.textures[group.material]),
      );
      for (const material of this.textured) this.studio.install(material, this.rim);
    }
    for (const material of this.textured) this.setShading(material, look.shading, this.topology.tint !== null);
    return this.textured;
  }
}

function dynamic(vertices: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(3 * vertices), 3).setUsage(DynamicDrawUsage);
}

function texturedMaterial(material: Material | undefined, map: Texture | null | undefined): MeshStandardMaterial {
  const result = new MeshStandardMaterial({
    side: DoubleSide,
    roughness: 0.8,
    metalness: 0,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  if (!material) return result;
  const [red, green, blue, alpha] = material.baseColor;
  result.color.setRGB(red, green, blue);
  result.opacity = alpha;
  result.transparent = material.alphaMode === 'BLEND';
  result.alphaTest = material.alphaMode === 'MASK' ? material.alphaCutoff : 0;
  result.metalness = material.metallic;
  // Smoother surfaces would mirror surroundings, which the scene does not have.
  result.roughness = Math.max(material.roughness, 0.3);
  result.map = map ?? null;
  return result;
}

function withoutAlpha(colors: Float32Array): Float32Array {
  return Float32Array.from({ length: (colors.length / 4) * 3 }, (_, i) => colors[4 * Math.floor(i / 3) + (i % 3)]!);
}
