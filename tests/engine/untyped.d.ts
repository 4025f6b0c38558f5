/** Declarations for packages without types, for the parts used here. */
declare module 'gltf-validator' {
  export interface Report {
    issues: { numErrors: number; numWarnings: number; messages: { code: string; message: string; severity: number }[] };
  }
  export function validateBytes(bytes: Uint8Array): Promise<Report>;
}

declare module 'draco3dgltf/draco_encoder_gltf_nodejs.js' {
  export default function createEncoder(): Promise<object>;
}
