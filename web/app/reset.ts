/** Restores the start of a visit without reloading the page, for tests that share a page. */
import { DEFAULT_VIEW, EMPTY_STATE } from '../model/state.ts';
import type { Context } from './actions/context.ts';
import type { Offers } from './view/offers.ts';
import { EMPTY_OPENED, NO_CHOICES } from './view/view-state.ts';

export interface ResetParts {
  context: Context;
  offers: Offers;
  /** Opens the initial content of a visit whose URL has this fragment. */
  visit(fragment: string): Promise<void>;
}

export async function reset({ context, offers, visit }: ResetParts, fragment: string): Promise<void> {
  const { session, viewState, feedback, theme, files, remembered, animation, exporting, link } = context;
  exporting.now?.cancel();
  animation.now?.cancel();
  session.cancel();
  await files.idle();
  closeAll();
  animation.now?.dropReference();
  session.store.set({ project: null, view: DEFAULT_VIEW, play: EMPTY_STATE.play });
  await remembered.forgetAll();
  while (theme.theme() !== 'system') theme.next();
  link.replace(fragment);
  offers.withdraw();
  feedback.clear();
  viewState.change({ errorMessage: null, welcome: true, singleKeys: true, charts: NO_CHOICES });
  viewState.changeOpened(EMPTY_OPENED);
  await visit(fragment);
  files.history.forget();
  viewState.change({ welcome: session.store.get().source.kind === 'sample' });
  // The shape is fitted below the overlays, which are drawn with the next frame.
  await files.idle();
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  const { view } = session.store.get();
  if (view.camera) return;
  // Fits the view to the shape again.
  context.display.scene.viewer.refit(false);
  session.store.set({ view });
}

/** Closes and resets everything that the user has opened, chosen and scrolled. */
function closeAll(): void {
  const { body } = document;
  for (const dialog of document.querySelectorAll<HTMLDialogElement>('dialog[open]')) dialog.close();
  for (const key of ['pointerdown', 'pointerup']) body.dispatchEvent(new PointerEvent(key, { bubbles: true }));
  for (const card of document.querySelectorAll('.card:not([hidden]), .app[data-sheet]'))
    card.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
  for (const opened of document.querySelectorAll<HTMLDetailsElement>('details[open]')) opened.open = false;
  for (const part of document.querySelectorAll('.side, .key-list')) part.scrollTo(0, 0);
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
}
