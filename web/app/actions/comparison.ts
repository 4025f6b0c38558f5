/** Commands to compare motions and to present. */
import { OWN_METHOD } from '../../engine/api/methods.ts';
import type { Method } from '../../engine/api/types.ts';
import { departsFromPaper } from '../../model/spline-options.ts';
import { PRESENTED } from '../../model/state.ts';
import type { Plot, Presented } from '../../model/state.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';
import { jumpKey } from './time.ts';
import { changeView } from './context.ts';

/** Ordered from the best-known method to the closest to ours. */
const COMPARED: readonly Method[] = [
  'linear',
  'cubic-vertex',
  'geodesic',
  'rotation-strain',
  'rimd',
  'lengths',
  'shell',
  'lri',
];

export const COMPARISON = {
  toggleSplit: { keys: ['s'], shown: 'S', does: 'Divider between two motions on or off', run: toggleSplit },
  nextComparison: {
    keys: ['c'],
    shown: 'C',
    does: 'Compare with the next method, then with none',
    run: nextComparison,
  },
  togglePresent: {
    keys: ['x'],
    shown: 'X',
    does: 'Presentation mode: only the shape, with large type',
    run: (context) => present(context, presented(context) === null ? 'shape' : null),
  },
  nextPlot: { keys: ['a'], shown: 'A', does: 'Presentation: cycle through plots', run: nextPlot },
  turnPage: {
    shown: 'Page Up  Page Down',
    does: 'Presentation: previous or next key or tour page. Otherwise: as Shift with an arrow key',
    run: jumpKey,
  },
  compare: { run: (context, methods: Method[]) => changeView(context, { compare: methods }) },
  split: { run: (context, split: number) => changeView(context, { split }) },
  present: { run: present },
  /** Enlarges the plot beside the shape, or restores its size. */
  enlarge: { run: (context, plot: Plot) => present(context, presented(context) === plot ? null : plot) },
} satisfies Actions;

function presented({ session: { store } }: Context): Presented | null {
  return store.get().view.present;
}

export function present(context: Context, what: Presented | null): void {
  changeView(context, { present: what });
}

/** Puts a divider between two motions, or removes it and restores the previous comparison. */
function toggleSplit(context: Context): void {
  const { doc, view } = context.session.store.get();
  const { compare, split } = view;
  const { beside } = context.viewState.page;
  if (split !== null) return changeView(context, { split: null, compare: [...beside] });
  const { method } = doc.motion;
  context.viewState.change({ beside: compare });
  const departing = departsFromPaper(doc);
  const usual = departing || method === 'linear' ? OWN_METHOD : 'linear';
  const other = compare.find((one) => one !== method || departing) ?? usual;
  changeView(context, { split: 0.5, compare: [other] });
}

/** Compares with the next method behind a divider. After the last method, stops comparing. */
function nextComparison(context: Context): void {
  const { doc, view } = context.session.store.get();
  const others = COMPARED.filter((method) => method !== doc.motion.method || departsFromPaper(doc));
  const next = others[others.indexOf(view.compare.at(-1) as Method) + 1];
  if (next) changeView(context, { compare: [next], split: view.split ?? 0.5 });
  else changeView(context, { compare: [], split: null });
}

/**
 * Shows the next plot in a presentation, starting with that of the guide's page. After the last plot, shows only the
 * shape.
 */
function nextPlot(context: Context): void {
  const own = context.guide.now?.plot ?? null;
  const order: Presented[] = PRESENTED.filter((one) => one !== own);
  if (own) order.splice(1, 0, own);
  const shown = order.indexOf(presented(context) ?? 'shape');
  present(context, order[(shown + 1) % order.length]!);
}
