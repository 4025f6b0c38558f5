/**
 * Removes parts of three's shaders that no material of this viewer uses from the build. Each is between an #ifdef and
 * its #endif, or included by an unused material.
 */
import type { Plugin } from 'vite';

const UNUSED = [
  ...['alphahash_pars_fragment', 'alphahash_fragment', 'batching_pars_vertex', 'batching_vertex'],
  ...['bumpmap_pars_fragment', 'clearcoat_pars_fragment', 'clearcoat_normal_fragment_begin'],
  ...['clearcoat_normal_fragment_maps', 'clipping_planes_pars_fragment', 'clipping_planes_pars_vertex'],
  ...['clipping_planes_fragment', 'clipping_planes_vertex', 'displacementmap_pars_vertex', 'displacementmap_vertex'],
  ...['fog_pars_vertex', 'fog_vertex', 'fog_pars_fragment', 'fog_fragment', 'gradientmap_pars_fragment'],
  ...['iridescence_pars_fragment', 'iridescence_fragment', 'lightmap_pars_fragment', 'lightprobes_pars_fragment'],
  ...['lights_lambert_pars_fragment', 'lights_lambert_fragment', 'lights_phong_pars_fragment', 'lights_phong_fragment'],
  ...['lights_toon_pars_fragment', 'lights_toon_fragment', 'logdepthbuf_pars_vertex', 'logdepthbuf_vertex'],
  ...['logdepthbuf_pars_fragment', 'logdepthbuf_fragment', 'morphtarget_pars_vertex', 'morphtarget_vertex'],
  ...['morphnormal_vertex', 'morphcolor_vertex', 'morphinstance_vertex', 'shadowmap_pars_fragment'],
  ...['shadowmap_pars_vertex', 'shadowmap_vertex', 'shadowmask_pars_fragment', 'skinning_pars_vertex'],
  ...['skinbase_vertex', 'skinning_vertex', 'skinnormal_vertex', 'transmission_pars_fragment', 'transmission_fragment'],
];

/** Throws if a newer three lacks a part. */
export function withoutUnusedShaders(code: string): string {
  return UNUSED.reduce((left, name) => {
    const part = new RegExp(`^(var|const) ${name} = ".*";$`, 'm');
    if (!part.test(left)) throw new Error(`three.js has no shader part ${name}: remove it from unused-shaders.ts.`);
    return left.replace(part, `$1 ${name} = "";`);
  }, code);
}

export function unusedShaders(): Plugin {
  return {
    name: 'shapespline-unused-shaders',
    apply: 'build',
    transform: (code, id) => (/\/three\/build\/three\.module\.js$/.test(id) ? withoutUnusedShaders(code) : null),
  };
}
