/** Undo and redo of edits and, past the first edit, of opening. */
import type { Orientation } from '../../model/orientation.ts';
import type { Source } from '../../model/state.ts';
import type { Store } from '../session/store.ts';
import type { Opener } from './opener.ts';

export interface Undo {
  undo(): void;
  redo(): void;
  /** Label of the next step to undo or redo, or null. */
  undoLabel(): string | null;
  redoLabel(): string | null;
}

export interface UndoParts {
  store: Store;
  files: Opener;
  titleOf(source: Source): string;
}

export function createUndo({ store, files, titleOf }: UndoParts): Undo {
  /** Performs the step once the shape has the orientation of that step. */
  const stepOver = (turn: Orientation | null, step: () => void): void => {
    if (turn) void files.reorient(turn, null).then((done) => done && step());
    else step();
  };
  const opening = (source: Source | undefined): string | null => (source ? `open ${titleOf(source)}` : null);
  const { history } = files;
  return {
    undo() {
      if (store.undoLabel() !== null) stepOver(store.undoTurn(), store.undo);
      else void files.back();
    },
    redo() {
      if (store.redoLabel() !== null) stepOver(store.redoTurn(), store.redo);
      else void files.forth();
    },
    undoLabel: () => store.undoLabel() ?? opening(history.before ? store.get().source : undefined),
    redoLabel: () => store.redoLabel() ?? opening(history.after?.state.source),
  };
}
