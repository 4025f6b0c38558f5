/** The core with typed calls. */
import { outOfMemory } from '../api/errors.ts';
import type { MeshReport } from '../api/types.ts';
import type { SecondThreadStart } from './second-thread.ts';
import { readFloats, type Range } from './heap.ts';
import { QUERIES, type QueryResult, type QueryInput, type QueryName } from '../wire/calls.ts';
import type { FrameBuffers, FrameData, MotionSpec, MotionState, RequestOf, ResultOf } from '../wire/protocol.ts';
import { awaitedOrder, type SharedOrder } from '../wire/shared-order.ts';
import { WasmCalls, type OnProgress } from './wasm-calls.ts';
import type { Address, CoreModule, QueryFunctions } from './wasm-module.ts';

interface FrameResult {
  positions: Range;
  normals: Range;
  indefiniteFaces: number;
  indefiniteFace?: number;
}

/** Progress and elimination order for a motion that may be the first in its space. */
export interface NewSpace {
  order?: SharedOrder | null;
  report?: OnProgress;
}

/** Stack size of the second thread in bytes, many times the need of a frame's kernels. */
const SECOND_STACK = 1 << 18;

export class WasmCore extends WasmCalls<CoreModule> {
  /** Data for a second thread on this core's memory; null if the memory is not shared. */
  secondThreadStart(compiled: WebAssembly.Module): SecondThreadStart | null {
    const { wasmMemory: memory } = this.module;
    if (!memory) return null;
    const stack = this.module._malloc(SECOND_STACK) >>> 0;
    if (stack === 0) throw outOfMemory();
    return { module: compiled, memory, stack: stack + SECOND_STACK };
  }

  /** Takes effect with the shape's next frame; results do not change. */
  setThreads(handle: number, threads: 1 | 2): void {
    this.module._shapespline_set_threads(handle, threads);
  }

  /** The second thread failed during a frame, so the frame's data is unreliable. */
  get secondThreadLost(): boolean {
    return this.module._shapespline_is_help_lost() !== 0;
  }

  /** Returns the handle of a shape. */
  encode(request: RequestOf<'encode'>, onProgress: OnProgress = () => undefined): number {
    this.hear(onProgress);
    return this.send<{ handle: number }>(encodedOf(request), (address) => this.module._shapespline_encode(address))
      .handle;
  }

  /** The order in which this shape's unknowns are eliminated. */
  eliminationOrder(request: RequestOf<'order'>): Int32Array {
    return this.send<{ order: Int32Array }>(encodedOf(request), (address) => this.module._shapespline_order(address))
      .order;
  }

  /** A report on the mesh of keys that were not read from files. */
  report(request: RequestOf<'report'>): MeshReport {
    return this.send<ResultOf<'report'>>(keysOf(request), (address) => this.module._shapespline_report(address)).report;
  }

  /** `before`: another motion of the shape whose costly parts are reused, or null. */
  motion(
    shape: number,
    { options, keyTimes }: MotionSpec,
    before: number | null,
    { order, report }: NewSpace = {},
  ): MotionState & { handle: number } {
    this.hear(report ?? (() => undefined));
    this.module.takeOrder = (address, unknowns) => {
      const made = order && awaitedOrder(order);
      if (made?.length !== unknowns) return false;
      new Int32Array(this.module.HEAPU8.buffer, address >>> 0, unknowns).set(made);
      return true;
    };
    const request = { motion: options, keyTimes, before };
    return this.send(request, (address) => this.module._shapespline_motion(shape, address));
  }

  /** The answer to a query about the shape or the motion with this handle. */
  ask<N extends QueryName>(name: N, handle: number, request: QueryInput<N>): QueryResult<N> {
    const functions = this.module as unknown as QueryFunctions;
    return this.send(request, (address) => functions[QUERIES[name].symbol]!(handle, address));
  }

  /** Fills `buffers` if given and of the right size. */
  evaluate(handle: number, t: number, buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    return this.frame(this.module._shapespline_evaluate(handle, t), buffers);
  }

  /** The blend of the keys with these weights; `buffers` as above. */
  blend(handle: number, weights: number[], buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    return this.lend((scope) =>
      this.frame(this.module._shapespline_blend(handle, scope.putJson({ weights })), buffers),
    );
  }

  private frame(result: Address, buffers: FrameBuffers | null): Omit<FrameData, 'ms' | 'threads'> {
    const frame = this.rawResult<FrameResult>(result);
    return {
      positions: readFloats(this.module, frame.positions, buffers?.positions),
      normals: readFloats(this.module, frame.normals, buffers?.normals),
      indefiniteFaces: frame.indefiniteFaces,
      indefiniteFace: frame.indefiniteFace,
    };
  }
}

function keysOf({ names, times, faces, positions, normals }: RequestOf<'report'>): object {
  return { faces, normals, keys: positions.map((of, key) => ({ name: names[key], time: times[key], positions: of })) };
}

const encodedOf = (request: RequestOf<'encode'>): object => ({ ...keysOf(request), encoding: request.encoding });
