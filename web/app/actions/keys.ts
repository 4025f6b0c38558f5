/** Commands on the keys. */
import { MAX_TIME } from '../../engine/api/option-table.ts';
import type { KeySpacing } from '../../engine/api/types.ts';
import {
  addKey,
  isTaken,
  moveKey,
  removeKey,
  renameKey,
  retimeKey,
  setShaping,
  setTightness,
  setTiming,
  setTurns,
  spaceKeys,
} from '../../model/edits.ts';
import { SPACINGS } from '../../model/key-spacing.ts';
import type { Spacing } from '../../model/key-spacing.ts';
import { undoWords } from '../../model/option-words.ts';
import type { KeyTurns, ShapingNumber } from '../../model/shaping.ts';
import type { Timing } from '../../model/timing-presets.ts';
import type { KeyRef } from '../../model/state.ts';
import { formatTime } from '../../model/time-scale.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { Actions } from './action.ts';
import type { Context } from './context.ts';
import { changeEncoding } from './shape.ts';

export const KEYS = {
  addCurrent: {
    keys: ['k'],
    shown: 'K',
    does: 'Add the current shape as a key',
    edits: true,
    run: addCurrent,
  },
  pickKeys: { run: ({ overlays }) => overlays.pickKeys() },
  addKeys: { run: ({ files }, picked: Promise<PickedFile[]>) => files.addKeys(picked) },
  moveKey: {
    run: ({ session: { store } }, from: number, to: number) =>
      store.edit('order of keys', (doc) => moveKey(doc, from, to)),
  },
  removeKey: {
    run: ({ session: { store } }, key: number) => store.edit('remove a key', (doc) => removeKey(doc, key)),
  },
  renameKey: {
    run: ({ session: { store } }, key: number, name: string) =>
      store.edit('rename a key', (doc) => renameKey(doc, key, name)),
  },
  /** If the screen shows this key, the playhead moves with it. */
  retimeKey: {
    run({ session: { store }, feedback }, key: number, time: number) {
      const { doc, time: now, play } = store.get();
      store.edit('time of a key', (before) => retimeKey(before, key, time), `time ${key}`);
      const moved = store.get().doc !== doc;
      if (moved && doc.keys[key]?.time === now && !play.playing) store.set({ time });
      const other = doc.keys.findIndex((one, at) => at !== key && one.time === time);
      if (other >= 0) feedback.say(`Key ${other + 1} is already at this time.`);
      else if (Math.abs(time) > MAX_TIME) feedback.say(`Key times can be at most ${MAX_TIME.toLocaleString('en')} s.`);
    },
  },
  shaping: {
    run: ({ session: { store } }, key: number, name: ShapingNumber, value: number) =>
      store.edit(undoWords(name), (doc) => setShaping(doc, name, key, value), `${name} ${key}`),
  },
  timing: {
    run: ({ session: { store } }, key: number, timing: Timing) =>
      store.edit('timing', (doc) => setTiming(doc, key, timing)),
  },
  tightness: {
    run: ({ session: { store } }, tension: number) =>
      store.edit(`${undoWords('tension')} of all keys`, (doc) => setTightness(doc, tension), 'tightness'),
  },
  autoTightness: { run: autoTightness },
  spaceKeys: {
    async run(context, spacing: Spacing) {
      const keySpacing = await spacingOfKeys(context);
      if (!keySpacing) return;
      context.session.store.edit('times of the keys', (doc) => spaceKeys(doc, keySpacing.distance, SPACINGS[spacing]));
    },
  },
  turns: {
    run({ session: { store } }, key: number, added: KeyTurns) {
      const whose = added.component === undefined ? '' : ` of component ${added.component + 1}`;
      const merge = `turns ${added.component} ${key}`;
      store.edit(`${undoWords('turns')}${whose}`, (doc) => setTurns(doc, key, added), merge);
    },
  },
  reference: {
    run: (context, key: number) =>
      changeEncoding(context, { referencePose: context.session.store.get().doc.keys[key]?.pose ?? null }),
  },
} satisfies Actions;

/** The spacing of the keys; null if the keys changed while it was computed, or if nothing is open. */
async function spacingOfKeys({ session: { store, sequence } }: Context): Promise<KeySpacing | null> {
  const { keys } = store.get().doc;
  const keySpacing = (await sequence()?.keySpacing()) ?? null;
  return store.get().doc.keys === keys && keySpacing?.tension.length === keys.length ? keySpacing : null;
}

/** Gives each key just enough tension to keep its slope within the bound of `KeySpacing`. */
async function autoTightness(context: Context): Promise<void> {
  const keySpacing = await spacingOfKeys(context);
  if (!keySpacing) return;
  const { store } = context.session;
  const tension = keySpacing.tension.map((value) => Math.ceil(value * 1000) / 1000);
  if (store.get().doc.keys.every(({ shaping }, key) => shaping.tension === tension[key]))
    return context.feedback.say('No key needs a different tension to limit overshoot. Nothing was changed.');
  store.edit(`${undoWords('tension')} against overshoot`, (doc) => setTightness(doc, tension));
}

/** Adds the shown shape as a key at the current time. */
async function addCurrent({ session, display }: Context): Promise<void> {
  const { store, workspace, range } = session;
  const { pool } = workspace;
  const { time: t, doc } = store.get();
  if (!pool || addReason(doc.keys, t) !== null) return;
  await display.playback.frameLoop.request(t);
  const positions = display.scene.viewer.positions(0);
  if (workspace.pool !== pool || positions.length === 0) return;
  const pose = pool.add(`at ${formatTime(t, range())} s`, positions);
  store.edit('add a key', (before) => addKey(before, { pose, name: '', time: t }));
}

/** The reason why no key can be added at t, or null. */
export function addReason(keys: readonly KeyRef[], t: number): string | null {
  return isTaken(keys, t) ? 'There is already a key at this time. Move the slider first.' : null;
}
