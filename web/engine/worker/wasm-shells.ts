/** The module for fitted motions as TypeScript sees it. */
import type { RequestOf, ResultOf } from '../wire/protocol.ts';
import { WasmCalls, type OnProgress } from './wasm-calls.ts';
import type { ShellsModule } from './wasm-module.ts';

export class WasmShells extends WasmCalls<ShellsModule> {
  private led = 0;

  fit(request: RequestOf<'fitShells'>, onProgress: OnProgress): ResultOf<'fitShells'> {
    this.hear(onProgress);
    const { handle, shapes, ...rest } = this.send<
      Omit<ResultOf<'fitShells'>, 'shapes'> & { handle: number; shapes: { positions: Float32Array }[] }
    >(request, (address) => this.module._shapespline_fit_shells(address));
    this.release(handle);
    return { shapes: shapes.map(({ positions }) => positions), ...rest };
  }

  /** Prepares the shape that `follow` corrects. */
  lead(request: RequestOf<'deformationTransfer'>): void {
    this.release(this.led);
    this.led = this.send<{ handle: number }>(request, (address) =>
      this.module._shapespline_deformation_transfer(address),
    ).handle;
  }

  follow(request: RequestOf<'follow'>): Float32Array {
    const { positions } = this.send<{ positions: Float32Array }>(request, (address) =>
      this.module._shapespline_follow(this.led, address),
    );
    return positions;
  }

  bending(request: RequestOf<'shellBending'>): ResultOf<'shellBending'> {
    const { energy } = this.send<ResultOf<'shellBending'>>(request, (address) =>
      this.module._shapespline_shell_bending(address),
    );
    return { energy };
  }
}
