/** Code loaded on first use. */
import { h } from './dom.ts';

export interface Lazy<T> {
  /** The loaded code; null until loaded. */
  readonly now: T | null;
  /** Tries again after a failure. */
  get(): Promise<T>;
}

export function lazy<T>(load: () => Promise<T>): Lazy<T> {
  let now: T | null = null;
  let loading: Promise<T> | null = null;
  const begin = async (): Promise<T> => {
    try {
      now = await load();
      return now;
    } catch (error) {
      loading = null;
      throw error;
    }
  };
  return {
    get now() {
      return now;
    },
    get: () => (loading ??= begin()),
  };
}

interface Component<Props> {
  element: HTMLElement;
  update?(props: Props): void;
}

export interface LazyComponent<Props, T> {
  element: HTMLElement;
  /** Stores the props until the component is loaded. */
  update(props: Props): void;
  /** Loads the component with the last props; null if loading fails, which is reported. */
  need(): Promise<T | null>;
}

/** A lazily loaded component. `element`: its container; a component may fill the container itself. */
export function lazyComponent<Props, T extends Component<Props>>(
  load: () => Promise<T>,
  onError: (error: unknown) => void,
  element: HTMLElement = h('div', { class: 'later' }),
): LazyComponent<Props, T> {
  let last: { props: Props } | null = null;
  const component = lazy(async () => {
    try {
      const made = await load();
      if (last) made.update?.(last.props);
      if (made.element !== element) element.append(made.element);
      return made;
    } catch (error) {
      onError(error);
      throw error;
    }
  });
  return {
    element,
    update(props) {
      last = { props };
      component.now?.update?.(props);
    },
    need: () => component.get().catch(() => null),
  };
}
