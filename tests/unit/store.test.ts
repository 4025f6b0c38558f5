import { describe, expect, it } from 'vitest';
import { createStore } from '../../web/app/session/store.ts';
import { renameKey, retimeKey } from '../../web/model/edits.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import type { AppState } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const start: AppState = {
  ...EMPTY_STATE,
  doc: docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1)),
};

describe('the store', () => {
  it('undoes and redoes edits in order', () => {
    const store = createStore(start);
    store.edit('rename', (doc) => renameKey(doc, 0, 'x'));
    store.edit('time', (doc) => retimeKey(doc, 1, 2));
    expect(store.undoLabel()).toBe('time');
    store.undo();
    expect(store.get().doc.keys[1]!.time).toBe(1);
    expect(store.redoLabel()).toBe('time');
    store.undo();
    expect(store.get().doc).toBe(start.doc);
    expect(store.undoLabel()).toBeNull();
    store.redo();
    store.redo();
    expect(store.get().doc.keys.map(({ name, time }) => [name, time])).toEqual([
      ['x', 0],
      ['b', 2],
    ]);
  });

  it('undoes a drag as a whole, but not two drags with a pause between', () => {
    let now = 0;
    const store = createStore(start, () => now);
    for (const time of [1.1, 1.2, 1.3]) {
      now += 100;
      store.edit('time', (doc) => retimeKey(doc, 1, time), 'time 1');
    }
    now += 5000;
    store.edit('time', (doc) => retimeKey(doc, 1, 1.8), 'time 1');
    store.undo();
    expect(store.get().doc.keys[1]!.time).toBe(1.3);
    store.undo();
    expect(store.get().doc.keys[1]!.time).toBe(1);
  });

  it('undoes a slow drag as a whole as well, and never joins two drags', () => {
    let now = 0;
    const store = createStore(start, () => now);
    const drag = (times: number[]): void => {
      store.hold(true);
      for (const time of times) {
        now += 5000;
        store.edit('time', (doc) => retimeKey(doc, 1, time), 'time 1');
      }
      store.hold(false);
    };
    drag([1.1, 1.2, 1.3]);
    drag([1.4, 1.5]);
    store.undo();
    expect(store.get().doc.keys[1]!.time).toBe(1.3);
    store.undo();
    expect(store.get().doc.keys[1]!.time).toBe(1);
  });

  it('discards redo steps after another edit', () => {
    const store = createStore(start);
    store.edit('rename', (doc) => renameKey(doc, 0, 'x'));
    store.undo();
    store.edit('rename', (doc) => renameKey(doc, 0, 'y'));
    expect(store.redoLabel()).toBeNull();
  });

  it('neither publishes nor records an edit without effect', () => {
    const store = createStore(start);
    let calls = 0;
    store.subscribe(() => {
      calls += 1;
    });
    store.edit('rename', (doc) => renameKey(doc, 0, 'a'));
    expect(calls).toBe(0);
    expect(store.undoLabel()).toBeNull();
  });

  it('excludes time and view from undo', () => {
    const store = createStore(start);
    store.edit('rename', (doc) => renameKey(doc, 0, 'x'));
    store.set({ time: 0.7 });
    store.undo();
    expect(store.get().time).toBe(0.7);
  });

  it('starts a new history with a new import', () => {
    const store = createStore(start);
    store.edit('rename', (doc) => renameKey(doc, 0, 'x'));
    store.reset(start);
    expect(store.undoLabel()).toBeNull();
  });
});
