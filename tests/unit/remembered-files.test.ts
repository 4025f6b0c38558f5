/** When the user's files are stored between visits, tested with storage in memory. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { Changing, StoredProject } from '../../web/app/storage/project-shelf.ts';
import { RememberedFiles } from '../../web/app/storage/remembered-files.ts';
import { createStore } from '../../web/app/session/store.ts';
import type { Workspace } from '../../web/app/session/workspace.ts';
import type { ImportOptions } from '../../web/engine/api/types.ts';
import type { AppState } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

const shelf = new Map<string, { remembered: StoredProject; version: number; opening: boolean }>();
let projects = 0;
let versions = -9;
const storage = {
  newProjectId: () => `other${++projects > 1 ? projects : ''}`,
  async keepProject(id: string, remembered: StoredProject, known: number | null) {
    const project = shelf.get(id);
    if (project && project.version !== known) return null;
    versions += 10;
    const version = project ? project.version + 1 : versions;
    shelf.set(id, { remembered, version, opening: false });
    return version;
  },
  async updateProject(id: string, version: number, changing: Changing) {
    const project = shelf.get(id);
    if (project?.version !== version) return null;
    Object.assign(project, { version: version + 1, remembered: { ...project.remembered, ...changing } });
    return version + 1;
  },
  async markOpening(id: string, opening: boolean) {
    Object.assign(shelf.get(id)!, { opening });
  },
  forgetProject: async (id: string) => void shelf.delete(id),
  readShelf: async () => ({
    projects: [...shelf].map(([id, { opening }]) => ({ id, names: [id], changed: 0, opening })),
    setAside: 0,
  }),
  readProject: async (id: string) => shelf.get(id) ?? null,
};

const settings = new Map<string, string>();
const ofTab = new Map<string, string>();
const settingsIn = (words: Map<string, string>) => ({
  getItem: (key: string) => words.get(key) ?? null,
  setItem: (key: string, value: string) => words.set(key, value),
  removeItem: (key: string) => words.delete(key),
});
const said: string[] = [];

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('BroadcastChannel', undefined);
  vi.stubGlobal('window', Object.assign(new EventTarget(), { setTimeout, clearTimeout }));
  vi.stubGlobal('localStorage', settingsIn(settings));
  vi.stubGlobal('sessionStorage', settingsIn(ofTab));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
  for (const kept of [shelf, settings, ofTab]) kept.clear();
  [projects, versions] = [0, -9];
  said.length = 0;
});

/** A visit with open files. After `close`, it stores nothing. */
function visit(id = 'mine', onDeleted?: (listener: () => void) => void) {
  const own: AppState = { ...EMPTY_STATE, source: { kind: 'files', names: [id] }, project: id, time: 0 };
  const store = createStore(own);
  const input = [{ name: 'mine.glb', bytes: new Uint8Array(1) }];
  const positions = (): Float32Array => new Float32Array(3);
  const keys = { info: { names: [], offset: [0, 0, 0] }, positions };
  const pool = { count: 2, imported: 2, keys };
  const workspace = { options: {} as ImportOptions, pool, input, aheadOfState: false };
  let closed = false;
  const ofVisit = Object.fromEntries(
    Object.keys(storage).map((name) => [
      name,
      (...args: never[]) =>
        closed
          ? new Promise(() => undefined)
          : (storage[name as keyof typeof storage] as (...all: never[]) => unknown)(...args),
    ]),
  ) as unknown as typeof storage;
  const remembered = new RememberedFiles({
    store,
    workspace: workspace as unknown as Workspace,
    say: (text) => void said.push(text),
    onError: (error) => void said.push(String(error)),
    storage: { ...ofVisit, newProjectId: storage.newProjectId, ...(onDeleted && { onDeleted }) },
    onChange: () => undefined,
  });
  store.subscribe(() => remembered.follow());
  /** Edits, which `seconds` later are stored. */
  const edit = async (time: number, seconds = 1): Promise<void> => {
    store.set({ time });
    await vi.advanceTimersByTimeAsync(1000 * seconds);
  };
  /** Closes the page before anything else is stored. */
  const close = (): void => {
    closed = true;
    remembered.flush();
  };
  return { store, remembered, workspace, edit, close };
}
const timeOf = (id: string): number | undefined => shelf.get(id)?.remembered.state.time;
const times = () => [...shelf.values()].map(({ remembered: { state } }) => state.time).sort();

/** Opens stored files again. */
async function opened(id = 'mine') {
  const tab = visit(id);
  await tab.remembered.reopen(id, async ({ state, options, files }) => {
    Object.assign(tab.workspace, { options, input: files });
    tab.store.reset(state);
    return true;
  });
  return tab;
}

/** Two or more tabs with the same stored files. */
async function tabs(count: number) {
  const first = visit();
  await first.edit(0);
  const others = [];
  for (let tab = 1; tab < count; tab += 1) others.push(await opened());
  await vi.advanceTimersByTimeAsync(1000);
  return [first, ...others];
}

it('stores open content after a while, then changes, with one message', async () => {
  const { store, remembered } = visit();
  remembered.follow();
  expect([shelf.size, remembered.unsaved]).toEqual([0, false]);
  await vi.advanceTimersByTimeAsync(500);
  expect(shelf.get('mine')).toMatchObject({ version: 1, remembered: { files: [{ name: 'mine.glb' }] } });
  store.set({ time: 0.5 });
  await vi.advanceTimersByTimeAsync(500);
  expect([shelf.get('mine')?.version, timeOf('mine')]).toEqual([2, 0.5]);
  await vi.advanceTimersByTimeAsync(10_000);
  expect(said).toEqual([expect.stringContaining('These files are remembered')]);
});

it('keeps both versions if another tab has written since', async () => {
  const { store, remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  shelf.get('mine')!.version = 7;
  store.set({ time: 0.5 });
  await vi.advanceTimersByTimeAsync(2000);
  expect([timeOf('mine'), timeOf('other'), store.get().project]).toEqual([0, 0.5, 'other']);
});

it('the next visit opens the state stored when the page was closed', async () => {
  const { store, remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  const before = { ...shelf.get('mine')! };
  store.set({ time: 0.75 });
  remembered.flush();
  await vi.advanceTimersByTimeAsync(500);
  expect([timeOf('mine'), settings.size]).toEqual([0.75, 0]);
  // The page closes before the state is written.
  store.set({ time: 0.25 });
  remembered.flush();
  const noted = [...settings];
  await vi.advanceTimersByTimeAsync(500);
  shelf.set('mine', { ...before, version: 2 });
  for (const [key, value] of noted) settings.set(key, value);
  const open = vi.fn(async (_: StoredProject) => true);
  expect(await visit().remembered.reopen('mine', open)).toBe(true);
  expect(open.mock.calls[0]![0].state.time).toBe(0.25);
  expect(shelf.get('mine')?.opening).toBe(false);
});

it('the next visit also opens a state whose writing had begun when the page was closed', async () => {
  const { store, remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  vi.spyOn(storage, 'updateProject').mockReturnValueOnce(new Promise(() => undefined));
  store.set({ time: 0.25 });
  await vi.advanceTimersByTimeAsync(500);
  remembered.flush();
  expect(timeOf('mine')).toBe(0);
  const open = vi.fn(async (_: StoredProject) => true);
  await visit().remembered.reopen('mine', open);
  expect(open.mock.calls[0]![0].state.time).toBe(0.25);
});

it('a reloaded tab opens its own files first, and a new tab the last changed ones', async () => {
  shelf.set('of another tab', { remembered: {} as StoredProject, version: 1, opening: false });
  const { remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  const first = async (): Promise<string | undefined> => (await visit().remembered.recall())[0]?.id;
  expect(await first()).toBe('mine');
  ofTab.clear();
  expect(await first()).toBe('of another tab');
});

it('a project that does not open stays marked; a replaced one does not', async () => {
  const { remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  for (const outcome of [false, null]) {
    expect(await remembered.reopen('mine', async () => outcome)).toBe(false);
    expect(shelf.get('mine')?.opening).toBe(outcome === false);
  }
});

it('deleted content is not stored again until the user allows it', async () => {
  const { store, remembered } = visit();
  remembered.follow();
  await vi.advanceTimersByTimeAsync(500);
  await remembered.toggle();
  store.set({ time: 0.5 });
  await vi.advanceTimersByTimeAsync(500);
  expect(shelf.size).toBe(0);
  await remembered.toggle();
  expect(timeOf('mine')).toBe(0.5);
});

const BOTH = 'Another tab also changed these files. Both versions were kept.';

it.each(['hidden', 'closed'])(
  'a note does not replace what another tab has stored, if its tab is then %s',
  async (how) => {
    const [one, two] = await tabs(2);
    await two!.edit(0.9);
    one!.store.set({ time: 0.1 });
    if (how === 'closed') one!.close();
    else one!.remembered.flush();
    await vi.advanceTimersByTimeAsync(5000);
    expect((await opened()).store.get().time).toBe(0.9);
    expect([times(), said.at(-1)]).toEqual([[0.1, 0.9], BOTH]);
    await opened();
    expect([shelf.size, settings.size]).toEqual([2, 0]);
  },
);

it('a tab that is reloaded while it stores its own version opens that version', async () => {
  const [one, two] = await tabs(2);
  await two!.edit(0.9);
  vi.spyOn(storage, 'keepProject').mockReturnValueOnce(new Promise(() => undefined));
  await one!.edit(0.1);
  expect(ofTab.get('shapespline.project-of-tab')).toBe('other');
});

it.each(['after', 'before'])('a version is kept once if the page closes just %s it is stored', async (when) => {
  const [one, two] = await tabs(2);
  await two!.edit(0.9);
  const keep = storage.keepProject;
  vi.spyOn(storage, 'keepProject').mockImplementationOnce(async (...args) => {
    if (when === 'after') await keep(...args);
    one!.close();
    return new Promise(() => undefined);
  });
  one!.store.set({ time: 0.1 });
  one!.remembered.flush();
  await vi.advanceTimersByTimeAsync(1000);
  await opened();
  await vi.advanceTimersByTimeAsync(1000);
  expect(times()).toEqual([0.1, 0.9]);
});

it('all tabs can close at the same time', async () => {
  const [one, two, three] = await tabs(3);
  const elsewhere = visit('yours');
  await elsewhere.edit(0);
  for (const [index, tab] of [one!, two!, three!, elsewhere].entries()) {
    tab.store.set({ time: 0.1 * (index + 1) });
    tab.close();
  }
  expect((await opened('yours')).store.get().time).toBe(0.4);
  await opened();
  await vi.advanceTimersByTimeAsync(1000);
  expect(times()).toEqual([0.1, 0.2, 0.30000000000000004, 0.4]);
  expect(settings.size).toBe(0);
});

it('a note made during a write applies to that write only', async () => {
  for (const [stored, expected] of [
    [0.2, 0.3],
    [0.9, 0.9],
  ]) {
    shelf.clear();
    const one = visit();
    await one.edit(0);
    const updated = vi.spyOn(storage, 'updateProject').mockReturnValueOnce(new Promise(() => undefined));
    await one.edit(0.2);
    one.store.set({ time: 0.3 });
    one.close();
    updated.mockRestore();
    // The write ended after the page was closed, or another tab wrote.
    const { remembered, version } = shelf.get('mine')!;
    await storage.updateProject('mine', version, { ...remembered, state: { ...remembered.state, time: stored! } });
    expect((await opened()).store.get().time).toBe(expected);
  }
});

it('tabs that store the same content do not part', async () => {
  const one = visit();
  await one.edit(0);
  one.store.set({ time: 0.5 });
  one.close();
  const [two, three] = [await opened(), await opened()];
  await vi.advanceTimersByTimeAsync(5000);
  await two.edit(0.6);
  expect([times(), three.store.get().project, said]).toEqual([[0.6], 'mine', [expect.stringContaining('remembered')]]);
});

it.each([0.4, 1])('an edit %s s before other files are opened is stored, also during a slow write', async (seconds) => {
  const keep = storage.keepProject;
  vi.spyOn(storage, 'keepProject').mockImplementation(async (...args) => {
    await new Promise((resolve) => setTimeout(resolve, 2000));
    return keep(...args);
  });
  const { store, workspace, edit, remembered } = visit();
  await edit(0, 0.6);
  await edit(0.5, seconds);
  workspace.input = [{ name: 'b.glb', bytes: new Uint8Array(1) }];
  store.reset({ ...store.get(), project: 'yours', time: 0 });
  await vi.advanceTimersByTimeAsync(9000);
  expect([timeOf('mine'), timeOf('yours'), ofTab.get('shapespline.project-of-tab')]).toEqual([0.5, 0, 'yours']);
  await edit(0.7);
  store.set({ project: null });
  await vi.advanceTimersByTimeAsync(9000);
  expect([times(), remembered.unsaved]).toEqual([[0.5, 0.7], false]);
});

it('the state of one project is never stored with the files of the next, which are open first', async () => {
  const { store, workspace, edit, remembered } = visit();
  await edit(0);
  store.set({ time: 0.5 });
  const { input } = workspace;
  Object.assign(workspace, { input: [{ name: 'b.glb', bytes: new Uint8Array(1) }], aheadOfState: true });
  // The camera is fitted to the next files.
  store.set({ view: { ...store.get().view } });
  remembered.flush();
  workspace.aheadOfState = false;
  store.reset({ ...store.get(), project: 'yours' });
  await vi.advanceTimersByTimeAsync(2000);
  expect([timeOf('mine'), shelf.get('mine')!.remembered.files]).toEqual([0.5, input]);
  expect(shelf.get('yours')!.remembered.files).toEqual(workspace.input);
});

it('an edit just before a project is opened from the list is there', async () => {
  const { store, remembered, edit } = visit();
  await edit(0);
  store.set({ time: 0.5 });
  const open = vi.fn(async (_: StoredProject) => true);
  const opening = remembered.reopen('mine', open);
  await vi.advanceTimersByTimeAsync(10);
  await opening;
  expect(open.mock.calls[0]![0].state.time).toBe(0.5);
});

it('the last edit of files that are no longer open does not replace that of another tab', async () => {
  const [one, two] = await tabs(2);
  await two!.edit(0.9);
  one!.store.set({ time: 0.1 });
  one!.store.set({ project: null });
  await vi.advanceTimersByTimeAsync(5000);
  expect([times(), one!.store.get().project, said.at(-1)]).toEqual([[0.1, 0.9], null, BOTH]);
});

it('files that were removed to make room are stored again under their id, unless the user forbids it', async () => {
  const [one, two] = await tabs(2);
  shelf.delete('mine');
  await one!.edit(0.1);
  await two!.edit(0.2);
  expect([[...shelf.keys()], times(), said.at(-1)]).toEqual([['mine', 'other'], [0.1, 0.2], BOTH]);
  shelf.clear();
  settings.set('shapespline.keep-no-files', 'yes');
  await one!.edit(0.3);
  expect(shelf.size).toBe(0);
});

it('other import options are stored, also if the page closes at once', async () => {
  const { store, workspace, edit, close } = visit();
  await edit(0);
  workspace.options = { up: 'z' };
  store.set({});
  await vi.advanceTimersByTimeAsync(1000);
  expect(shelf.get('mine')!.remembered.options).toEqual({ up: 'z' });
  workspace.options = { up: 'y' };
  store.set({});
  close();
  expect((await opened()).workspace.options).toEqual({ up: 'y' });
});

it('after a failure, the project is stored again on request, but not over the version of another tab', async () => {
  const [one, two] = await tabs(2);
  vi.spyOn(storage, 'updateProject').mockRejectedValueOnce(new Error('full'));
  await one!.edit(0.1);
  expect(said.at(-1)).toContain('could not be stored');
  await two!.edit(0.9);
  await one!.remembered.toggle();
  expect([times(), said.includes(BOTH)]).toEqual([[0.1, 0.9], true]);
});

it('the open files are stored again if another tab deletes everything', async () => {
  let deleted = (): void => undefined;
  const { edit } = visit('mine', (listener) => (deleted = listener));
  await edit(0.5);
  shelf.clear();
  deleted();
  await vi.advanceTimersByTimeAsync(0);
  expect(times()).toEqual([0.5]);
});

it('a note of an earlier version of the page applies', async () => {
  const { store, edit } = visit();
  await edit(0);
  const { version } = shelf.get('mine')!;
  const state = { ...store.get(), time: 0.5 };
  settings.set('shapespline.last-state', JSON.stringify({ id: 'mine', version, poses: 0, state }));
  expect((await opened()).store.get().time).toBe(0.5);
});
