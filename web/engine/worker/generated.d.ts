/** Emscripten's generated glue, declared so type checks work without it. */
declare module '*/build/wasm/shapespline.mjs' {
  const create: import('./wasm-module.ts').CreateWasmModule<import('./wasm-module.ts').CoreModule>;
  export default create;
}

declare module '*/build/wasm/shapespline_threads.mjs' {
  const create: import('./wasm-module.ts').CreateWasmModule<import('./wasm-module.ts').CoreModule>;
  export default create;
}

declare module '*/build/wasm/shapespline_files.mjs' {
  const create: import('./wasm-module.ts').CreateWasmModule<import('./wasm-module.ts').FilesModule>;
  export default create;
}

declare module '*/build/wasm/shapespline_shells.mjs' {
  const create: import('./wasm-module.ts').CreateWasmModule<import('./wasm-module.ts').ShellsModule>;
  export default create;
}

/** Published without types: Draco's decoder module, passed to glTF-Transform unchanged. */
declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  export default function createDecoder(settings: { wasmBinary: Uint8Array }): Promise<object>;
}
