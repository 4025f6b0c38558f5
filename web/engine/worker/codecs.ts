/**
 * The libraries that read and write compressed glTF, each loaded on first use. The page and the repository's programs
 * use this file; the npm package has a separate file (`packaged/codecs`).
 */

export interface Codecs {
  core(): Promise<typeof import('@gltf-transform/core')>;
  extensions(): Promise<typeof import('@gltf-transform/extensions')>;
  functions(): Promise<typeof import('@gltf-transform/functions')>;
  draco(): Promise<typeof import('draco3dgltf/draco_decoder_gltf_nodejs.js')>;
  meshoptDecoder(): Promise<typeof import('meshoptimizer/decoder')>;
  meshoptEncoder(): Promise<typeof import('meshoptimizer/encoder')>;
}

export const codecs: Codecs = {
  core: () => import('@gltf-transform/core'),
  extensions: () => import('@gltf-transform/extensions'),
  functions: () => import('@gltf-transform/functions'),
  draco: () => import('draco3dgltf/draco_decoder_gltf_nodejs.js'),
  meshoptDecoder: () => import('meshoptimizer/decoder'),
  meshoptEncoder: () => import('meshoptimizer/encoder'),
};
