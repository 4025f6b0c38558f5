/** A command: what it does, its keys and its button. Keyboard, help and buttons read the same table. */
import type { IconName } from '../../ui/icons.ts';
import type { Context } from './context.ts';

export interface Action {
  /** `event.key` in lower case, prefixed with 'ctrl+' and 'shift+' as needed. */
  keys?: readonly string[];
  /** Key names in help and tooltips, separated by two spaces. */
  shown?: string;
  /** The line in the help. */
  does?: string;
  /** It edits the document, so its key first closes the import dialog, which covers the panels. */
  edits?: boolean;
  button?: Button;
  run(context: Context, ...args: never[]): unknown;
}

export type Actions = Readonly<Record<string, Action>>;

/** Header start, history or end, or the bar below the shape. */
export type Place = 'start' | 'history' | 'end' | 'views';

export interface Button {
  in: Place;
  testId: string;
  label: string;
  icon?: IconName;
  /** Text beside the icon. */
  text?: string;
  kind?: 'primary';
  now?(context: Context): ButtonState;
}

/** Parts of a button that change. */
export interface ButtonState {
  /** Replaces the label in the tooltip. */
  hint?: string;
  label?: string;
  disabled?: boolean;
  hidden?: boolean;
  pressed?: boolean;
}

type Arguments<Run> = Run extends (context: Context, ...args: infer Args) => unknown ? Args : never;

/** Commands without their first argument, the context. */
export type Bound<Table extends Actions> = {
  readonly [Id in keyof Table]: (...args: Arguments<Table[Id]['run']>) => ReturnType<Table[Id]['run']>;
};

/** Binds each command to the context. The page shows a failure; the promise resolves anyway. */
export function bindActions<Table extends Actions>(table: Table, context: Context): Bound<Table> {
  const { onError } = context.feedback;
  const bind =
    (action: Action) =>
    (...args: never[]): unknown => {
      const done = action.run(context, ...args);
      return done instanceof Promise ? done.catch(onError) : done;
    };
  return Object.fromEntries(Object.entries(table).map(([id, action]) => [id, bind(action)])) as Bound<Table>;
}
