/** Compiles shader programs before the first frame that uses them. */
import type { Camera, Object3D, WebGLRenderer } from 'three';

/** Resolves when the programs are ready, or once requested if the browser cannot compile asynchronously. */
export async function makePrograms(renderer: WebGLRenderer, object: Object3D, camera: Camera): Promise<void> {
  if (renderer.extensions.has('KHR_parallel_shader_compile')) await renderer.compileAsync(object, camera);
  else renderer.compile(object, camera);
}
