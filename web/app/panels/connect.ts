/** Distributes the shown state to the page's components. */
import type { AppState } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import type { Component } from '../../ui/dom.ts';
import type { Theme } from '../../ui/theme.ts';
import type { Context } from '../actions/context.ts';
import type { OpenedState, PageState } from '../view/view-state.ts';

export interface Shown {
  state: AppState;
  page: PageState;
  opened: OpenedState;
  range: Range;
  theme: Theme;
  /** Whether nothing is open. */
  disabled: boolean;
}

export function shownOf({ session: { store, range }, viewState: { page, opened }, theme }: Context): Shown {
  return {
    state: store.get(),
    page,
    opened,
    range: range(),
    theme: theme.theme(),
    disabled: opened.info === null,
  };
}

/** Keeps a component up to date; returns its element. */
export type Connect = <Props>(component: Component<Props>, props: (shown: Shown) => Props) => HTMLElement;

export interface Connections {
  connect: Connect;
  update(shown: Shown): void;
}

/** Components are updated in the order in which they were connected. */
export function createConnections(): Connections {
  const updates: ((shown: Shown) => void)[] = [];
  return {
    connect(component, props) {
      updates.push((shown) => component.update(props(shown)));
      return component.element;
    },
    update: (shown) => updates.forEach((update) => update(shown)),
  };
}

/** Returns the previous result while the arguments stay the same. */
export function latest<Args extends readonly unknown[], Result>(
  make: (...args: Args) => Result,
): (...args: Args) => Result {
  let last: { args: Args; result: Result } | null = null;
  return (...args) => {
    if (!last?.args.every((arg, index) => arg === args[index])) last = { args, result: make(...args) };
    return last.result;
  };
}
