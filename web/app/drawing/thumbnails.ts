/** Small pictures of the keys, made one after the other when there is nothing else to draw. */
import type { Context } from '../context.ts';

export interface Thumbnails {
  /** Makes those that are missing. */
  refresh(): void;
}

const MAX_KEYS = 64;

export function createThumbnails(context: Context): Thumbnails {
  const { store, workspace, picture, frameLoop } = context;
  let running = false;

  const next = async (): Promise<boolean> => {
    const sequence = workspace.sequences[0]?.sequence;
    const { pool } = workspace;
    const key = store.get().doc.keys.slice(0, MAX_KEYS).find(({ pose }) => !context.viewState().thumbnails.has(pose));
    if (!sequence || !key || !sequence.keyTimes.includes(key.time)) return false;
    const [frame] = await sequence.evaluateMany([key.time]);
    if (!frame) return false;
    await frameLoop.idle();
    const stillOpen = workspace.pool === pool;
    if (stillOpen) {
      const thumbnails = new Map(context.viewState().thumbnails).set(key.pose, picture.thumbnail(frame));
      context.inform({ thumbnails });
    }
    frame.release();
    return stillOpen;
  };

  const work = async (): Promise<void> => {
    try {
      while (await next());
    } catch {
      // The sequence was exchanged in the middle; its successor calls again.
    }
  };

  return {
    refresh() {
      if (running) return;
      running = true;
      void work().finally(() => { running = false; });
    },
  };
}
