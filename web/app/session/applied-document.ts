/** The document of the running sequences. A refused or cancelled edit returns to it. */
import type { AppState, Doc } from '../../model/state.ts';
import type { ShownMotions } from './sequence-plan.ts';
import { showsOtherMotions } from './state-changes.ts';
import type { History, Store } from './store.ts';

export class AppliedDocument {
  private applied: { doc: Doc; view: ShownMotions; history: History } | null = null;

  constructor(private readonly store: Store) {
    // Undoing a turn of the files changes the history, but not the document.
    store.subscribe(() => this.follow());
  }

  /** The sequences match this state now; `history` led to it. */
  note({ doc, view: { compare, ghostDifference, ghostSizes } }: AppState, history = this.store.history()): void {
    this.applied = { doc, view: { compare, ghostDifference, ghostSizes }, history };
    this.follow();
  }

  goBack(): void {
    if (!this.applied) return;
    const { doc, view, history } = this.applied;
    const before = this.store.get();
    if (showsOtherMotions(before.view, view)) this.store.set({ view: { ...before.view, ...view } });
    if (before.doc !== doc) this.store.revert(doc, history);
  }

  private follow(): void {
    if (this.applied?.doc === this.store.get().doc) this.applied.history = this.store.history();
  }
}
