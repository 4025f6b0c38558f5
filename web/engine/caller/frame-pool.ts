/** Spent frames: their buffers return to the worker with the next request, so steady playback allocates nothing. */
import type { FrameBuffers, FrameData } from '../wire/protocol.ts';
import type { Frame } from '../api/types.ts';

/** Enough for the look-ahead and the shown frames; further buffers are left to the garbage collector. */
const MOST_SPARES = 12;

export class FramePool {
  private readonly spares: FrameBuffers[] = [];

  /** Buffers to send along, or null when none are spare. */
  take(): FrameBuffers | null {
    return this.spares.pop() ?? null;
  }

  frame(t: number, data: FrameData): Frame {
    const { positions, normals, ms, threads, indefiniteFaces, indefiniteFace } = data;
    let buffers: FrameBuffers | null = { positions, normals };
    const release = (): void => {
      // A frame whose arrays the receiver transferred elsewhere has nothing to give back.
      const whole = buffers && buffers.positions.length > 0 && buffers.normals.length > 0;
      if (buffers && whole && this.spares.length < MOST_SPARES) this.spares.push(buffers);
      buffers = null;
    };
    return { t, positions, normals, ms, threads, indefiniteFaces, indefiniteFace, release };
  }
}
