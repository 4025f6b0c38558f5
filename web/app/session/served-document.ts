/** The document of the running sequences. A refused or cancelled edit returns to it. */
import type { AppState, Doc } from '../../model/state.ts';
import type { ShownMotions } from './sequence-plan.ts';
import { showsOtherMotions } from './state-changes.ts';
import type { Store } from './store.ts';

export class ServedDocument {
  private served: { doc: Doc; view: ShownMotions } | null = null;

  constructor(private readonly store: Store) {}

  /** The sequences match this state now. */
  note({ doc, view: { compare, ghostDifference, ghostSizes } }: AppState): void {
    this.served = { doc, view: { compare, ghostDifference, ghostSizes } };
  }

  goBack(): void {
    if (!this.served) return;
    const { doc, view } = this.served;
    const before = this.store.get();
    if (showsOtherMotions(before.view, view)) this.store.set({ view: { ...before.view, ...view } });
    if (before.doc !== doc) this.store.revert(doc);
  }
}
