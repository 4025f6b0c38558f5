/** A glTF file's scene as three.js poses it at a time of one of its animations: morph targets, skins and node transforms. */
import { AnimationMixer, LoopOnce, type Mesh, type Object3D, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

export interface Poser {
  names: string[];
  duration: number;
  /** World positions of all vertices, mesh after mesh as the scene is walked. */
  positionsAt(seconds: number): Float64Array;
}

/** Images cannot be decoded in Node; they matter nothing here. */
function withoutImages(bytes: Uint8Array): ArrayBuffer {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Record<string, unknown>;
  for (const name of ['images', 'textures', 'materials']) delete json[name];
  for (const mesh of json.meshes as { primitives: { material?: number }[] }[]) for (const part of mesh.primitives) delete part.material;
  const text = new TextEncoder().encode(JSON.stringify(json).padEnd(length));  // shorter than before, so the rest stays in its place
  const copy = bytes.slice();
  copy.set(text.subarray(0, length), 20);
  return copy.buffer;
}

export async function threePoser(bytes: Uint8Array, animation = 0): Promise<Poser> {
  const { scene, animations } = await new GLTFLoader().parseAsync(withoutImages(bytes), '');
  const meshes: Mesh[] = [];
  scene.traverse((object: Object3D) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh);
  });
  const mixer = new AnimationMixer(scene);
  const clip = animations[animation]!;
  const action = mixer.clipAction(clip);
  action.setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  action.play();
  const positionsAt = (seconds: number): Float64Array => {
    action.reset();
    mixer.setTime(seconds);
    scene.updateMatrixWorld(true);
    const point = new Vector3();
    // getVertexPosition applies morph targets and, for a SkinnedMesh, applyBoneTransform.
    return Float64Array.from(meshes.flatMap((mesh) => Array.from({ length: mesh.geometry.getAttribute('position').count }, (_, i) =>
      mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld).toArray()).flat()));
  };
  return { names: animations.map(({ name }) => name), duration: clip.duration, positionsAt };
}
