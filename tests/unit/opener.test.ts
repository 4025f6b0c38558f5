/** The common path of all openings, with a workspace that reads nothing. */
import { expect, it, vi } from 'vitest';
import { PosePool } from '../../web/app/session/pose-pool.ts';
import { createStore } from '../../web/app/session/store.ts';
import type { Input, LoadSteps, Start, Workspace } from '../../web/app/session/workspace.ts';
import type { Sample } from '../../web/app/sources/samples.ts';
import { Opener } from '../../web/app/sources/opener.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';
import type { Engine } from '../../web/engine/api/api.ts';
import { EngineError } from '../../web/engine/api/errors.ts';
import { KeyArrays } from '../../web/engine/caller/keyframes.ts';
import type { KeyData } from '../../web/engine/wire/protocol.ts';
import type { ImportOptions, InputFile, PathKey, Warning } from '../../web/engine/api/types.ts';
import { retimeKey, setMotion } from '../../web/model/edits.ts';
import type { Doc } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const sampleOf = (id: string): Sample => ({
  ...{ id, title: id, description: '', files: [`${id}.glb`], made: false, names: null },
  ...{ times: null, boundary: 'natural', hold: 'off' },
});
const filesOf = (name: string): InputFile[] => [{ name, bytes: new Uint8Array(1) }];
const read = docOfKeys(keyRef(0, 'a', 0), keyRef(1, 'b', 1));

/** `refuse`: the engine's error for a document. */
function openerOf({ warnings = [] as Warning[], refuse = (_: Doc): void => undefined } = {}) {
  const info = { names: ['a', 'b'], times: [0, 1], offset: [0, 0, 0], faces: new Uint32Array(), warnings };
  const found = { animation: -1, animations: [], project: null, speed: null, report: { components: 1, vertices: 1 } };
  const workspace = {
    input: [] as InputFile[],
    options: {} as ImportOptions,
    pool: null as PosePool | null,
    range: [0, 1],
    async open<S extends Start>(input: Input, given: ImportOptions, steps: LoadSteps<S>) {
      const files = typeof input === 'function' ? await input(() => undefined, new AbortController().signal) : input;
      const positions = [new Float32Array(3), new Float32Array(3)];
      const pool = new PosePool(new KeyArrays({ info: { ...info, ...found }, positions } as unknown as KeyData));
      const options = steps.otherwise(pool.keys.info) ?? given;
      const opening = { ...steps.start(read, pool), info: pool.keys.info, pool };
      refuse(opening.doc);
      if (workspace.pool) steps.leave();
      Object.assign(workspace, { input: files, options, pool });
      return opening;
    },
  };
  const store = createStore(EMPTY_STATE);
  const events = { say: vi.fn(), onStart: vi.fn(), onOpened: vi.fn(), onRead: vi.fn() };
  const onError = vi.fn();
  const opener = new Opener({
    ...{
      engine: { warmFiles: () => undefined } as Engine,
      store,
      workspace: workspace as unknown as Workspace,
      ...events,
      onError,
    },
    ...{ onWorking: () => undefined, reducedMotion: () => true, samples: () => ['a', 'b'].map(sampleOf) },
  });
  const sample = (id: string): Promise<boolean> => opener.sample(id, null, Promise.resolve(filesOf(`${id}.obj`)));
  return { opener, store, workspace, sample, onError, ...events };
}
const idOf = ({ source }: { source: object }): string | undefined => (source as { id?: string }).id;

it('goes back to earlier content, with its edits, and forth again', async () => {
  const { opener, store, sample } = openerOf();
  await sample('a');
  store.edit('time', (doc) => retimeKey(doc, 1, 2));
  await sample('b');
  expect([idOf(store.get()), store.undoLabel()]).toEqual(['b', null]);
  expect(await opener.back()).toBe(true);
  expect([idOf(store.get()), store.get().doc.keys[1]!.time, store.undoLabel()]).toEqual(['a', 2, 'time']);
  await opener.forth();
  expect(idOf(store.get())).toBe('b');
  expect(await opener.forth()).toBe(false);
  await opener.again(opener.history.before, null);
  expect([idOf(store.get()), opener.history.all.length]).toEqual(['a', 1]);
});

it('a sample is not opened if another is requested while it loads', async () => {
  const { opener, store, sample, onError } = openerOf();
  const late = opener.sample('a', null, new Promise((_, fail) => setTimeout(fail, 5)));
  await sample('b');
  expect([await late, idOf(store.get()), opener.busy]).toEqual([false, 'b', false]);
  expect(onError).not.toHaveBeenCalled();
});

it('options of a link that the engine refuses are ignored and reported', async () => {
  const error = new EngineError('period-too-short', 'No.');
  const refuse = ({ keys }: Doc): void => {
    if (keys[1]!.time === 3) throw error;
  };
  const { opener, store, onError } = openerOf({ refuse });
  const link = readPermalink('sample=a&keys=0@0,1@3');
  expect(await opener.sample('a', link, Promise.resolve(filesOf('a.glb')))).toBe(true);
  expect(store.get().doc.keys[1]!.time).toBe(1);
  expect(onError).toHaveBeenCalledWith(error);
  expect(await opener.sample('c')).toBe(false);
});

it('only picked files are rotated upright', async () => {
  const warnings = [{ code: 'z-up', message: 'lies' }] as Warning[];
  const { opener, workspace, onOpened } = openerOf({ warnings });
  await opener.run([{ name: 'a.obj', file: new File(['v'], 'a.obj') }], (files) => opener.open(files));
  expect(workspace.options).toEqual({ up: 'z' });
  expect(onOpened.mock.lastCall![0]).toMatchObject({ stoodUp: true, picked: true, orientation: { up: 'z', unit: 1 } });
  await opener.takeObjects([]);
  expect(onOpened.mock.lastCall![0]).toMatchObject({ stoodUp: false, picked: false, stays: false });
  expect(workspace.options.up).toBe('z');
});

it('a rotation is a step of the history, unless it is automatic', async () => {
  const { opener, store, sample, onRead } = openerOf();
  await sample('a');
  store.edit('time', (doc) => retimeKey(doc, 1, 2));
  await opener.reorient({ up: 'z', unit: 1 }, null);
  expect(store.undoLabel()).toBe('time');
  await opener.reorient({ up: 'y', unit: 1 });
  const { label, turn } = store.history().past.at(-1)!;
  expect([label, turn?.before]).toEqual(['lay the shape down', { up: 'z', unit: 1 }]);
  expect([store.get().doc.keys[1]!.time, onRead.mock.calls.length]).toEqual([2, 2]);
});

it('a rotation turns the paths of pins, and undo and redo restore them exactly', async () => {
  const { opener, store, sample } = openerOf();
  await sample('a');
  const path: PathKey[] = [{ time: 0, move: [0.1, 1, 2] }];
  store.edit('pins', (doc) => setMotion(doc, { pins: [{ vertex: 0, radius: 0.1, path }] }));
  const move = () => store.get().doc.motion.pins[0]!.path![0]!.move;
  await opener.reorient({ up: 'z', unit: 0.1 });
  const turned = move();
  expect(turned).toEqual([expect.closeTo(0.01, 12), expect.closeTo(0.2, 12), expect.closeTo(-0.1, 12)]);
  for (const moves of [path[0]!.move, turned]) {
    const back =
      moves === turned ? store.history().future.at(-1)!.turn!.after : store.history().past.at(-1)!.turn!.before;
    await opener.reorient(back, null);
    if (moves === turned) store.redo();
    else store.undo();
    expect(move()).toEqual(moves);
  }
});
