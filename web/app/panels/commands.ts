/** What the controls do to the document, the time and the view. */
import { METHOD, METHODS, OWN_METHOD } from '../../engine/api/methods.ts';
import { PER_KEY } from '../../engine/api/option-table.ts';
import type { KeyPace, Method, Pin } from '../../engine/api/types.ts';
import {
  addKey,
  moveKey,
  removeKey,
  renameKey,
  retimeKey,
  reverseMotion,
  setEncoding,
  setMotion,
  setShaping,
  setTightness,
  setTurns,
  spaceKeys,
} from '../../model/edits.ts';
import { SPACINGS } from '../../model/key-spacing.ts';
import type { Spacing } from '../../model/key-spacing.ts';
import type { ViewName } from '../../model/camera.ts';
import { undoName } from '../../model/page-options.ts';
import type { KeyTurns, ShapingNumber } from '../../model/shaping.ts';
import type { End } from '../../model/speeds.ts';
import { SPEED_NAME } from '../../model/speeds.ts';
import type { Doc, Encoding, LoopMode, Motion, Play, Plot, Presented, View } from '../../model/state.ts';
import {
  BOUNDARIES,
  DEFAULT_ENCODING,
  DEFAULT_MOTION,
  GHOST_FACES,
  SPEEDS,
  PRESENTED,
  holds,
} from '../../model/state.ts';
import { SAME_TIME, clampTime, formatTime, length, neighbourKey, timeScale } from '../../model/time-scale.ts';
import type { Range } from '../../model/time-scale.ts';
import { loopRange, withEnd } from '../../model/frames.ts';
import { including, windowOf, zoomed } from '../../model/time-window.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Store } from '../session/store.ts';

/** From what everybody knows to what is nearest to the method. */
const COMPARED: readonly Method[] = ['linear', 'cubic-vertex', 'geodesic', 'lri'];
const LOOPS: readonly LoopMode[] = ['bounce', 'loop', 'once'];

export type Commands = ReturnType<typeof createCommands>;

export interface CommandParts {
  store: Store;
  pool(): PosePool | null;
  range(): Range;
  /** The document that the open files started with. */
  initial(): Doc | null;
  /** Of the running sequence; null without one. */
  keyPace(): Promise<KeyPace | null>;
  /** The exact shape of a moment, drawn and copied. */
  exactShape(t: number): Promise<Float32Array>;
  fit(view: ViewName | null): void;
  /** The plot that the page of the guide speaks of, or null. */
  ownPlot(): Plot | null;
  /** The visitor has found out how to move through time. */
  onUse(): void;
  say(text: string): void;
}

export function createCommands(parts: CommandParts) {
  const { store, pool, range, initial, keyPace, exactShape, fit, ownPlot, onUse, say } = parts;
  const state = store.get;
  const times = (): number[] => state().doc.keys.map((key) => key.time);

  const seek = (t: number): void => {
    if (!Number.isFinite(t)) return;
    store.set({ time: clampTime(t, range()), play: { ...state().play, playing: false } });
    onUse();
  };
  /** Of the keys as they are; null where they have changed meanwhile. */
  const paceOfKeys = async (): Promise<KeyPace | null> => {
    const { keys } = state().doc;
    const pace = await keyPace();
    return state().doc.keys === keys && pace?.tension.length === keys.length ? pace : null;
  };
  const view = (change: Partial<View>): void => store.set({ view: { ...state().view, ...change } });
  const motion = (change: Partial<Motion>, merge?: string): void =>
    store.edit(undoName(change), (doc) => setMotion(doc, withBoundary(change, doc.motion)), merge);
  const encoding = (change: Partial<Encoding>): void => store.edit(undoName(change), (doc) => setEncoding(doc, change));

  const present = (what: Presented | null): void => view({ present: what });

  /** What was compared before there was a divider. */
  let beside: Method[] = [];

  const play = (change: Partial<Play>): void => store.set({ play: { ...state().play, ...change } });
  const between = (stretch: Range | null): void => play({ between: stretch && [stretch[0], stretch[1]] });
  const window = (part: Range | null): void => view({ window: part && [part[0], part[1]] });

  return {
    seek,
    /** To a time that was typed, which the timeline shows then. */
    goTo(t: number): void {
      const reached = clampTime(t, range());
      const scale = timeScale(range(), state().doc.keys.length);
      window(including(windowOf(state().view.window, scale), scale, reached));
      if (reached !== t) say(`The motion can be followed up to ${formatTime(reached, range())} s.`);
      seek(t);
    },
    view,
    between,
    window,
    motion,
    pins: (pins: Pin[], merge?: string): void => motion({ pins: pins.length > 0 ? pins : DEFAULT_MOTION.pins }, merge),
    endSpeed: (end: End, speed: number): void => motion({ [SPEED_NAME[end]]: speed }, SPEED_NAME[end]),
    encoding,
    toggleGhost: (): void =>
      store.edit('ghost mesh', (doc) =>
        setEncoding(doc, { ghostFaces: doc.encoding.ghostFaces > 0 ? 0 : GHOST_FACES }),
      ),
    resetMotion: (): void =>
      store.edit('motion defaults', (doc) => setMotion(doc, initial()?.motion ?? DEFAULT_MOTION)),
    resetShape: (): void =>
      store.edit('shape defaults', (doc) => setEncoding(doc, initial()?.encoding ?? DEFAULT_ENCODING)),
    compare: (methods: Method[]): void => view({ compare: methods }),
    /** Puts a divider between the motion and another one, or takes it away with what came with it. */
    toggleSplit(): void {
      const { compare, split } = state().view;
      if (split !== null) return view({ split: null, compare: beside });
      const { method } = state().doc.motion;
      beside = compare;
      const held = holds(state().doc.motion);
      const usual = held || method === 'linear' ? OWN_METHOD : 'linear';
      const other = compare.find((one) => one !== method || held) ?? usual;
      view({ split: 0.5, compare: [other] });
    },

    /** One other method after the other behind a divider, then none. */
    nextComparison(): void {
      const { compare, split } = state().view;
      const { motion: shown } = state().doc;
      const others = COMPARED.filter((method) => method !== shown.method || holds(shown));
      const next = others[others.indexOf(compare.at(-1) as Method) + 1];
      if (next) view({ compare: [next], split: split ?? 0.5 });
      else view({ compare: [], split: null });
    },
    present,
    togglePresent: (): void => present(state().view.present === null ? 'shape' : null),
    /** In the presentation: one plot after the other, that of the guide's page first, then the shape alone. */
    nextPlot(): void {
      const own = ownPlot();
      const order: Presented[] = PRESENTED.filter((one) => one !== own);
      if (own) order.splice(1, 0, own);
      const shown = order.indexOf(state().view.present ?? 'shape');
      present(order[(shown + 1) % order.length]!);
    },

    moveKey: (from: number, to: number): void => store.edit('order of keys', (doc) => moveKey(doc, from, to)),
    removeKey: (key: number): void => store.edit('remove a key', (doc) => removeKey(doc, key)),
    renameKey: (key: number, name: string): void => store.edit('rename a key', (doc) => renameKey(doc, key, name)),
    /** Who looks at the key goes with it. */
    retimeKey(key: number, time: number): void {
      const { doc, time: now, play: clock } = state();
      store.edit('time of a key', (before) => retimeKey(before, key, time), `time ${key}`);
      if (state().doc !== doc && doc.keys[key]?.time === now && !clock.playing) store.set({ time });
    },
    shaping: (key: number, name: ShapingNumber, value: number): void =>
      store.edit(PER_KEY[name].undo, (doc) => setShaping(doc, name, key, value), `${name} ${key}`),
    tightness: (tension: number): void =>
      store.edit(`${PER_KEY.tension.undo} of all keys`, (doc) => setTightness(doc, tension), 'tightness'),
    /** As much tension at each key as keeps its slope within the bound of `KeyPace`. */
    async autoTightness(): Promise<void> {
      const pace = await paceOfKeys();
      if (pace) {
        const tension = pace.tension.map((value) => Math.ceil(value * 1000) / 1000);
        if (state().doc.keys.every(({ shaping }, key) => shaping.tension === tension[key]))
          return say('The motion keeps within the bound at every key: there is nothing to change.');
        store.edit(`${PER_KEY.tension.undo} against overshoot`, (doc) => setTightness(doc, tension));
      }
    },
    async spaceKeys(spacing: Spacing): Promise<void> {
      const pace = await paceOfKeys();
      if (pace) store.edit('times of the keys', (doc) => spaceKeys(doc, pace.distance, SPACINGS[spacing]));
    },
    /** The shape on the screen and the stretch that plays stay what they are. */
    reverse(): void {
      const both = range()[0] + range()[1];
      const { between: part } = state().play;
      store.edit('direction of the motion', reverseMotion);
      store.set({ time: both - state().time });
      if (part) between([both - part[1], both - part[0]]);
    },
    turns: (key: number, added: KeyTurns): void => {
      const whose = added.component === undefined ? '' : ` of component ${added.component + 1}`;
      const merge = `turns ${added.component} ${key}`;
      store.edit(`${PER_KEY.turns.undo}${whose}`, (doc) => setTurns(doc, key, added), merge);
    },
    reference: (key: number): void => encoding({ referencePose: state().doc.keys[key]?.pose ?? null }),

    /** Takes the shape on the screen as a key at its own time. */
    async addCurrent(): Promise<void> {
      const into = pool();
      const t = state().time;
      if (!into || addReason(times(), t, range()) !== null) return;
      const positions = await exactShape(t);
      if (pool() !== into || positions.length === 0) return;
      const pose = into.add(`at ${formatTime(t, range())} s`, positions);
      store.edit('add a key', (doc) => addKey(doc, { pose, name: '', time: t }));
    },

    togglePlay(): void {
      const { playing } = state().play;
      play({ playing: !playing });
      if (playing) onUse();
    },
    loop: (loop: LoopMode): void => play({ loop }),
    nextLoop: (): void => play({ loop: LOOPS[(LOOPS.indexOf(state().play.loop) + 1) % LOOPS.length]! }),
    speed: (speed: number): void => play({ speed }),
    stepSpeed: (by: 1 | -1): void => {
      const next = SPEEDS[SPEEDS.indexOf(state().play.speed) + by];
      if (next) play({ speed: next });
    },
    fps: (fps: number | null): void => play({ fps }),
    /** Playing starts or ends at t; null = at the moment on the screen. */
    loopEnd: (end: 'start' | 'end', t: number | null): void => {
      const whole = range();
      const { fps, between: now } = state().play;
      const least = fps === null ? 0.001 * length(whole) : 1 / fps;
      between(withEnd(loopRange(now, whole), whole, end, t ?? state().time, least));
    },
    /** Zooms the timeline about the playhead, or about its middle where that is out of sight. */
    zoomTime: (factor: number): void => {
      const scale = timeScale(range(), state().doc.keys.length);
      const part = windowOf(state().view.window, scale);
      const t = state().time;
      window(zoomed(part, scale, factor, t >= part[0] && t <= part[1] ? t : (part[0] + part[1]) / 2));
    },
    jumpKey: (direction: 1 | -1): void => seek(neighbourKey(state().time, times(), direction, range())),

    nextMethod: (): void => {
      const { method } = state().doc.motion;
      motion({ method: METHODS[(METHODS.indexOf(method) + 1) % METHODS.length]! });
    },
    nextBoundary: (): void => {
      const { method, boundary } = state().doc.motion;
      const usable = BOUNDARIES.filter((one) => one !== 'hermite' || METHOD[method].curve === 'spline');
      motion({ boundary: usable[(usable.indexOf(boundary) + 1) % usable.length]! });
    },
    fit,
  };
}

/** A method that has no use for Hermite takes natural ends. */
function withBoundary(change: Partial<Motion>, { boundary }: Motion): Partial<Motion> {
  const straight = change.method !== undefined && METHOD[change.method].curve === 'polygon';
  return straight && boundary === 'hermite' ? { ...change, boundary: 'natural' } : change;
}

/** Why there can be no key at t, or null. */
export function addReason(keyTimes: readonly number[], t: number, range: readonly [number, number]): string | null {
  const taken = keyTimes.some((time) => Math.abs(time - t) <= 1000 * SAME_TIME * length(range));
  return taken ? 'There is a key at this time already. Move the slider first.' : null;
}
