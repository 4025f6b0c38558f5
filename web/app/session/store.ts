/** Holds the state, notifies its subscribers, and keeps the document's history for undo and redo. */
import type { Orientation } from '../../model/orientation.ts';
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
  /** Replaces the document without an undo step, for refused edits. */
  revert(doc: Doc): void;
  /** A new import: replaces the state and the history. */
  reset(state: AppState, history?: History): void;
  /** The current undo and redo steps. */
  history(): History;
  undo(): void;
  redo(): void;
  /** Label of the next edit to undo or redo, or null. */
  undoLabel(): string | null;
  redoLabel(): string | null;
  /** The orientation that the files need for the next undo or redo step; null if unchanged. */
  undoTurn(): Orientation | null;
  redoTurn(): Orientation | null;
  subscribe(listener: (state: AppState) => void): () => void;
}

/** The files' orientation before and after a step. */
export interface Turn {
  before: Orientation;
  after: Orientation;
}

interface Step {
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

export function createStore(initial: AppState, now: () => number = () => performance.now()): Store {
  let state = initial;
  let past: Step[] = [];
  let future: Step[] = [];
  let last = { merge: '', at: -Infinity };
  let held = false;
  const listeners = new Set<(state: AppState) => void>();

  const publish = (next: AppState): void => {
    state = next;
    for (const listener of listeners) listener(state);
  };

  const step = (from: Step[], to: Step[]): void => {
    const target = from.pop();
    if (!target) return;
    to.push({ ...target, doc: state.doc });
    last = { merge: '', at: -Infinity };
    publish({ ...state, doc: target.doc });
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
      last = { merge: '', at: -Infinity };
      publish({ ...state, doc: change(state.doc) });
    },
    hold(down) {
      if (down && !held) last = { merge: '', at: -Infinity };
      held = down;
    },
    history: () => ({ past, future }),
    revert: (doc) => publish({ ...state, doc }),
    reset(next, history = NO_HISTORY) {
      past = [...history.past];
      future = [...history.future];
      last = { merge: '', at: -Infinity };
      publish(next);
    },
    undo: () => step(past, future),
    redo: () => step(future, past),
    undoLabel: () => past.at(-1)?.label ?? null,
    redoLabel: () => future.at(-1)?.label ?? null,
    undoTurn: () => past.at(-1)?.turn?.before ?? null,
    redoTurn: () => future.at(-1)?.turn?.after ?? null,
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
