/** An exported GLB played by three.js: the vertices at a time, from its morph targets and mixer. */
import { AnimationMixer, LoopOnce, type Mesh, type Object3D, Vector3 } from 'three';
import { MeshoptDecoder } from 'meshoptimizer';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

export interface Player {
  duration: number;
  /** Times of the weight animation's key frames, in seconds. */
  times: number[];
  /** Positions in double precision, because nodes may be far away. */
  positionsAt(seconds: number): Float64Array;
}

/** Images cannot be decoded in Node and are not needed here. */
export function withoutImages(bytes: Uint8Array): ArrayBuffer {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Record<string, unknown>;
  for (const name of ['images', 'textures', 'materials']) delete json[name];
  for (const mesh of (json.meshes ?? []) as { primitives: { material?: number }[] }[])
    for (const part of mesh.primitives) delete part.material;
  // The new JSON is shorter and padded, so the following chunks keep their positions.
  const text = new TextEncoder().encode(JSON.stringify(json).padEnd(length));
  // The slice of a Buffer is no copy.
  const copy = Uint8Array.from(bytes);
  copy.set(text.subarray(0, length), 20);
  return copy.buffer;
}

/** The mesh's vertex for each of a primitive's vertices. */
function numbersOf({ geometry }: Mesh): number[] {
  const numbers = geometry.getAttribute('_shapespline_vertex');
  const { count } = geometry.getAttribute('position');
  return Array.from({ length: count }, (_, i) => (numbers ? numbers.getX(i) : i));
}

export async function threePlayer(bytes: Uint8Array): Promise<Player> {
  const { scene, animations } = await new GLTFLoader()
    .setMeshoptDecoder(MeshoptDecoder)
    .parseAsync(withoutImages(bytes), '');
  const meshes: Mesh[] = [];
  scene.traverse((object: Object3D) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh);
  });
  const mixer = new AnimationMixer(scene);
  const clip = animations[0]!;
  const action = mixer.clipAction(clip);
  action.setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  action.play();
  const size = Math.max(...meshes.map((mesh) => 1 + Math.max(...numbersOf(mesh))));
  const positionsAt = (seconds: number): Float64Array => {
    action.reset();
    mixer.setTime(seconds);
    scene.updateMatrixWorld(true);
    const point = new Vector3();
    const result = new Float64Array(3 * size).fill(NaN);
    for (const mesh of meshes) {
      for (const [i, vertex] of numbersOf(mesh).entries()) {
        mesh
          .getVertexPosition(i, point)
          .applyMatrix4(mesh.matrixWorld)
          .toArray(result, 3 * vertex);
      }
    }
    return result;
  };
  return { duration: clip.duration, times: Array.from(clip.tracks[0]!.times), positionsAt };
}
