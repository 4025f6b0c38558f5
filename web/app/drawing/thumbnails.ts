/** Small pictures of the keys, made one after the other when there is nothing else to draw. */
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { SceneController } from './scene-controller.ts';

export interface ThumbnailParts {
  store: Store;
  workspace: Workspace;
  scene: SceneController;
  /** Resolves when nothing else is to be drawn. */
  idle(): Promise<void>;
  has(pose: number): boolean;
  onThumbnail(pose: number, url: string): void;
}

export interface Thumbnails {
  /** Makes those that are missing. */
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
    // What is opened in the middle of it asks while the pictures of what was open are still being made.
    while (wanted) {
      wanted = false;
      try {
        while (await next());
      } catch {
        // The sequence was exchanged in the middle; its successor calls again.
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
