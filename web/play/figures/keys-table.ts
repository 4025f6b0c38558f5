/** An editable table of the keys. */
import { button, numberField } from '../../ui/controls.ts';
import { h, setAttribute, setField, setText } from '../../ui/dom.ts';
import type { PlayKey, PlayState } from '../state.ts';
import { MIN_KEYS } from '../state.ts';
import type { Part } from './figure.ts';

export type KeyField = 'time' | 'value' | 'across';

export interface KeysTableEvents {
  onType(key: number, field: KeyField, value: number): void;
  onSelect(key: number): void;
  onRemove(key: number): void;
}

const FIELDS: readonly KeyField[] = ['time', 'value', 'across'];

export function createKeysTable(events: KeysTableEvents): Part<HTMLElement> {
  const valueHead = h('th', { scope: 'col' });
  const acrossHead = h('th', { scope: 'col' }, 'across');
  const body = h('tbody', {});
  const rows: ReturnType<typeof createRow>[] = [];
  const element = h(
    'table',
    { class: 'numbers keys-table', 'data-testid': 'keys-table' },
    h('caption', { class: 'visually-hidden' }, 'The keys'),
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, 'key'),
        h('th', { scope: 'col' }, 'time'),
        valueHead,
        acrossHead,
        h('td', {}),
      ),
    ),
    body,
  );
  return {
    element,
    update({ state, derived: { times } }) {
      while (rows.length < state.keys.length) body.append(rows[rows.push(createRow(rows.length, events)) - 1]!.element);
      while (rows.length > state.keys.length) rows.pop()!.element.remove();
      setText(valueHead, state.taken?.unit ? `value, ${state.taken.unit}` : 'value');
      acrossHead.hidden = !state.plane;
      rows.forEach((row, i) => row.update(state, { ...state.keys[i]!, time: times[i]! }));
    },
  };
}

function createRow(index: number, { onType, onSelect, onRemove }: KeysTableEvents) {
  const field = (name: KeyField): HTMLInputElement =>
    numberField({
      label: `${name} of key ${index + 1}`,
      testId: `key-${index}-${name}`,
      onInput: (value) => onType(index, name, value),
    });
  const fields = FIELDS.map(field);
  const remove = button({
    label: `Delete key ${index + 1}`,
    testId: `key-${index}-delete`,
    icon: 'trash',
    onClick: () => onRemove(index),
  });
  const cells = fields.map((input) => h('td', {}, input));
  const element = h(
    'tr',
    { onfocusin: () => onSelect(index) },
    h('th', { scope: 'row' }, String(index + 1)),
    ...cells,
    h('td', {}, remove),
  );
  return {
    element,
    update(state: PlayState, key: PlayKey): void {
      setAttribute(element, 'data-lit', index === state.selected);
      cells[2]!.hidden = !state.plane;
      fields.forEach((input, i) => setField(input, String(Number(key[FIELDS[i]!].toPrecision(6)))));
      const atEnd = index === 0 || index === state.keys.length - 1;
      fields[0]!.disabled = state.spacing !== 'hand' || atEnd;
      remove.disabled = state.keys.length <= MIN_KEYS;
    },
  };
}
