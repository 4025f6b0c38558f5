/**
 * The ghost mesh: its wireframe over the shape, or the mesh beside the shape with lines to the corresponding vertices.
 */
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  Points,
  PointsMaterial,
} from 'three';
import type { Material, Object3D } from 'three';
import { CASTER_LAYERS } from './contact-shadow.ts';
import { Rim } from './studio.ts';
import type { Studio } from './studio.ts';
import type { GhostPicture } from './types.ts';

/** Most lines to corresponding vertices; more are not distinguishable. */
const LINKS = 28;
/** Share of the eye distance by which the wireframe is moved forward, so the shape's surface does not hide it. */
const FORWARD = 0.006;

export class GhostView {
  readonly object = new Group();
  private readonly faces: Uint32Array;
  private readonly links: Uint32Array;
  private readonly positions: BufferAttribute;
  private readonly linkEnds: BufferAttribute;
  private readonly wire = new LineBasicMaterial({ transparent: true, opacity: 0.6 });
  private readonly link = new LineBasicMaterial({ transparent: true, opacity: 0.8 });
  private readonly dot = new PointsMaterial({ size: 4, sizeAttenuation: false });
  private readonly clay = new MeshStandardMaterial({
    color: 0x9aa3ad,
    roughness: 0.75,
    flatShading: true,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  private readonly overlay: Object3D;
  private readonly beside = new Group();
  private readonly lines = new Group();

  /** Draws one mesh; `fits` checks whether a picture has this mesh. */
  constructor({ faces, positions, vertexOf }: GhostPicture, studio: Studio, layer: number) {
    studio.install(this.clay, new Rim());
    this.faces = faces;
    this.links = spread(positions, Math.min(LINKS, vertexOf.length));
    this.positions = dynamic(positions.length / 3);
    this.linkEnds = dynamic(2 * this.links.length);
    const edges = new BufferAttribute(edgesOf(faces), 1);
    bringForward(this.wire);
    this.overlay = new LineSegments(this.geometry(edges), this.wire);
    const solid = new Mesh(this.geometry(new BufferAttribute(faces, 1)), this.clay);
    this.beside.add(solid, new LineSegments(this.geometry(edges), this.wire));
    const ends = new BufferGeometry().setAttribute('position', this.linkEnds);
    this.lines.add(new LineSegments(ends, this.link), new Points(ends, this.dot));
    this.object.add(this.overlay, this.beside, this.lines);
    this.object.traverse((part) => {
      part.frustumCulled = false;
      part.layers.set(layer);
    });
    solid.layers.enable(layer + CASTER_LAYERS);
  }

  fits({ faces }: GhostPicture): boolean {
    return faces === this.faces;
  }

  /** `shape`: 3 x vertices of the currently drawn shape. */
  setFrame({ positions, vertexOf, overlay, offset }: GhostPicture, shape: Float32Array, dark: boolean): void {
    this.positions.copyArray(positions).needsUpdate = true;
    this.overlay.visible = overlay;
    this.beside.visible = this.lines.visible = offset !== null;
    this.wire.color.set(dark ? 0xffffff : 0x10151b);
    this.link.color.set(dark ? 0xb3adff : 0x4a41c9);
    this.dot.color.copy(this.link.color);
    if (offset === null) return;
    this.beside.position.x = offset;
    const ends = this.linkEnds.array as Float32Array;
    this.links.forEach((g, index) => {
      const v = 3 * vertexOf[g]!;
      ends.set(
        [
          positions[3 * g]! + offset,
          positions[3 * g + 1]!,
          positions[3 * g + 2]!,
          shape[v]!,
          shape[v + 1]!,
          shape[v + 2]!,
        ],
        6 * index,
      );
    });
    this.linkEnds.needsUpdate = true;
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.traverse((part) => {
      (part as Partial<Mesh>).geometry?.dispose();
    });
    for (const material of [this.wire, this.link, this.dot, this.clay]) material.dispose();
  }

  private geometry(index: BufferAttribute): BufferGeometry {
    return new BufferGeometry().setAttribute('position', this.positions).setIndex(index);
  }
}

function dynamic(vertices: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(3 * vertices), 3).setUsage(DynamicDrawUsage);
}

/** Scaling a point towards the eye moves it forward without moving it on the screen. */
function bringForward(material: Material): void {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      '#include <project_vertex>',
      `#include <project_vertex>\ngl_Position = projectionMatrix * vec4(mvPosition.xyz * ${(1 - FORWARD).toFixed(4)}, 1.0);`,
    );
  };
}

/** Both ends of each edge, each edge once. */
function edgesOf(faces: Uint32Array): Uint32Array {
  const count = faces.reduce((most, v) => Math.max(most, v), 0) + 1;
  const edges = new Set<number>();
  for (let i = 0; i < faces.length; i += 3) {
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [faces[i + k]!, faces[i + ((k + 1) % 3)]!];
      edges.add(Math.min(a, b) * count + Math.max(a, b));
    }
  }
  return Uint32Array.from([...edges].flatMap((edge) => [Math.floor(edge / count), edge % count]));
}

/** Well-spread vertices: each is the farthest from all previous ones. */
function spread(positions: Float32Array, wanted: number): Uint32Array {
  const count = positions.length / 3;
  const distance = new Float64Array(count).fill(Infinity);
  const chosen = new Uint32Array(wanted);
  for (let k = 1; k < wanted; k += 1) {
    const last = 3 * chosen[k - 1]!;
    let farthest = 0;
    for (let v = 0; v < count; v += 1) {
      const [dx, dy, dz] = [
        positions[3 * v]! - positions[last]!,
        positions[3 * v + 1]! - positions[last + 1]!,
        positions[3 * v + 2]! - positions[last + 2]!,
      ];
      distance[v] = Math.min(distance[v]!, dx * dx + dy * dy + dz * dz);
      if (distance[v]! > distance[farthest]!) farthest = v;
    }
    chosen[k] = farthest;
  }
  return chosen;
}
