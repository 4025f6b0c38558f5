/** A glTF scene posed by three.js at a time of an animation: morph targets, skins and node transforms. */
import { AnimationMixer, LoopOnce, type Mesh, type Object3D, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { withoutImages } from './three-player.ts';

export interface Poser {
  names: string[];
  duration: number;
  /** World positions of all vertices, mesh by mesh in scene order. */
  positionsAt(seconds: number): Float64Array;
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
    return Float64Array.from(
      meshes.flatMap((mesh) =>
        Array.from({ length: mesh.geometry.getAttribute('position').count }, (_, i) =>
          mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld).toArray(),
        ).flat(),
      ),
    );
  };
  return { names: animations.map(({ name }) => name), duration: clip.duration, positionsAt };
}
