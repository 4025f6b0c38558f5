/** Undo and redo after cancelled and refused edits, and while files are read. */
import { expect, it, vi } from 'vitest';
import type { Pin } from '../../web/engine/api/types.ts';
import { AppliedDocument } from '../../web/app/session/applied-document.ts';
import { createStore } from '../../web/app/session/store.ts';
import type { Opener } from '../../web/app/sources/opener.ts';
import { createUndo } from '../../web/app/sources/undo.ts';
import { renameKey, setEncoding, setMotion } from '../../web/model/edits.ts';
import { reorientedDoc } from '../../web/model/orientation.ts';
import type { Orientation } from '../../web/model/orientation.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const doc = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));
const storeOf = () => createStore({ ...EMPTY_STATE, doc });

it('after two cancelled edits, undo means the edit before them', () => {
  const store = storeOf();
  const applied = new AppliedDocument(store);
  store.edit('method', (before) => setMotion(before, { method: 'linear' }));
  applied.note(store.get());
  const made = store.get().doc;
  store.edit('patches', (before) => setEncoding(before, { patches: 500 }));
  store.edit('stretch', (before) => setEncoding(before, { stretch: 'log' }));
  applied.goBack();
  expect([store.get().doc, store.undoLabel(), store.redoLabel()]).toEqual([made, 'method', null]);
  store.undo();
  expect(store.get().doc).toBe(doc);
});

it('a refused edit leaves no step, and redo stays', () => {
  const store = storeOf();
  const applied = new AppliedDocument(store);
  store.edit('rename', (before) => renameKey(before, 0, 'x'));
  applied.note(store.get());
  store.undo();
  applied.note(store.get());
  store.edit('period', (before) => setMotion(before, { period: 0.1 }));
  applied.goBack();
  expect([store.get().doc, store.undoLabel(), store.redoLabel()]).toEqual([doc, null, 'rename']);
  store.redo();
  expect(store.get().doc.keys[0]!.name).toBe('x');
});

it('a drag whose first value is refused does not join an earlier step', () => {
  const store = storeOf();
  const applied = new AppliedDocument(store);
  const drag = (period: number): void => store.edit('period', (one) => setMotion(one, { period }), 'period');
  applied.note(store.get());
  drag(0.1);
  applied.goBack();
  drag(2);
  store.undo();
  expect(store.get().doc.motion.period).toBeNull();
});

/** Files whose reading ends on command, after one turn and with `edits` before it. */
function turned(...edits: string[]) {
  const store = storeOf();
  for (const name of edits) store.edit(name, (before) => renameKey(before, 0, name));
  const [before, after]: Orientation[] = [
    { up: 'y', unit: 1 },
    { up: 'z', unit: 1 },
  ];
  store.turned('turn', { before: before!, after: after! }, (doc) => doc);
  const read: ((done: boolean) => void)[] = [];
  const reorient = vi.fn(() => new Promise<boolean>((resolve) => read.push(resolve)));
  const opened = vi.fn(async () => true);
  const files = { reorient, back: opened, forth: opened, history: {} } as unknown as Opener;
  const undo = createUndo({ store, files, titleOf: () => '' });
  const end = async (done = true): Promise<void> => {
    read.shift()!(done);
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  return { store, undo, reorient, opened, end, before, after };
}

it('an edit made while the turn of the files is undone stays, and the turn leaves the history', async () => {
  const { store, undo, end, before, reorient } = turned();
  undo.undo();
  store.edit('ends', (one) => setMotion(one, { boundary: 'hermite' }));
  await end();
  expect(reorient).toHaveBeenCalledExactlyOnceWith(before, null);
  expect(store.get().doc.motion.boundary).toBe('hermite');
  expect(store.history()).toMatchObject({ past: [{ label: 'ends' }], future: [] });
});

it('an edit made while a turn of the files is undone can be undone as well, and pins turn back in both states', async () => {
  const { store, undo, end, after } = turned();
  const larger = { before: after!, after: { ...after!, unit: 10 } };
  const pins = (y: number): Pin[] => [{ vertex: 0, radius: 0.1, path: [{ time: 0, move: [0, y, 0] }] }];
  store.edit('pins', (one) => setMotion(one, { pins: pins(1) }));
  store.turned('unit', larger, (one) => reorientedDoc(one, larger.before, larger.after));
  undo.undo();
  store.edit('ends', (one) => setMotion(one, { boundary: 'hermite' }));
  await end();
  expect(store.get().doc.motion).toMatchObject({ boundary: 'hermite', pins: pins(1) });
  undo.undo();
  expect(store.get().doc.motion).toMatchObject({ boundary: doc.motion.boundary, pins: pins(1) });
});

it('an edit made while the turn of the files is redone stays, below the turn', async () => {
  const { store, undo, end, after, reorient } = turned();
  undo.undo();
  await end();
  undo.redo();
  store.edit('ends', (one) => setMotion(one, { boundary: 'hermite' }));
  await end();
  expect(reorient).toHaveBeenLastCalledWith(after, null);
  expect(store.get().doc.motion.boundary).toBe('hermite');
  expect(store.history()).toMatchObject({ past: [{ label: 'ends' }, { label: 'turn' }], future: [] });
});

it('further undos and redos wait until the files are read, unless that is cancelled', async () => {
  const { store, undo, end, opened } = turned('one', 'two');
  undo.undo();
  undo.undo();
  undo.redo();
  expect([store.undoLabel(), store.get().doc.keys[0]!.name]).toEqual(['turn', 'two']);
  await end();
  expect([store.undoLabel(), store.redoLabel(), store.get().doc.keys[0]!.name]).toEqual(['two', 'turn', 'two']);
  undo.redo();
  undo.undo();
  await end(false);
  expect(store.undoLabel()).toBe('two');
  for (const _ of [1, 2, 3]) undo.undo();
  expect([store.get().doc, opened.mock.calls.length]).toEqual([doc, 1]);
});

it('a cancelled edit does not bring an undone turn of the files back', async () => {
  const { store, undo, end } = turned();
  const applied = new AppliedDocument(store);
  applied.note(store.get());
  undo.undo();
  await end();
  store.edit('patches', (before) => setEncoding(before, { patches: 500 }));
  applied.goBack();
  expect([store.undoLabel(), store.redoLabel()]).toEqual([null, 'turn']);
});
