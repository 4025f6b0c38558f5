/** A GLB with every kind of motion: a skinned and morphing bar below a moving root, and a box carried by a joint. */
import { Document, WebIO, type Accessor, type Node } from '@gltf-transform/core';
import type { InputFile } from '../../../web/engine/api/types.ts';
import { bar, moved } from './shapes.ts';

type Path = 'translation' | 'rotation' | 'scale' | 'weights';
type Kind = 'LINEAR' | 'STEP' | 'CUBICSPLINE';
type Type = Parameters<Accessor['setType']>[0];

/** A rotation about the x axis as a quaternion. */
const turn = (degrees: number): number[] => [
  Math.sin((degrees * Math.PI) / 360),
  0,
  0,
  Math.cos((degrees * Math.PI) / 360),
];

/** Three rows per key for cubic splines: non-zero tangents, and the value between them. */
const cubic = (rows: number[][]): number[][] =>
  rows.flatMap((row, i) => [row.map((v, c) => 0.3 * v - 0.1 * c), row, row.map((v, c) => 0.2 * i - 0.4 * v + 0.1 * c)]);

class Rig {
  readonly document = new Document();
  private readonly buffer = this.document.createBuffer();

  accessor(
    values: ArrayLike<number>,
    type: Type,
    Kind: Float32ArrayConstructor | Uint16ArrayConstructor = Float32Array,
  ): Accessor {
    return this.document.createAccessor().setArray(Kind.from(values)).setType(type).setBuffer(this.buffer);
  }

  animate(name: string, channels: [Node, Path, Kind, number[], number[][]][]): void {
    const animation = this.document.createAnimation(name);
    const types: Record<Path, Type> = { translation: 'VEC3', rotation: 'VEC4', scale: 'VEC3', weights: 'SCALAR' };
    for (const [node, path, kind, times, rows] of channels) {
      const values = (kind === 'CUBICSPLINE' ? cubic(rows) : rows).flat();
      const sampler = this.document
        .createAnimationSampler()
        .setInterpolation(kind)
        .setInput(this.accessor(times, 'SCALAR'))
        .setOutput(this.accessor(values, types[path]));
      animation
        .addSampler(sampler)
        .addChannel(this.document.createAnimationChannel().setTargetNode(node).setTargetPath(path).setSampler(sampler));
    }
  }
}

export async function rigFile(name = 'rig.glb'): Promise<InputFile> {
  const rig = new Rig();
  const { document } = rig;
  const mesh = bar(2, 12);
  const count = mesh.positions.length / 3;

  const joints = [0, 4, 4].map((z, i) => document.createNode(`joint ${i}`).setTranslation([0, 0, z]));
  joints[0]!.addChild(joints[1]!);
  joints[1]!.addChild(joints[2]!);
  const inverse = [0, 4, 8].flatMap((z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -z, 1]);
  const skin = document.createSkin().setInverseBindMatrices(rig.accessor(inverse, 'MAT4'));
  for (const joint of joints) skin.addJoint(joint);

  const heights = Array.from({ length: count }, (_, v) => mesh.positions[3 * v + 2]!);
  const near = (z: number, at: number): number => Math.max(0, 1 - Math.abs(z - at) / 4);
  const weights = heights.flatMap((z) => {
    const [a, b] = [near(z, 0), near(z, 4)];
    return [a, b, 1 - a - b, 0];
  });
  const target = (move: Parameters<typeof moved>[1]): Accessor =>
    rig.accessor(
      moved(mesh, move).map((value, i) => value - mesh.positions[i]!),
      'VEC3',
    );
  const body = document
    .createPrimitive()
    .setAttribute('POSITION', rig.accessor(mesh.positions, 'VEC3'))
    .setIndices(rig.accessor(mesh.indices, 'SCALAR', Uint16Array))
    .setAttribute(
      'JOINTS_0',
      rig.accessor(
        heights.flatMap(() => [0, 1, 2, 0]),
        'VEC4',
        Uint16Array,
      ),
    )
    .setAttribute('WEIGHTS_0', rig.accessor(weights, 'VEC4'))
    .addTarget(
      document.createPrimitiveTarget().setAttribute(
        'POSITION',
        target((x, y, z) => [x * (1 + z / 10), y, z]),
      ),
    )
    .addTarget(
      document.createPrimitiveTarget().setAttribute(
        'POSITION',
        target((x, y, z) => [x, y + Math.sin(z), z]),
      ),
    );
  // The node's own transform has no effect, because its mesh is skinned.
  const bodyNode = document
    .createNode('body')
    .setMesh(document.createMesh().addPrimitive(body).setWeights([0.1, 0]))
    .setSkin(skin)
    .setTranslation([7, 7, 7]);

  const box = bar(1, 1, 1);
  const hat = document
    .createNode('hat')
    .setTranslation([0, 1, 0])
    .setMesh(
      document.createMesh().addPrimitive(
        document
          .createPrimitive()
          .setAttribute('POSITION', rig.accessor(box.positions, 'VEC3'))
          .setIndices(rig.accessor(box.indices, 'SCALAR', Uint16Array)),
      ),
    );
  joints[2]!.addChild(hat);

  const root = document.createNode('root').setScale([1, 1.5, 1]).addChild(joints[0]!).addChild(bodyNode);
  document.getRoot().setDefaultScene(document.createScene().addChild(root));

  rig.animate('everything', [
    [joints[0]!, 'rotation', 'LINEAR', [0, 0.5, 2], [turn(0), turn(50), turn(-70)]],
    [joints[1]!, 'rotation', 'CUBICSPLINE', [0.2, 1, 1.8], [turn(10), turn(80), turn(-30)]],
    [
      joints[2]!,
      'translation',
      'STEP',
      [0, 0.7, 1.4],
      [
        [0, 0, 4],
        [0, 0.5, 4.5],
        [0.5, 0, 4],
      ],
    ],
    [
      bodyNode,
      'weights',
      'CUBICSPLINE',
      [0, 1, 2],
      [
        [0, 0.2],
        [0.8, 0.1],
        [0.3, 1],
      ],
    ],
    [
      hat,
      'scale',
      'CUBICSPLINE',
      [0, 2],
      [
        [1, 1, 1],
        [2, 0.5, 1],
      ],
    ],
    [hat, 'rotation', 'STEP', [0, 1], [turn(0), turn(45)]],
    [
      root,
      'translation',
      'LINEAR',
      [0, 2],
      [
        [0, 0, 0],
        [3, 0, -2],
      ],
    ],
    [root, 'rotation', 'LINEAR', [0, 1, 2], [turn(0), turn(100), turn(200)]],
  ]);
  rig.animate('nod', [[joints[1]!, 'rotation', 'LINEAR', [0, 1, 3], [turn(0), turn(40), turn(0)]]]);
  return { name, bytes: await new WebIO().writeBinary(document) };
}
