/** A command: what it does, and by which key and button. Keyboard, help and buttons read the same table. */
import type { IconName } from '../../ui/icons.ts';
import type { Context } from './context.ts';

export interface Action {
  /** `event.key`, lower case; with 'ctrl+' and 'shift+' before it where they are needed. */
  keys?: readonly string[];
  /** The keys as help and tooltips show them, separated by two spaces. */
  shown?: string;
  /** For the help. */
  does?: string;
  /** A key that edits closes the sheet that covers what is edited. */
  edits?: boolean;
  button?: Button;
  run(context: Context, ...args: never[]): unknown;
}

export type Actions = Readonly<Record<string, Action>>;

/** In the header: at its start, for the history, or at its end; or among the views below the shape. */
export type Place = 'start' | 'history' | 'end' | 'views';

export interface Button {
  in: Place;
  testId: string;
  label: string;
  icon?: IconName;
  /** Stands beside the icon. */
  text?: string;
  kind?: 'primary';
  now?(context: Context): ButtonState;
}

/** How the button stands now. */
export interface ButtonState {
  /** Instead of the label in the tooltip; where it is the name itself, `label`. */
  hint?: string;
  label?: string;
  disabled?: boolean;
  hidden?: boolean;
  pressed?: boolean;
}

type Arguments<Run> = Run extends (context: Context, ...args: infer Args) => unknown ? Args : never;

/** The commands, each with the app that it works on. */
export type Bound<Table extends Actions> = {
  readonly [Id in keyof Table]: (...args: Arguments<Table[Id]['run']>) => ReturnType<Table[Id]['run']>;
};

/** What fails is said; a promise of it resolves all the same. */
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
