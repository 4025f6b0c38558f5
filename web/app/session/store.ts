/** Holds the state, notifies its subscribers, and keeps the document's history for undo and redo. */
import { type Orientation, reorientedDoc } from '../../model/orientation.ts';
import type { AppState, Doc } from '../../model/state.ts';

/** Edits of the same kind within this time form one undo step, so repeated key presses are undone together. */
const MERGE_MS = 1000;
const HISTORY_LIMIT = 200;

export interface Store {
  get(): AppState;
  /** Changes state without undo: time, playback, view. */
  set(change: Partial<Omit<AppState, 'doc'>>): void;
  /**
   * Changes the document as one undo step. Edits with the same `merge` form one step if they follow quickly or during
   * one pointer press.
   */
  edit(label: string, change: (doc: Doc) => Doc, merge?: string): void;
  /** The files were read with another orientation; `change` turns the document. One undo step, like an edit. */
  turned(label: string, turn: Turn, change: (doc: Doc) => Doc): void;
  /** Reports that a pointer was pressed or released. A drag is one undo step, however long it takes. */
  hold(down: boolean): void;
  /** Returns to an earlier document and its history, for refused edits. */
  revert(doc: Doc, history: History): void;
  /** A new import: replaces the state and the history. */
  reset(state: AppState, history?: History): void;
  /** The current undo and redo steps. The lists do not change later. */
  history(): History;
  /** `step`: the step whose files were read, by default the last one. Edits made meanwhile stay. */
  undo(step?: Step): void;
  redo(step?: Step): void;
  /** Label of the next edit to undo or redo, or null. */
  undoLabel(): string | null;
  redoLabel(): string | null;
  subscribe(listener: (state: AppState) => void): () => void;
}

/** The files' orientation before and after a step. */
export interface Turn {
  before: Orientation;
  after: Orientation;
}

export interface Step {
  label: string;
  doc: Doc;
  turn?: Turn;
}

/** The steps of undo and redo, the next step last. */
export interface History {
  past: readonly Step[];
  future: readonly Step[];
}

const NO_HISTORY: History = { past: [], future: [] };
const NOT_MERGED = { merge: '', at: -Infinity };

const turnedBy = (doc: Doc, from?: Orientation, to?: Orientation): Doc =>
  from && to ? reorientedDoc(doc, from, to) : doc;

export function createStore(initial: AppState, now: () => number = () => performance.now()): Store {
  let state = initial;
  let past: readonly Step[] = [];
  let future: readonly Step[] = [];
  let last = NOT_MERGED;
  let held = false;
  const listeners = new Set<(state: AppState) => void>();

  const publish = (next: AppState): void => {
    state = next;
    for (const listener of listeners) listener(state);
  };

  const go = (doc: Doc, history: History): void => {
    // Merging needs the step of the first edit.
    if (history.past.at(-1) !== past.at(-1)) last = NOT_MERGED;
    ({ past, future } = history);
    publish({ ...state, doc });
  };

  const remember = (step: Step): void => {
    past = [...past.slice(1 - HISTORY_LIMIT), step];
    future = [];
  };

  return {
    get: () => state,
    set: (change) => publish({ ...state, ...change }),
    edit(label, change, merge = '') {
      const doc = change(state.doc);
      if (doc === state.doc) return;
      const merged = merge !== '' && merge === last.merge && (held || now() - last.at < MERGE_MS);
      if (merged) future = [];
      else remember({ label, doc: state.doc });
      last = { merge, at: now() };
      publish({ ...state, doc });
    },
    turned(label, turn, change) {
      remember({ label, doc: state.doc, turn });
      last = NOT_MERGED;
      publish({ ...state, doc: change(state.doc) });
    },
    hold(down) {
      if (down && !held) last = NOT_MERGED;
      held = down;
    },
    history: () => ({ past, future }),
    revert: go,
    reset(next, history = NO_HISTORY) {
      ({ past, future } = history);
      last = NOT_MERGED;
      publish(next);
    },
    undo(step = past.at(-1)) {
      if (!step) return;
      const earlier = past.slice(0, past.indexOf(step));
      if (step === past.at(-1))
        return go(step.doc, { past: earlier, future: [...future, { ...step, doc: state.doc }] });
      // Below later edits, only a turn of the files can be undone. These edits keep their steps.
      const back = (doc: Doc): Doc => turnedBy(doc, step.turn?.after, step.turn?.before);
      const later = past.slice(earlier.length + 1).map((one) => ({ ...one, doc: back(one.doc) }));
      go(back(state.doc), { past: [...earlier, ...later], future });
    },
    redo(step = future.at(-1)) {
      if (!step) return;
      const done = [...past, { ...step, doc: state.doc }];
      // A later edit has removed the steps to redo.
      if (step === future.at(-1)) go(step.doc, { past: done, future: future.slice(0, -1) });
      else go(turnedBy(state.doc, step.turn?.before, step.turn?.after), { past: done, future });
    },
    undoLabel: () => past.at(-1)?.label ?? null,
    redoLabel: () => future.at(-1)?.label ?? null,
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
