/** Commands on the view of the shape. */
import type { ViewName } from '../../model/camera.ts';
import type { View } from '../../model/state.ts';
import { reducedMotion } from '../view/window-events.ts';
import type { Blend } from '../view/view-state.ts';
import type { Action, Actions } from './action.ts';
import { changeView } from './context.ts';
import type { Context } from './context.ts';
import { play } from './time.ts';

export const VIEW = {
  fit: {
    keys: ['f'],
    shown: 'F',
    does: 'Fit the shape into view',
    button: { in: 'views', testId: 'fit', label: 'Fit the shape into view', icon: 'fit', text: 'Fit' },
    run: (context) => fitView(context, null),
  },
  front: standardView('front', 'Front', '1'),
  top: standardView('top', 'Top', '7'),
  right: standardView('right', 'Right', '3'),
  home: { keys: ['h'], shown: 'H', does: 'Initial view', run: (context) => fitView(context, 'home') },
  toggleLook: {
    keys: ['v'],
    shown: 'V',
    does: 'Display: colour and shading',
    run: ({ overlays }) => overlays.toggleLook(),
  },
  toggleWireframe: {
    keys: ['w'],
    shown: 'W',
    does: 'Wireframe',
    run: (context) => changeView(context, { wireframe: !viewOf(context).wireframe }),
  },
  toggleFloor: {
    keys: ['g'],
    shown: 'G',
    does: 'Floor',
    run: (context) => changeView(context, { floor: !viewOf(context).floor }),
  },
  toggleOnion: {
    keys: ['o'],
    shown: 'O',
    does: 'Onion skin',
    run: (context) => changeView(context, { onion: !viewOf(context).onion, film: false }),
  },
  toggleFilm: {
    keys: ['i'],
    shown: 'I',
    does: 'Film strip',
    run: (context) => changeView(context, { film: !viewOf(context).film, onion: false }),
  },
  view: { run: changeView },
  /** Shows a blend of the keys; null shows the motion again. */
  blend: { run: showBlend },
  /** Marks the faces or vertices of a figure on the shape. */
  mark: {
    run({ display: { marking } }, what: { face: number } | { patches: readonly number[] } | null) {
      if (!what) marking.component(null);
      else if ('face' in what) marking.around(what.face);
      else marking.patches(what.patches);
    },
  },
  markLost: { run: ({ display, viewState }) => display.marking.around(viewState.opened.indefiniteFace) },
  markWarning: { run: ({ display }, index: number | null) => display.marking.warning(index) },
} satisfies Actions;

function viewOf({ session: { store } }: Context): View {
  return store.get().view;
}

function fitView({ display: { scene } }: Context, view: ViewName | null): void {
  scene.fit(view, !reducedMotion());
}

function standardView(name: ViewName, label: string, key: string) {
  return {
    keys: [key],
    shown: key,
    does: `${label} view`,
    button: { in: 'views', testId: `view-${name}`, label: `${label} view`, text: label },
    run: (context: Context) => fitView(context, name),
  } as const satisfies Action;
}

export function showBlend(context: Context, blend: Blend | null): void {
  const { session, viewState, display } = context;
  const { store } = session;
  if (blend === viewState.opened.blend) return;
  if (blend && store.get().play.playing) play(context, { playing: false });
  viewState.changeOpened({ blend });
  display.playback.frameLoop.follow(store.get().time);
}
