/** Interface of the generated wasm modules: the exports of wasm/bindings, and the module's three callbacks. */

/** A heap address. Above 2 GB it is negative, so convert it with `>>> 0` before use. */
export type Address = number;

/** Callbacks of the module, set on the module itself. */
export interface JsImports {
  onProgress?: (stage: Address, fraction: number) => void;
  takeFrame?: (frame: number, positions: Address, normals: Address) => boolean;
  takeOrder?: (order: Address, unknowns: number) => boolean;
}

/** The functions of the queries (wire/calls.ts), by their symbols. Each takes a handle and JSON. */
export type QueryFunctions = Readonly<Record<string, (handle: number, request: Address) => Address>>;

/** Common interface of all modules. */
export interface WasmModule extends JsImports {
  /** Replaced whenever the memory grows, so never store it. */
  readonly HEAPU8: Uint8Array;
  _malloc(bytes: number): Address;
  _free(address: Address): void;
  _shapespline_objects(): Address;
  _shapespline_release(handle: number): void;
}

export interface CoreModule extends WasmModule {
  /** The module's memory, present only if shared. */
  readonly wasmMemory?: WebAssembly.Memory;
  _shapespline_encode(request: Address): Address;
  _shapespline_order(request: Address): Address;
  _shapespline_report(request: Address): Address;
  _shapespline_motion(shape: number, request: Address): Address;
  _shapespline_evaluate(motion: number, t: number): Address;
  _shapespline_blend(motion: number, request: Address): Address;
  _shapespline_set_threads(shape: number, threads: number): void;
  _shapespline_helped(): number;
  _shapespline_is_help_lost(): number;
  /** Entry point of the second thread's instance (second-thread.ts). */
  _shapespline_help(): void;
  _shapespline_help_lost(): void;
}

export interface FilesModule extends WasmModule {
  _shapespline_import(request: Address): Address;
  _shapespline_import_positions(handle: number, key: number): Address;
  _shapespline_write_animation(request: Address): Address;
  _shapespline_animation_size(request: Address): Address;
  _shapespline_write_pose(request: Address): Address;
  _shapespline_principal_offsets(request: Address): Address;
}

export interface ShellsModule extends WasmModule {
  _shapespline_fit_shells(request: Address): Address;
  _shapespline_deformation_transfer(request: Address): Address;
  _shapespline_follow(handle: number, request: Address): Address;
  _shapespline_shell_bending(request: Address): Address;
}

export interface WasmSettings {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  print?: (text: string) => void;
  printErr?: (text: string) => void;
}

export type CreateWasmModule<M extends WasmModule> = (settings: WasmSettings) => Promise<M>;
