/** A component that is loaded when it is needed for the first time, in the place that it then has. */
import { h } from '../../ui/dom.ts';

interface Component<Props> {
  element: HTMLElement;
  update(props: Props): void;
}

export interface Later<Props, T> {
  element: HTMLElement;
  /** Kept for the component while it is not there. */
  update(props: Props): void;
  /** The component, as it was last updated; null where it cannot be loaded, which was said. */
  need(): Promise<T | null>;
}

export function later<Props, T extends Component<Props>>(
  load: () => Promise<T>,
  onError: (error: unknown) => void,
): Later<Props, T> {
  const element = h('div', { class: 'later' });
  let loading: Promise<T | null> | null = null;
  let component: T | null = null;
  let last: { props: Props } | null = null;
  const make = async (): Promise<T | null> => {
    try {
      component = await load();
      if (last) component.update(last.props);
      element.append(component.element);
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
      component?.update(props);
    },
    need: () => (loading ??= make()),
  };
}
