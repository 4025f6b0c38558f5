/** Check boxes for the objects, if the files have several. */
import type { KeysInfo } from '../engine/api/types.ts';
import { checkbox } from './controls.ts';
import type { Component } from './dom.ts';
import { h, memo, setHidden } from './dom.ts';

interface ObjectListProps {
  info: KeysInfo | null;
  /** The user's own files are open, so objects can be chosen again. */
  canSample: boolean;
  /** The chosen objects; empty for all. */
  objects: readonly string[];
}

const NO_NAMES: readonly string[] = [];

/** Hidden for fewer than two objects. onTake receives the remaining names in the order of the files. */
export function createObjectList(onTake: (names: string[]) => void): Component<ObjectListProps> {
  const boxes = h('div', { class: 'object-boxes' });
  const element = h(
    'div',
    { class: 'group', role: 'group', 'aria-label': 'Objects', hidden: true, 'data-testid': 'objects' },
    h('span', { class: 'label', title: 'Clear anything that is not part of the shape, such as a floor' }, 'Objects'),
    boxes,
  );
  const draw = memo(({ names, taken }: { names: readonly string[]; taken: readonly string[] }) => {
    setHidden(element, names.length < 2);
    if (names.length < 2) return boxes.replaceChildren();
    const isTaken = (name: string): boolean => taken.length === 0 || taken.includes(name);
    const count = names.filter(isTaken).length;
    boxes.replaceChildren(
      ...names.map((name, index) => {
        const box = checkbox(name, `object-${index}`, (on) =>
          onTake(names.filter((other) => (other === name ? on : isTaken(other)))),
        );
        // One object has to stay.
        box.update(isTaken(name), isTaken(name) && count === 1);
        return box.element;
      }),
    );
  });
  return {
    element,
    update: ({ info, canSample, objects }) => draw({ names: (canSample && info?.objects) || NO_NAMES, taken: objects }),
  };
}
