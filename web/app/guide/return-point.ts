/** What was open before the first page of the guide, and the way back to it. */
import { DEFAULT_VIEW } from '../../model/state.ts';
import { currentSnapshot } from '../kept/snapshot.ts';
import type { Snapshot } from '../kept/snapshot.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { Opener } from '../sources/opener.ts';

export interface ReturnPointParts {
  store: Store;
  workspace: Workspace;
  files: Opener;
  /** Opens what a visit starts with. */
  openInitial(): Promise<void>;
}

export function createReturnPoint(parts: ReturnPointParts) {
  const { store, workspace, files } = parts;
  let before: Snapshot | null = null;
  let focused: Element | null = null;
  /** Ways back that are under way, the last one to this. */
  let returning = 0;
  let comingBack: Snapshot | null = null;
  return {
    /** The first page is about to be opened. */
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
    /** Other content was opened, so there is no way back. */
    drop(): void {
      if (before) files.history.left(before);
      before = null;
    },
    get underWay(): boolean {
      return returning > 0;
    },
  };
}

/** Who left with the keyboard goes on where they came from. */
function focusAgain(focused: Element | null): void {
  const lost = document.activeElement === document.body;
  if (lost && focused instanceof HTMLElement && focused.checkVisibility()) focused.focus();
}

/** As it was, moving where it moved. */
async function giveBack(left: Snapshot | null, { store, files, openInitial }: ReturnPointParts): Promise<void> {
  if (!left) {
    // Of the guide's pages nothing is left: what is opened looks as on a first visit.
    store.set({ view: DEFAULT_VIEW });
    return openInitial();
  }
  const { playing } = left.state.play;
  if ((await files.again(left, null)) && playing) store.set({ play: { ...store.get().play, playing } });
}
