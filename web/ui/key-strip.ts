/** The keys as thumbnails: go to a key, move, retime, rename or remove it, or add one. */
import { button } from './controls.ts';
import { h, memo, say, setAttribute, setText } from './dom.ts';
import { icon } from './icons.ts';
import type { EditedKey, KeyEditor, KeyEditorEvents, KeyEditorProps } from './key-editor.ts';
import { lazyComponent } from './lazy.ts';
import { rovingTabindex } from './roving-tabindex.ts';
import { keyLabel, lowerFirst, shortNames } from '../model/key-names.ts';
import { SAME_TIME, formatTime, length } from '../model/time-scale.ts';

export interface KeyItem extends EditedKey {
  /** Image of the key, or null without one. */
  thumbnail: string | null;
}

export interface KeyStripProps extends KeyEditorProps {
  keys: readonly KeyItem[];
  time: number;
  disabled: boolean;
  /** Why the current shape cannot become a key, or null if it can. */
  addReason: string | null;
}

export interface KeyStripEvents extends KeyEditorEvents {
  onSeek(t: number): void;
  onAddCurrent(): void;
  onAddFile(): void;
  onError(error: unknown): void;
}

interface Card {
  element: HTMLElement;
  /** `short`: its name without the common first words of all names. */
  update(item: KeyItem, index: number, props: KeyStripProps, short: string): void;
}

export interface KeyStrip {
  element: HTMLElement;
  update(props: KeyStripProps): void;
  /** Index of the key after a drop position, or the number of keys at the end; null elsewhere. */
  placeAt(point: { x: number; y: number }): number | null;
  /** Marks the drop position before a key; null removes the mark. */
  showPlace(place: number | null): void;
}

export function createKeyStrip(events: KeyStripEvents): KeyStrip {
  const list = h('ol', { class: 'key-list', 'data-testid': 'keys' });
  const editor = lazyComponent<KeyStripProps, KeyEditor>(async () => {
    const { createKeyEditor } = await import('./key-editor.ts');
    return createKeyEditor(events);
  }, events.onError);
  const addCurrent = button({
    label: 'Add the current shape as a key',
    testId: 'add-current',
    icon: 'plus',
    text: 'Add key',
    shortcut: 'K',
    onClick: () => events.onAddCurrent(),
  });
  const addFile = button({
    label: 'Add a key from a file',
    testId: 'add-file',
    icon: 'open',
    text: 'Import pose',
    onClick: () => events.onAddFile(),
  });
  const element = h(
    'section',
    { class: 'key-strip', 'aria-label': 'Keys' },
    list,
    h('div', { class: 'key-actions' }, addCurrent, addFile),
    editor.element,
  );
  rovingTabindex(list);
  const cards: Card[] = [];
  // The page is notified only on drop.
  const drag = { from: -1 };
  const edit = (index: number, from: HTMLElement, time: number): void => {
    void editor.need().then((opened) => opened?.open(index, from) && events.onSeek(time));
  };
  const draw = memo((next: KeyStripProps) => {
    while (cards.length > next.keys.length) cards.pop()?.element.remove();
    const names = shortNames(next.keys.map(({ name }) => name));
    next.keys.forEach((item, index) => {
      let card = cards[index];
      if (!card) {
        card = createCard(events, drag, edit);
        cards.push(card);
        list.append(card.element);
      }
      card.update(item, index, next, names[index]!);
    });
    setAttribute(element, 'data-empty', next.keys.length === 0);
    addCurrent.disabled = next.disabled || next.addReason !== null;
    setAttribute(addCurrent, 'title', next.addReason ?? 'Add the current shape as a key (K)');
    addFile.disabled = next.disabled;
    editor.update(next);
  });

  const placeAt = ({ x, y }: { x: number; y: number }): number | null => {
    const { left, right, top, bottom } = list.getBoundingClientRect();
    // A hidden strip has no extent and is at the page's corner.
    if (x < left || x >= right || y < top || y >= bottom) return null;
    return cards.filter((card) => middleOf(card.element) < x).length;
  };
  const showPlace = (place: number | null): void =>
    cards.forEach((card, index) => {
      const after = place === cards.length && index === place - 1;
      setAttribute(card.element, 'data-drop', after ? 'after' : index === place ? 'before' : null);
    });
  return { element, update: draw, placeAt, showPlace };
}

function middleOf(element: HTMLElement): number {
  const { left, right } = element.getBoundingClientRect();
  return (left + right) / 2;
}

function createCard(
  events: KeyStripEvents,
  dragged: { from: number },
  onEdit: (index: number, from: HTMLElement, time: number) => void,
): Card {
  let index = 0;
  let time = 0;
  let removable = false;
  const image = h('img', { alt: '', draggable: 'false', width: 72, height: 54 });
  const badge = h('span', { class: 'badge' });
  const name = h('span', { class: 'key-name' });
  const when = h('span', { class: 'key-time' });
  const go = h(
    'button',
    { type: 'button', class: 'key-go', onclick: () => events.onSeek(time) },
    h('span', { class: 'thumb' }, image, badge),
    name,
    when,
  );
  const edit = h(
    'button',
    { type: 'button', class: 'key-edit', onclick: () => onEdit(index, edit, time) },
    icon('down'),
  );
  const element = h('li', { class: 'key-card', draggable: 'true' }, go, edit);
  listenToDrags(element, dragged, () => index, events);
  go.addEventListener('keydown', (event) => {
    if ((event.key === 'Delete' || event.key === 'Backspace') && removable) events.onRemove(index);
  });

  return {
    element,
    update(item, at, { range, time: now, disabled, canRemove }, short) {
      index = at;
      time = item.time;
      removable = canRemove && !disabled;
      const current = Math.abs(now - item.time) <= SAME_TIME * length(range);
      setAttribute(element, 'data-testid', `key-${at}`);
      setAttribute(element, 'data-pose', item.pose);
      setAttribute(element, 'data-current', current);
      setAttribute(go, 'aria-current', current ? 'true' : null);
      setAttribute(
        go,
        'aria-label',
        `${keyLabel(at, item.name)}, at ${formatTime(item.time, range)} s${item.isReference ? ', reference' : ''}`,
      );
      setAttribute(go, 'title', `Go to ${item.name || 'this key'}; drag to reorder the keys`);
      setAttribute(go, 'data-testid', `key-${at}-go`);
      setAttribute(edit, 'data-testid', `key-${at}-edit`);
      setAttribute(edit, 'aria-label', `Edit ${lowerFirst(keyLabel(at, item.name))}`);
      setAttribute(edit, 'title', 'Name, time, order, remove');
      setAttribute(image, 'src', item.thumbnail);
      setAttribute(image, 'hidden', item.thumbnail === null);
      setText(badge, String(at + 1));
      say(name, short);
      setText(when, `${Number(formatTime(item.time, range))} s`);
      go.disabled = disabled;
      edit.disabled = disabled;
    },
  };
}

const DRAGGED_KEY = 'application/x-shapespline-key';

/** Moves a key by dragging it to another key's position. */
function listenToDrags(
  element: HTMLElement,
  dragged: { from: number },
  indexOf: () => number,
  { onMove }: KeyStripEvents,
): void {
  element.addEventListener('dragstart', ({ dataTransfer }) => {
    dragged.from = indexOf();
    dataTransfer?.setData(DRAGGED_KEY, String(dragged.from));
    if (dataTransfer) dataTransfer.effectAllowed = 'move';
  });
  element.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes(DRAGGED_KEY)) return;
    event.preventDefault();
    setAttribute(element, 'data-drop', dragged.from < indexOf() ? 'after' : 'before');
  });
  element.addEventListener('dragleave', () => setAttribute(element, 'data-drop', null));
  element.addEventListener('drop', (event) => {
    setAttribute(element, 'data-drop', null);
    const from = event.dataTransfer?.getData(DRAGGED_KEY);
    if (!from) return;
    event.preventDefault();
    event.stopPropagation();
    onMove(Number(from), indexOf());
  });
}
