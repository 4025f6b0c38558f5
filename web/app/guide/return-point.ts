/** The content that was open before the guide, and its restoration. */
import { DEFAULT_VIEW } from '../../model/state.ts';
import { currentSnapshot } from '../storage/snapshot.ts';
import type { Snapshot } from '../storage/snapshot.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { Opener } from '../sources/opener.ts';

export interface ReturnPointParts {
  store: Store;
  workspace: Workspace;
  files: Opener;
  /** Opens the initial content of a visit. */
  openInitial(): Promise<void>;
}

export function createReturnPoint(parts: ReturnPointParts) {
  const { store, workspace, files } = parts;
  let before: Snapshot | null = null;
  let focused: Element | null = null;
  /** Counts the restorations in progress. The last one ends at this content. */
  let returning = 0;
  let comingBack: Snapshot | null = null;
  return {
    /** Call before opening the first page. */
    remember(): void {
      before = returning > 0 ? comingBack : currentSnapshot(store, workspace);
      focused = document.activeElement;
    },
    async go(): Promise<void> {
      comingBack = before;
      before = null;
      focusAgain(focused);
      focused = null;
      returning += 1;
      await giveBack(comingBack, parts).finally(() => (returning -= 1));
    },
    /** Other content was opened, so nothing needs to be restored. */
    drop(): void {
      if (before) files.history.left(before);
      before = null;
    },
    get underWay(): boolean {
      return returning > 0;
    },
  };
}

/** Returns keyboard focus to its element before the guide. */
function focusAgain(focused: Element | null): void {
  const lost = document.activeElement === document.body;
  if (lost && focused instanceof HTMLElement && focused.checkVisibility()) focused.focus();
}

/** Restores the content exactly, including playback. */
async function giveBack(left: Snapshot | null, { store, files, openInitial }: ReturnPointParts): Promise<void> {
  if (!left) {
    // Removes every trace of the guide's pages; new content looks as on a first visit.
    store.set({ view: DEFAULT_VIEW });
    return openInitial();
  }
  const { playing } = left.state.play;
  if ((await files.again(left, null)) && playing) store.set({ play: { ...store.get().play, playing } });
}
