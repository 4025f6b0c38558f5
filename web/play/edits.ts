/** Edits of the state by controls and handles. */
import { clamp } from '../model/time-scale.ts';
import { derive, timesOf } from './derived.ts';
import type { CurveFigureEvents } from './figures/curve-figure.ts';
import type { KeysTableEvents } from './figures/keys-table.ts';
import type { PanelEvents } from './panels.ts';
import { valueAt } from './splines/curve.ts';
import { addKey, moveKey, removeKey, setEnds, setShaping, showLayer, shownTimes, withKey } from './state.ts';
import type { Layer, PlayState, LastAction } from './state.ts';

export interface Edits extends PanelEvents, CurveFigureEvents, KeysTableEvents {
  onLayer(layer: Layer, on: boolean): void;
  onTime(time: number): void;
  /** The pointer or the focus is on a key's row of the system; -1: on none. */
  onLit(key: number): void;
}

export function createEdits(
  get: () => PlayState,
  change: (state: PlayState, lastAction: LastAction) => void,
  onLit: Edits['onLit'],
): Edits {
  const set = (part: Partial<PlayState>, lastAction: LastAction): void => change({ ...get(), ...part }, lastAction);
  const remove = (key: number): void => change(removeKey(get(), key), 'key');
  return {
    onPlane: (plane) => set({ plane }, 'plane'),
    onAdd: () =>
      change(
        addKey(get(), (time) => naturalAt(get(), time)),
        'key',
      ),
    onRemove: remove,
    onRemoveSelected: () => remove(get().selected),
    onSelect: (selected) => selected !== get().selected && set({ selected }, 'key'),
    onMove: (key, { along, value }) =>
      change(
        get().plane ? withKey(get(), key, { value, across: along }) : moveKey(get(), key, { time: along, value }),
        'key',
      ),
    onType: (key, field, value) =>
      change(
        field === 'time'
          ? moveKey(get(), key, { time: value, value: get().keys[key]!.value })
          : withKey(get(), key, { [field]: value }),
        'key',
      ),
    // Switching to manual spacing keeps the current times.
    onSpacing: (spacing) => set({ spacing, keys: timedKeys(get()) }, 'spacing'),
    onLayer: (layer, on) => change(showLayer(get(), layer, on), on ? layer : 'key'),
    onEnds: (ends) => change(setEnds(get(), ends), ends),
    onSamples: (samples) => set({ samples }, 'samples'),
    onShaping: (shaping) => change(setShaping(get(), shaping), 'shaping'),
    onSpeed(end, speed) {
      const [start, last] = get().speeds;
      set({ speeds: end === 'start' ? [speed, last] : [start, speed] }, 'speed');
    },
    onTime: (time) => set({ time: shownTime(get(), time) }, 'time'),
    onLit,
  };
}

function timedKeys(state: PlayState): PlayState['keys'] {
  const times = timesOf(state);
  return state.keys.map((key, i) => ({ ...key, time: times[i]! }));
}

/** The natural spline's value; two coordinates in two dimensions. */
function naturalAt(state: PlayState, time: number): { value: number; across: number } {
  const [value, across] = derive({ ...state, plane: true }).curves.natural.map((curve) => valueAt(curve, time));
  return { value: value!, across: across! };
}

/** The time, clamped to the range of plots over time. */
function shownTime(state: PlayState, time: number): number {
  const times = timesOf(state);
  return clamp(time, ...shownTimes([times[0]!, times.at(-1)!]));
}
