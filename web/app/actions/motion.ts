/** Commands on the motion through the keys. */
import { METHODS, hasEnds } from '../../engine/api/methods.ts';
import type { Pin } from '../../engine/api/types.ts';
import { reverseMotion, setMotion } from '../../model/edits.ts';
import { undoName } from '../../model/option-words.ts';
import type { End } from '../../model/speeds.ts';
import { DEFAULT_SPEED, SPEED_NAME, TANGENT_NAME } from '../../model/speeds.ts';
import { BOUNDARIES, DEFAULT_MOTION } from '../../model/state.ts';
import type { Doc, Motion } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';
import { between, play } from './time.ts';

export const MOTION = {
  nextBoundary: {
    keys: ['b'],
    shown: 'B',
    does: 'Ends: free, ease or loop',
    edits: true,
    run(context) {
      const { method, boundary } = context.session.store.get().doc.motion;
      const usable = BOUNDARIES.filter((one) => hasEnds(method, one));
      changeMotion(context, { boundary: usable[(usable.indexOf(boundary) + 1) % usable.length]! });
    },
  },
  nextMethod: {
    keys: ['m'],
    shown: 'M',
    does: 'Next method',
    edits: true,
    run(context) {
      const { method } = context.session.store.get().doc.motion;
      changeMotion(context, { method: METHODS[(METHODS.indexOf(method) + 1) % METHODS.length]! });
    },
  },
  motion: { run: changeMotion },
  resetMotion: {
    run: ({ session: { store }, viewState }) =>
      store.edit('motion defaults', (doc) => setMotion(doc, viewState.opened.initial?.motion ?? DEFAULT_MOTION)),
  },
  endSpeed: {
    run: (context, end: End, speed: number) => changeMotion(context, { [SPEED_NAME[end]]: speed }, SPEED_NAME[end]),
  },
  pickTangent: { run: ({ overlays }, end: End) => overlays.pickTangent(end) },
  takeTangent: {
    run: ({ files }, picked: PickedFile[] | Promise<PickedFile[]>, end: End) => files.takeTangent(picked, end),
  },
  pins: {
    run: (context, pins: Pin[], merge?: string) =>
      changeMotion(context, { pins: pins.length > 0 ? pins : DEFAULT_MOTION.pins }, merge),
  },
  /** The next click on the shape pins that vertex. */
  placing: {
    run(context, placing: boolean) {
      // A playing shape is hard to click.
      if (placing && context.session.store.get().play.playing) play(context, { playing: false });
      context.viewState.changeOpened({ placing });
    },
  },
  /** The shown shape and the playing range stay the same. */
  reverse: {
    run(context) {
      const { store, range } = context.session;
      const both = range()[0] + range()[1];
      const { between: part } = store.get().play;
      store.edit('direction of the motion', reverseMotion);
      store.set({ time: both - store.get().time });
      if (part) between(context, [both - part[1], both - part[0]]);
    },
  },
} satisfies Actions;

function changeMotion({ session: { store } }: Context, change: Partial<Motion>, merge?: string): void {
  store.edit(undoName(change), (doc) => setMotion(doc, eased(withBoundary(change, doc.motion), doc)), merge);
}

/** Turns on easing at the ends, unless they already have a chosen speed or tangent pose. */
function eased(change: Partial<Motion>, { motion, encoding }: Doc): Partial<Motion> {
  const begins = change.boundary === 'hermite' && motion.boundary !== 'hermite';
  const chosen = (['start', 'end'] as const).some(
    (end) => motion[SPEED_NAME[end]] !== DEFAULT_SPEED || encoding[TANGENT_NAME[end]] !== null,
  );
  return begins && !chosen ? { ...change, startSpeed: 0, endSpeed: 0 } : change;
}

/** Uses natural ends for a method that does not have the chosen ends. */
function withBoundary(change: Partial<Motion>, { boundary }: Motion): Partial<Motion> {
  const fits = change.method === undefined || hasEnds(change.method, boundary);
  return fits ? change : { ...change, boundary: 'natural' };
}
