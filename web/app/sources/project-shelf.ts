/**
 * The project that this browser keeps between visits: one record for all tabs, written whole in one transaction or not
 * at all.
 */
import { createStore, promisifyRequest } from 'idb-keyval';
import type { Pose } from '../../engine/api/read-poses.ts';
import type { ImportOptions, InputFile } from '../../engine/api/types.ts';
import type { AppState } from '../../model/state.ts';

/** What changes while files are open. */
export interface Changing {
  options: ImportOptions;
  /** Poses that are not of the files: taken from shapes, or from further files. */
  poses: Pose[];
  state: AppState;
}

/** Everything that opens the files again as they were left. */
export interface Remembered extends Changing {
  files: InputFile[];
}

export interface KeptProject {
  id: string;
  /** A visit began to open it and has not said that it is open. */
  opening: boolean;
  remembered: Remembered;
}

interface ProjectRecord extends Changing {
  format: typeof FORMAT;
  id: string;
  opening: boolean;
}

/** Raised when older visits can no longer be read. Format 1 lay under three keys, without an id. */
const FORMAT = 2;
const PROJECT = 'project';
/**
 * In a record of their own, as they may be large and stay the same while the rest changes; always of the project beside
 * them.
 */
const FILES = 'files';
const SET_ASIDE = 'set aside';

const shelf = createStore('shapespline', 'remembered');

const stored = (store: IDBObjectStore, key: string): Promise<unknown> => promisifyRequest<unknown>(store.get(key));

async function projectOn(store: IDBObjectStore): Promise<ProjectRecord | null> {
  const project = (await stored(store, PROJECT)) as ProjectRecord | undefined;
  return project?.format === FORMAT ? project : null;
}

/** Does all of it or nothing: resolves when it is on the disk. */
function atomically<T>(work: (store: IDBObjectStore) => T | Promise<T>): Promise<T> {
  return shelf('readwrite', async (store) => {
    const written = promisifyRequest<void>(store.transaction as never);
    try {
      const result = await work(store);
      await written;
      return result;
    } catch (error) {
      written.catch(() => undefined);
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

/**
 * Writes a project over whatever is kept, or, where `instead` is given, only over that project; resolves to whether it
 * did.
 */
export function keepProject(id: string, remembered: Remembered, instead: string | null): Promise<boolean> {
  const { files, ...changing } = remembered;
  return atomically(async (store) => {
    if (instead !== null && (await projectOn(store))?.id !== instead) return false;
    store.put({ format: FORMAT, id, opening: false, ...changing } satisfies ProjectRecord, PROJECT);
    store.put(files, FILES);
    return true;
  });
}

/** Writes what has changed of a project; false where another one, or none, is kept meanwhile. */
export function updateProject(id: string, part: Partial<Changing & { opening: boolean }>): Promise<boolean> {
  return atomically(async (store) => {
    const project = await projectOn(store);
    if (project?.id !== id) return false;
    store.put({ ...project, ...part }, PROJECT);
    return true;
  });
}

/** False where another project, or none, is kept. */
export function forgetProject(id: string): Promise<boolean> {
  return atomically(async (store) => {
    if ((await projectOn(store))?.id !== id) return false;
    store.delete(PROJECT);
    store.delete(FILES);
    return true;
  });
}

/** The kept project, or null where there is none. Fails where it does not read. */
export function readProject(): Promise<KeptProject | null> {
  return atomically(async (store) => {
    await upgrade(store);
    const [project, files] = [await stored(store, PROJECT), await stored(store, FILES)];
    if (project === undefined && files === undefined) return null;
    const { format, id, opening, ...changing } = project as ProjectRecord;
    const whole =
      format === FORMAT &&
      Array.isArray(files) &&
      Array.isArray(changing.poses) &&
      Array.isArray(changing.state?.doc?.keys);
    if (!whole) throw new Error('a kept project does not read');
    return { id, opening, remembered: { files: files as InputFile[], ...changing } };
  });
}

/** What does not read makes room, and stays for whoever may need it. */
export function setProjectAside(): Promise<void> {
  return atomically(async (store) => {
    store.put({ project: await stored(store, PROJECT), files: await stored(store, FILES) }, SET_ASIDE);
    store.delete(PROJECT);
    store.delete(FILES);
  });
}

export function newProjectId(): string {
  return Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(16).padStart(8, '0')).join('');
}

async function upgrade(store: IDBObjectStore): Promise<void> {
  if ((await stored(store, 'format')) !== 1) return;
  const changing = (await stored(store, 'rest')) as Changing | undefined;
  if (changing) store.put({ format: FORMAT, id: newProjectId(), opening: false, ...changing }, PROJECT);
  store.delete('format');
  store.delete('rest');
}
