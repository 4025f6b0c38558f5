/** When the user's files are stored between visits, tested with storage in memory. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { Changing, StoredProject } from '../../web/app/kept/project-shelf.ts';
import { RememberedFiles } from '../../web/app/kept/remembered-files.ts';
import { createStore } from '../../web/app/session/store.ts';
import type { Store } from '../../web/app/session/store.ts';
import type { Workspace } from '../../web/app/session/workspace.ts';
import type { AppState } from '../../web/model/state.ts';
import { EMPTY_STATE } from '../../web/model/state.ts';

const shelf = new Map<string, { remembered: StoredProject; version: number; opening: boolean }>();
const storage = {
  newProjectId: () => 'other',
  async keepProject(id: string, remembered: StoredProject) {
    shelf.set(id, { remembered, version: 1, opening: false });
    return 1;
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
  for (const kept of [shelf, settings, ofTab]) kept.clear();
  said.length = 0;
});

/** A visit with open files. */
function visit(time = 0): { store: Store; remembered: RememberedFiles } {
  const own: AppState = { ...EMPTY_STATE, source: { kind: 'files', names: ['mine'] }, project: 'mine', time };
  const store = createStore(own);
  const input = [{ name: 'mine.glb', bytes: new Uint8Array(1) }];
  const keys = { info: { names: [], offset: [0, 0, 0] } };
  const workspace = { options: {}, pool: { count: 2, imported: 2, keys }, input } as unknown as Workspace;
  const say = (text: string): void => void said.push(text);
  const onError = (error: unknown): void => void said.push(String(error));
  const remembered = new RememberedFiles({ store, workspace, say, onError, storage, onChange: () => undefined });
  store.subscribe(() => remembered.follow());
  return { store, remembered };
}
const timeOf = (id: string): number | undefined => shelf.get(id)?.remembered.state.time;

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
