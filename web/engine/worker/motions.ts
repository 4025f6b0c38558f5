/** The motions of a worker's shape. */
import type { MotionSpec, MotionState } from '../wire/protocol.ts';
import type { NewSpace, WasmCore } from './wasm-core.ts';

/**
 * Limit for kept motions, more than any page shows. The least recently used motions are dropped, and recreated on
 * request.
 */
const MAX_MOTIONS = 16;

export class Motions {
  /** Handles by number, most recently used last. */
  private readonly handles = new Map<number, number>();
  /** The newest motion with holding or pins; the next one reuses its factored system. */
  private holding: number | null = null;

  /** A failure does not affect the other motions. */
  make(core: WasmCore, shape: number, spec: MotionSpec, space?: NewSpace): MotionState {
    const { handle, ...state } = core.motion(shape, spec, this.holding, space);
    if (spec.options.hold === 'on' || spec.options.pins.length > 0) this.holding = handle;
    this.drop(core, spec);
    this.handles.set(spec.number, handle);
    const [oldest] = this.handles.keys();
    if (this.handles.size > MAX_MOTIONS) this.forget(core, oldest!);
    return state;
  }

  /** The handle of a motion, which is made if missing, for example after a worker broke down. */
  of(core: WasmCore, shape: number, spec: MotionSpec): number {
    const handle = this.handles.get(spec.number);
    if (handle === undefined) {
      this.make(core, shape, spec);
      return this.handles.get(spec.number)!;
    }
    this.handles.delete(spec.number);
    this.handles.set(spec.number, handle);
    return handle;
  }

  drop(core: WasmCore, { number }: MotionSpec): void {
    this.forget(core, number);
  }

  private forget(core: WasmCore, number: number): void {
    const handle = this.handles.get(number);
    if (handle === undefined) return;
    if (handle === this.holding) this.holding = null;
    core.release(handle);
    this.handles.delete(number);
  }
}
