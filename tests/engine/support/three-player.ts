/** An exported GLB as three.js plays it: the vertices that its morph targets and mixer give at a time. */
import { AnimationMixer, LoopOnce, type Mesh, type Object3D, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

export interface Player {
  duration: number;
  /** Times of the weight animation's key frames, in seconds. */
  times: number[];
  positionsAt(seconds: number): Float32Array;
}

/** Images cannot be decoded in Node; they matter nothing here. */
export function withoutImages(bytes: Uint8Array): ArrayBuffer {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Record<string, unknown>;
  for (const name of ['images', 'textures', 'materials']) delete json[name];
  for (const mesh of json.meshes as { primitives: { material?: number }[] }[])
    for (const part of mesh.primitives) delete part.material;
  const text = new TextEncoder().encode(JSON.stringify(json).padEnd(length)); // shorter than before, so the rest stays in its place
  const copy = bytes.slice();
  copy.set(text.subarray(0, length), 20);
  return copy.buffer;
}

export async function threePlayer(bytes: Uint8Array): Promise<Player> {
  const { scene, animations } = await new GLTFLoader().parseAsync(withoutImages(bytes), '');
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
  const positionsAt = (seconds: number): Float32Array => {
    action.reset();
    mixer.setTime(seconds);
    scene.updateMatrixWorld(true);
    const mesh = meshes[0]!;
    const point = new Vector3();
    const result = new Float32Array(3 * mesh.geometry.getAttribute('position').count);
    for (let i = 0; i < result.length / 3; ++i) {
      mesh
        .getVertexPosition(i, point)
        .applyMatrix4(mesh.matrixWorld)
        .toArray(result, 3 * i);
    }
    return result;
  };
  return { duration: clip.duration, times: Array.from(clip.tracks[0]!.times), positionsAt };
}
