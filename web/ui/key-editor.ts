/** Editor of one key. Not modal: shape and time stay usable while it is open. */
import { button } from './controls.ts';
import { h, setHidden, setText } from './dom.ts';
import type { IconName } from './icons.ts';
import type { KeyRef } from '../model/state.ts';
import type { KeyFieldsEvents, KeyFieldsProps } from './key-fields.ts';
import { createKeyFields } from './key-fields.ts';

export interface EditedKey extends KeyRef {
  isReference: boolean;
}

export interface KeyEditorProps extends KeyFieldsProps {
  keys: readonly EditedKey[];
  /** Id of the open content; the editor closes when it changes. */
  owner: string | null;
  canRemove: boolean;
}

export interface KeyEditorEvents extends KeyFieldsEvents {
  onMove(from: number, to: number): void;
  onRemove(key: number): void;
  onReference(key: number): void;
}

const OTHER_WORK = '.side, .app-header, .tabs, .warning-count';

function isOwn(target: EventTarget | null): boolean {
  return document.querySelector('dialog[open]') !== null || (target as Element | null)?.closest?.('.popover') != null;
}

export interface KeyEditor {
  element: HTMLElement;
  /** `from`: the pressed element, which gets the focus back. False if the call closes the editor. */
  open(index: number, from: HTMLElement): boolean;
  update(props: KeyEditorProps): void;
}

export function createKeyEditor(events: KeyEditorEvents): KeyEditor {
  let index = 0;
  /** The pose of the edited key, because changing its time may change its index. */
  let pose: KeyRef['pose'] | null = null;
  let props: KeyEditorProps | null = null;
  let opener: HTMLElement | null = null;
  const title = h('h2', {});
  const fields = createKeyFields(events);
  const actions = createKeyActions({
    onMove: (by) => {
      index += by;
      events.onMove(index - by, index);
    },
    onReference: () => events.onReference(index),
    onRemove: () => {
      events.onRemove(index);
      close();
    },
  });
  const element = h(
    'div',
    { class: 'card key-editor', role: 'dialog', 'data-testid': 'key-editor', 'aria-label': 'Edit key', hidden: true },
    h(
      'header',
      {},
      title,
      button({ label: 'Close', testId: 'key-editor-close', icon: 'close', shortcut: 'Esc', onClick: () => close() }),
    ),
    ...fields.elements,
    ...actions.elements,
  );

  const hide = (): void => {
    if (element.hidden) return;
    element.hidden = true;
    fields.leave();
  };
  const close = (): void => {
    if (element.hidden) return;
    hide();
    opener?.focus();
  };
  closeForOtherWork(element, { close, hide });

  const draw = (): void => {
    if (!props || element.hidden) return;
    if (!props.keys[index]) return close();
    setText(title, `Key ${index + 1}`);
    fields.update(props, index);
    actions.update(props, index);
  };

  return {
    element,
    open(at, from) {
      if (!element.hidden && at === index) {
        close();
        return false;
      }
      index = at;
      pose = props?.keys[at]?.pose ?? null;
      opener = from;
      element.hidden = false;
      draw();
      fields.focus();
      return true;
    },
    update(next) {
      if (props && next.owner !== props.owner) hide();
      props = next;
      if (next.keys[index]?.pose !== pose) index = next.keys.findIndex((key) => key.pose === pose);
      draw();
    },
  };
}

function closeForOtherWork(element: HTMLElement, { close, hide }: { close(): void; hide(): void }): void {
  // Handles Escape before other elements, wherever the focus is. Dialogs and menus handle their own.
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape' || element.hidden || isOwn(event.target)) return;
      event.stopPropagation();
      close();
    },
    { capture: true },
  );
  // Moving the shape or the time and undo keep it open; other actions close it.
  document.addEventListener('pointerdown', ({ target }) => {
    if (target instanceof Element && target.closest(OTHER_WORK) && !target.closest('.history')) hide();
  });
  window.addEventListener('drop', hide, { capture: true });
}

/** Actions on a whole key. */
function createKeyActions(events: { onMove(by: 1 | -1): void; onReference(): void; onRemove(): void }): {
  elements: HTMLElement[];
  update(props: KeyEditorProps, index: number): void;
} {
  const act = (testId: string, symbol: IconName, text: string, label: string, onClick: () => void): HTMLButtonElement =>
    button({ label, testId, icon: symbol, text, onClick });
  const earlier = act('key-earlier', 'left', 'Move earlier', 'Move earlier in the order', () => events.onMove(-1));
  const later = act('key-later', 'right', 'Move later', 'Move later in the order', () => events.onMove(1));
  const measure = 'Measure deformations from this key';
  const reference = act('key-reference', 'check', 'Use as reference', measure, () => events.onReference());
  const remove = act('key-remove', 'trash', 'Remove', 'Remove this key', () => events.onRemove());
  const reason = h('p', { class: 'reason', hidden: true }, 'A motion needs at least two keys.');
  return {
    elements: [
      h('div', { class: 'button-row' }, earlier, later),
      h('div', { class: 'button-row' }, reference, remove),
      reason,
    ],
    update({ keys, canRemove }, index) {
      earlier.disabled = index === 0;
      later.disabled = index === keys.length - 1;
      reference.disabled = keys[index]!.isReference;
      remove.disabled = !canRemove;
      setHidden(reason, canRemove);
    },
  };
}
