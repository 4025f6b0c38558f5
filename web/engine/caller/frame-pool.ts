/** Released frames: their buffers return to the worker with the next request, so steady playback allocates nothing. */
import type { FrameBuffers, FrameData } from '../wire/protocol.ts';
import type { Frame } from '../api/types.ts';

/** Enough buffers for the look-ahead and the shown frames. The garbage collector takes further buffers. */
const MAX_SPARES = 12;

export class FramePool {
  private readonly spares: FrameBuffers[] = [];

  /** Buffers for a request, or null if none are free. */
  take(): FrameBuffers | null {
    return this.spares.pop() ?? null;
  }

  frame(t: number, data: FrameData): Frame {
    const { positions, normals, ms, threads, indefiniteFaces, indefiniteFace } = data;
    let buffers: FrameBuffers | null = { positions, normals };
    const release = (): void => {
      // Arrays that the receiver has transferred elsewhere cannot be reused.
      const whole = buffers && buffers.positions.length > 0 && buffers.normals.length > 0;
      if (buffers && whole && this.spares.length < MAX_SPARES) this.spares.push(buffers);
      buffers = null;
    };
    return { t, positions, normals, ms, threads, indefiniteFaces, indefiniteFace, release };
  }
}
