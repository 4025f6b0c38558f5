/** A glTF scene posed by three.js at a time of an animation: morph targets, skins and node transforms. */
import { type AnimationClip, AnimationMixer, LoopOnce, type Mesh, type Object3D, Vector3 } from 'three';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { type GLTF, GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { withoutImages } from './three-player.ts';

export interface Poser {
  names: string[];
  duration: number;
  /** World positions of all vertices, mesh by mesh in scene order. */
  positionsAt(seconds: number): Float64Array;
}

export const threeScene = async (bytes: Uint8Array): Promise<GLTF> =>
  new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(withoutImages(bytes), '');

/** Plays animations together: those with these indices, or of another file. */
export async function threePoser(bytes: Uint8Array, ...played: (number | AnimationClip)[]): Promise<Poser> {
  const { scene, animations } = await threeScene(bytes);
  const meshes: Mesh[] = [];
  scene.traverse((object: Object3D) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh);
  });
  const mixer = new AnimationMixer(scene);
  const clips = (played.length > 0 ? played : [0]).map((one) => (typeof one === 'number' ? animations[one]! : one));
  const actions = clips.map((clip) => mixer.clipAction(clip).setLoop(LoopOnce, 1).play());
  for (const action of actions) action.clampWhenFinished = true;
  const positionsAt = (seconds: number): Float64Array => {
    for (const action of actions) action.reset();
    mixer.setTime(seconds);
    scene.updateMatrixWorld(true);
    const point = new Vector3();
    // getVertexPosition applies morph targets and, for a SkinnedMesh, applyBoneTransform.
    return Float64Array.from(
      meshes.flatMap((mesh) =>
        Array.from({ length: mesh.geometry.getAttribute('position').count }, (_, i) =>
          mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld).toArray(),
        ).flat(),
      ),
    );
  };
  return {
    names: animations.map(({ name }) => name),
    duration: Math.max(...clips.map(({ duration }) => duration)),
    positionsAt,
  };
}
