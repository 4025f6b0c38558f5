/** Undo and redo of edits and, past the first edit, of opening. */
import type { Source } from '../../model/state.ts';
import type { Step, Store, Turn } from '../session/store.ts';
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
  const { history } = files;
  let last: Promise<boolean> | null = null;
  /** Runs the step after those that still read files. If one of them is cancelled, so are the later ones. */
  const inTurn = (run: () => boolean | Promise<boolean>): void => {
    const done = last ? last.then((before) => before && run()) : run();
    if (typeof done === 'boolean') return;
    last = done;
    void done.then(() => (last = last === done ? null : last));
  };
  /** Performs the step once the files have its orientation. The user may edit the document meanwhile. */
  const stepOver = (step: Step, to: keyof Turn, move: (step: Step) => void): boolean | Promise<boolean> => {
    const finish = (done: boolean): boolean => {
      if (done) move(step);
      return done;
    };
    return step.turn ? files.reorient(step.turn[to], null).then(finish) : finish(true);
  };
  const undo = (): boolean | Promise<boolean> => {
    const step = store.history().past.at(-1);
    return step ? stepOver(step, 'before', store.undo) : files.back();
  };
  const redo = (): boolean | Promise<boolean> => {
    const step = store.history().future.at(-1);
    return step ? stepOver(step, 'after', store.redo) : files.forth();
  };
  const opening = (source: Source | undefined): string | null => (source ? `open ${titleOf(source)}` : null);
  return {
    undo: () => inTurn(undo),
    redo: () => inTurn(redo),
    undoLabel: () => store.undoLabel() ?? opening(history.before ? store.get().source : undefined),
    redoLabel: () => store.redoLabel() ?? opening(history.after?.state.source),
  };
}
