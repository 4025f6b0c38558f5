/**
 * The projects that this browser keeps between visits, for all tabs: each written whole in one transaction or not at
 * all. Of the last ones only: older ones make room.
 */
import { createStore, promisifyRequest } from 'idb-keyval';
import type { Pose } from '../../engine/api/read-poses.ts';
import type { ImportOptions, InputFile, Point } from '../../engine/api/types.ts';
import type { AppState, KeyRef } from '../../model/state.ts';

/** What changes while files are open. */
export interface Changing {
  options: ImportOptions;
  /** Poses that are not of the files: taken from shapes, or from further files. */
  poses: Pose[];
  /** That these are relative to; absent: nothing, as in earlier versions. */
  offset?: Point;
  state: AppState;
}

/** Everything that opens the files again as they were left. */
export interface StoredProject extends Changing {
  files: InputFile[];
}

/** A project as a list shows it. */
export interface ProjectOnShelf {
  id: string;
  /** Of the files that were opened. */
  names: readonly string[];
  /** Milliseconds since 1970 of the last change, or of its opening. */
  changed: number;
  /** The last attempt to open it failed or did not end. */
  opening: boolean;
}

interface ProjectRecord extends Changing {
  format: typeof FORMAT;
  id: string;
  opening: boolean;
  changed: number;
  /** Differs for every write, so a tab notices the writes of others. */
  version: number;
}

export interface Shelf {
  /** The last changed one first. */
  projects: ProjectOnShelf[];
  /** How many did not read, and were set aside. */
  setAside: number;
}

/** Raised when older visits can no longer be read. Format 1 and 2 held one project, under keys without an id. */
const FORMAT = 3;
const PROJECT = 'project ';
/**
 * In a record of their own, as they may be large and stay the same while the rest changes; always of the project of the
 * same id.
 */
const FILES = 'files ';
const SET_ASIDE = 'set aside ';
const KEPT_PROJECTS = 6;

const shelf = createStore('shapespline', 'remembered');

const stored = (store: IDBObjectStore, key: string): Promise<unknown> => promisifyRequest<unknown>(store.get(key));

const projectOn = async (store: IDBObjectStore, id: string): Promise<ProjectRecord | undefined> =>
  (await stored(store, PROJECT + id)) as ProjectRecord | undefined;

/** Does all of it or nothing: resolves when it is on the disk. */
function atomically<T>(work: (store: IDBObjectStore) => T | Promise<T>): Promise<T> {
  return shelf('readwrite', async (store) => {
    const written = promisifyRequest<void>(store.transaction as never);
    // It may fail while the work still waits for something else, which fails then, too.
    written.catch(() => undefined);
    try {
      const result = await work(store);
      await written;
      return result;
    } catch (error) {
      abort(store.transaction);
      throw error;
    }
  });
}

function abort(transaction: IDBTransaction): void {
  try {
    transaction.abort();
  } catch {
    // It has ended already.
  }
}

/** Writes a project, its files included, and resolves to its version; the oldest of too many goes. */
export function keepProject(id: string, { files, ...changing }: StoredProject): Promise<number> {
  return atomically(async (store) => {
    const version = ((await projectOn(store, id))?.version ?? 0) + 1;
    store.put(recordOf(id, version, changing), PROJECT + id);
    store.put(files, FILES + id);
    const { projects } = await readAll(store);
    for (const { id: old } of projects.slice(KEPT_PROJECTS)) remove(store, old);
    return version;
  });
}

/**
 * Writes what has changed of a project and resolves to its new version; null where it is kept no longer, or another tab
 * has written since `version`.
 */
export function updateProject(id: string, version: number, changing: Changing): Promise<number | null> {
  return atomically(async (store) => {
    if ((await projectOn(store, id))?.version !== version) return null;
    store.put(recordOf(id, version + 1, changing), PROJECT + id);
    return version + 1;
  });
}

/** Says that a visit begins to open a project, or has opened it. */
export function markOpening(id: string, opening: boolean): Promise<void> {
  return atomically(async (store) => {
    const project = await projectOn(store, id);
    if (project) store.put({ ...project, opening, changed: Date.now() }, PROJECT + id);
  });
}

export function forgetProject(id: string): Promise<void> {
  return atomically((store) => remove(store, id));
}

/** Stored content. Unreadable content moves to another key, where it stays for recovery. */
export function readShelf(): Promise<Shelf> {
  return atomically(async (store) => {
    await upgrade(store);
    const { projects, broken } = await readAll(store);
    for (const key of broken) await setAside(store, key.slice(PROJECT.length));
    return { projects, setAside: broken.length };
  });
}

/** A project with its files and its version, or null where it is kept no longer, or was set aside as unreadable. */
export function readProject(id: string): Promise<{ remembered: StoredProject; version: number } | null> {
  return atomically(async (store) => {
    const [project, files] = [await projectOn(store, id), await stored(store, FILES + id)];
    if (!project || !files) return null;
    if (!readRecord(project) || !areFiles(files)) {
      await setAside(store, id);
      return null;
    }
    const { options, poses, offset, state, version } = project;
    return { remembered: { files, options, poses, ...(offset && { offset }), state }, version };
  });
}

/** Makes room for what can be opened, and keeps the record for those who may need it. */
async function setAside(store: IDBObjectStore, id: string): Promise<void> {
  store.put({ project: await stored(store, PROJECT + id), files: await stored(store, FILES + id) }, SET_ASIDE + id);
  remove(store, id);
}

export function newProjectId(): string {
  return Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(16).padStart(8, '0')).join('');
}

function recordOf(id: string, version: number, changing: Changing): ProjectRecord {
  return { ...changing, format: FORMAT, id, version, opening: false, changed: Date.now() };
}

function remove(store: IDBObjectStore, id: string): void {
  store.delete(PROJECT + id);
  store.delete(FILES + id);
}

async function readAll(store: IDBObjectStore): Promise<{ projects: ProjectOnShelf[]; broken: string[] }> {
  const projects: ProjectOnShelf[] = [];
  const broken: string[] = [];
  const all = await promisifyRequest(store.getAllKeys());
  const keys = new Set(all.filter((key) => typeof key === 'string'));
  for (const key of keys) {
    if (!key.startsWith(PROJECT)) continue;
    const project = readRecord(await stored(store, key));
    if (project && PROJECT + project.id === key && keys.has(FILES + project.id)) projects.push(project);
    else broken.push(key);
  }
  return { projects: projects.sort((a, b) => b.changed - a.changed), broken };
}

/** What stands in a record that could be opened. */
export function readRecord(record: unknown): ProjectOnShelf | null {
  const { format, id, opening, changed, options, poses, offset, state } = (record ?? {}) as Partial<ProjectRecord>;
  const source: Partial<AppState['source'] & { names: unknown }> = state?.source ?? {};
  const { names } = source;
  const isPose = (pose: Partial<Pose> | null): boolean =>
    typeof pose?.name === 'string' && pose.positions instanceof Float32Array;
  const isKey = (key: Partial<KeyRef> | null): boolean =>
    Number.isInteger(key?.pose) && Number.isFinite(key?.time) && typeof key?.name === 'string';
  const whole =
    format === FORMAT &&
    typeof id === 'string' &&
    isListOf(poses, isPose) &&
    (offset === undefined || isListOf(offset, Number.isFinite)) &&
    isListOf(state?.doc?.keys, isKey) &&
    source.kind === 'files' &&
    isListOf(names, (name: unknown) => typeof name === 'string') &&
    [options, state?.view, state?.play].every((part) => part === undefined || typeof part === 'object');
  if (!whole) return null;
  return { id, names: names as string[], changed: Number(changed) || 0, opening: opening === true };
}

/** Of the files of a record: with their bytes. */
export function areFiles(files: unknown): files is InputFile[] {
  return isListOf(files, (file: Partial<InputFile> | null) => {
    return typeof file?.name === 'string' && file.bytes instanceof Uint8Array;
  });
}

function isListOf<T>(list: unknown, isOne: (one: T) => boolean): boolean {
  return Array.isArray(list) && list.every(isOne);
}

/** Format 1 had `rest` and `files`, format 2 `project` and `files`. */
async function upgrade(store: IDBObjectStore): Promise<void> {
  const files = await stored(store, 'files');
  const [rest, project] = [await stored(store, 'rest'), await stored(store, 'project')];
  const old = (project ?? rest) as (Changing & { format?: number; opening?: boolean }) | undefined;
  if (old === undefined && files === undefined) return;
  const readable = project === undefined || old?.format === 2;
  const record = { ...old, ...(readable ? { format: FORMAT } : {}) };
  const id = newProjectId();
  store.put({ opening: false, version: 1, changed: Date.now(), ...record, id }, PROJECT + id);
  if (files !== undefined) store.put(files, FILES + id);
  for (const key of ['format', 'rest', 'project', 'files']) store.delete(key);
}
