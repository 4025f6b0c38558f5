/** Pins on the shape: placed by a click, moved by dragging. */
import { METHOD } from '../../engine/api/methods.ts';
import { changedPin, withPin, withoutPin } from '../../model/pins.ts';
import { createPinHandles } from '../../ui/pin-handles.ts';
import type { Place } from '../../ui/pin-handles.ts';
import type { PinDrag } from '../drawing/pin-positions.ts';
import { pinPositions, startPinDrag, vertexAt } from '../drawing/pin-positions.ts';
import type { Context } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';

export interface PinsInView {
  element: HTMLElement;
  /** Pins the vertex at a point of the view. */
  place(at: Place): void;
  /** Marks the vertex that a click would pin. */
  mark(at: Place): void;
}

export function createPinsInView(context: Context, commands: Commands): PinsInView {
  const { session, display, viewState, feedback } = context;
  const { store, range } = session;
  const { scene } = display;
  const pins = () => store.get().doc.motion.pins;
  let dragged: PinDrag | null = null;
  const handles = createPinHandles({
    onStart(index) {
      commands.seek(store.get().time);
      dragged = startPinDrag(scene.viewer, store.get(), range(), index);
    },
    onMove(index, to) {
      if (dragged)
        commands.pins(changedPin(pins(), index, { path: dragged.pathTo(to) }), `pin ${index} ${dragged.time}`);
    },
    onRemove: (index) => commands.pins(withoutPin(pins(), index)),
  });
  /** Pins are shown for the method itself, on the curve, and not in film strips and presentations. */
  const shown = (): boolean => {
    const { doc, view } = store.get();
    return METHOD[doc.motion.method].holds && !view.film && view.present === null && viewState.opened.blend === null;
  };
  const update = (): void => {
    const isShown = shown();
    handles.update(
      isShown ? pinPositions(scene.viewer, pins()) : [],
      isShown ? display.pinPaths.now.map((path) => scene.viewer.project(path)) : [],
    );
  };
  scene.viewer.follow(update);
  const picked = (at: Place): number | null => {
    const face = scene.pick(at.x, at.y);
    const faces = viewState.opened.info?.faces;
    return face < 0 || !faces ? null : vertexAt(scene.viewer, faces, face, at);
  };
  return {
    element: handles.element,
    place(at) {
      const vertex = picked(at);
      if (vertex === null) return feedback.say('That is not part of the shape. Click the shape itself.');
      commands.pins(withPin(pins(), vertex));
      viewState.changeOpened({ placing: false });
    },
    mark(at) {
      const vertex = picked(at);
      handles.mark(vertex === null ? null : (pinPositions(scene.viewer, [{ vertex }])[0] ?? null));
    },
  };
}
