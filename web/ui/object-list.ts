/** Check boxes for the objects, if the files have several. */
import { checkbox } from './controls.ts';
import { h, memo, setHidden } from './dom.ts';

export interface ObjectList {
  element: HTMLElement;
  /** `taken`: empty for all objects. The list is hidden for fewer than two objects. */
  update(props: { names: readonly string[]; taken: readonly string[] }): void;
}

/** onTake receives the remaining names in the order of the files. */
export function createObjectList(onTake: (names: string[]) => void): ObjectList {
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
  return { element, update: draw };
}
