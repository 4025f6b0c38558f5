/**
 * Projects stored in the browser between visits, shared by all tabs. Each is written whole, in one transaction. New
 * projects replace the oldest.
 */
import { createStore, promisifyRequest } from 'idb-keyval';
import type { Pose } from '../../engine/api/read-poses.ts';
import type { ImportOptions, InputFile, Point } from '../../engine/api/types.ts';
import type { AppState, KeyRef } from '../../model/state.ts';

/** The part of a project that changes while files are open. */
export interface Changing {
  options: ImportOptions;
  /** Poses that are not from the files: from shown shapes or added files. */
  poses: Pose[];
  /** The offset of these poses; missing in earlier versions, for none. */
  offset?: Point;
  state: AppState;
}

/** Everything needed to reopen the files in their last state. */
export interface StoredProject extends Changing {
  files: InputFile[];
}

/** A project for display in a list. */
export interface ProjectOnShelf {
  id: string;
  /** File names. */
  names: readonly string[];
  /** Time of the last change, or of opening, in milliseconds since 1970. */
  changed: number;
  /** The last attempt to open it failed or did not finish. */
  opening: boolean;
}

interface ProjectRecord extends Changing {
  format: typeof FORMAT;
  id: string;
  opening: boolean;
  changed: number;
  /** Differs for every write, so a tab notices writes of other tabs. */
  version: number;
}

export interface Shelf {
  /** The projects, sorted by last change, newest first. */
  projects: ProjectOnShelf[];
  /** Number of unreadable projects that were set aside. */
  setAside: number;
}

/** Increment the format when older projects become unreadable. */
const FORMAT = 3;
const PROJECT = 'project ';
/** Files have a separate record, because they can be large and do not change. Its key contains the project's id. */
const FILES = 'files ';
const SET_ASIDE = 'set aside ';
const KEPT_PROJECTS = 6;

let shelf = createStore('shapespline', 'remembered');
const whenDeleted: (() => void)[] = [];

/** Calls `listener` when another tab has deleted all projects. */
export function onDeleted(listener: () => void): void {
  whenDeleted.push(listener);
}

/** Another tab deletes the storage or needs a newer version of it. It waits until this connection is closed. */
function giveWay(this: IDBDatabase, { newVersion }: IDBVersionChangeEvent): void {
  this.close();
  shelf = createStore('shapespline', 'remembered');
  if (newVersion === null) for (const listener of whenDeleted) listener();
}

const stored = (store: IDBObjectStore, key: string): Promise<unknown> => promisifyRequest<unknown>(store.get(key));

const projectOn = async (store: IDBObjectStore, id: string): Promise<ProjectRecord | undefined> =>
  (await stored(store, PROJECT + id)) as ProjectRecord | undefined;

/** Does all of the work or none; resolves when it is on disk. */
function atomically<T>(work: (store: IDBObjectStore) => T | Promise<T>): Promise<T> {
  return shelf('readwrite', async (store) => {
    store.transaction.db.onversionchange = giveWay;
    const written = promisifyRequest<void>(store.transaction as never);
    // The transaction may fail while the work is waiting; then the work fails too.
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
    // The transaction has already ended.
  }
}

/**
 * Writes a project with its files and resolves to its version; null if another tab has written since `known`. Removes
 * the oldest project if there are too many.
 */
export function keepProject(
  id: string,
  { files, ...changing }: StoredProject,
  known: number | null,
): Promise<number | null> {
  return atomically(async (store) => {
    const before = (await projectOn(store, id))?.version;
    if (before !== undefined && before !== known) return null;
    // Differs from all versions of a project that was removed and is written again.
    const version = (before ?? Date.now()) + 1;
    store.put(recordOf(id, version, changing), PROJECT + id);
    store.put(files, FILES + id);
    const { projects } = await readAll(store);
    for (const { id: old } of projects.slice(KEPT_PROJECTS)) remove(store, old);
    return version;
  });
}

/**
 * Writes the changes of a project and resolves to its new version; null if it was removed, or if another tab has
 * written since `version`.
 */
export function updateProject(id: string, version: number, changing: Changing): Promise<number | null> {
  return atomically(async (store) => {
    if ((await projectOn(store, id))?.version !== version) return null;
    store.put(recordOf(id, version + 1, changing), PROJECT + id);
    return version + 1;
  });
}

/** Records that a visit starts to open a project, or has opened it. */
export function markOpening(id: string, opening: boolean): Promise<void> {
  return atomically(async (store) => {
    const project = await projectOn(store, id);
    if (project) store.put({ ...project, opening, changed: Date.now() }, PROJECT + id);
  });
}

export function forgetProject(id: string): Promise<void> {
  return atomically((store) => remove(store, id));
}

/** All stored projects. Moves unreadable ones to another key for recovery. */
export function readShelf(): Promise<Shelf> {
  return atomically(async (store) => {
    const { projects, broken } = await readAll(store);
    for (const key of broken) await setAside(store, key.slice(PROJECT.length));
    return { projects, setAside: broken.length };
  });
}

/** A project with its files and version; null if it was removed or set aside as unreadable. */
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

/** Moves an unreadable record to another key, to free its place and allow recovery. */
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

/** List entry of a readable record. */
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

/** Whether a record's files have their bytes. */
export function areFiles(files: unknown): files is InputFile[] {
  return isListOf(files, (file: Partial<InputFile> | null) => {
    return typeof file?.name === 'string' && file.bytes instanceof Uint8Array;
  });
}

function isListOf<T>(list: unknown, isOne: (one: T) => boolean): boolean {
  return Array.isArray(list) && list.every(isOne);
}
