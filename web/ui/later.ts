/** A component that is loaded when it is needed for the first time, in the place that it then has. */
import { h } from './dom.ts';

interface Component<Props> {
  element: HTMLElement;
  update?(props: Props): void;
}

export interface Later<Props, T> {
  element: HTMLElement;
  /** Kept for the component while it is not there. */
  update(props: Props): void;
  /** The component, as it was last updated; null where it cannot be loaded, which was said. */
  need(): Promise<T | null>;
}

/** `element`: where it comes to stand; a component may fill it itself. */
export function later<Props, T extends Component<Props>>(
  load: () => Promise<T>,
  onError: (error: unknown) => void,
  element: HTMLElement = h('div', { class: 'later' }),
): Later<Props, T> {
  let loading: Promise<T | null> | null = null;
  let component: T | null = null;
  let last: { props: Props } | null = null;
  const make = async (): Promise<T | null> => {
    try {
      component = await load();
      if (last) component.update?.(last.props);
      if (component.element !== element) element.append(component.element);
    } catch (error) {
      loading = null;
      onError(error);
    }
    return component;
  };
  return {
    element,
    update(props) {
      last = { props };
      component?.update?.(props);
    },
    need: () => (loading ??= make()),
  };
}
