/** Thumbnails of the keys, made one by one when drawing is idle. */
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { SceneController } from './scene-controller.ts';

export interface ThumbnailParts {
  store: Store;
  workspace: Workspace;
  scene: SceneController;
  /** Resolves when drawing is idle. */
  idle(): Promise<void>;
  has(pose: number): boolean;
  onThumbnail(pose: number, url: string): void;
}

export interface Thumbnails {
  /** Makes the missing thumbnails. */
  refresh(): void;
}

/** More cards are not useful. */
const MAX_KEYS = 256;

export function createThumbnails({ store, workspace, scene, idle, has, onThumbnail }: ThumbnailParts): Thumbnails {
  let running = false;
  let wanted = false;

  const next = async (): Promise<boolean> => {
    const sequence = workspace.sequences[0]?.sequence;
    const { pool } = workspace;
    const key = store
      .get()
      .doc.keys.slice(0, MAX_KEYS)
      .find(({ pose }) => !has(pose));
    if (!sequence || !key || !sequence.keyTimes.includes(key.time)) return false;
    const [frame] = await sequence.evaluateMany([key.time]);
    if (!frame) return false;
    await scene.viewer.textured();
    await idle();
    const stillOpen = workspace.pool === pool;
    if (stillOpen) onThumbnail(key.pose, scene.thumbnail(frame));
    frame.release();
    return stillOpen;
  };

  const work = async (): Promise<void> => {
    running = true;
    // Newly opened files request thumbnails while the previous ones are still being made.
    while (wanted) {
      wanted = false;
      try {
        while (await next());
      } catch {
        // The successor of a replaced sequence calls again.
      }
    }
    running = false;
  };

  return {
    refresh() {
      wanted = true;
      if (!running) void work();
    },
  };
}
